#!/usr/bin/env python3
"""What `skylut table` does when the request is right. Coarse wavelengths keep the runs short."""

import csv
import json
import os
import signal
import subprocess
import time
import unittest

from expect import Workplace

COARSE = ["--wavelengths-nm", "400:700:50", "--quality", "draft"]
COLUMNS = (["altitude_km", "turbidity", "sun_zenith_deg", "sun_azimuth_deg"]
           + [f"{name}_{channel}" for channel in "Yxy" for name in "ABCDE"]
           + ["Y_zenith_kcd_m2", "x_zenith", "y_zenith", "rmse_Y_rel", "rmse_x", "rmse_y"]
           + ["rmse_horizon_Y_rel", "rmse_horizon_x", "rmse_horizon_y"]
           + [f"worst_{name}" for channel, first in (("Y", "Y_rel"), ("x", "x"), ("y", "y"))
              for name in (first, f"{channel}_zenith_deg", f"{channel}_azimuth_deg")]
           + ["horizon_zenith_deg", "Y_below_90_kcd_m2", "light_below_90"]
           + [f"{flag}_{channel}" for flag in ("undetermined", "at_bound") for channel in "Yxy"])


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


class Table(unittest.TestCase):
    """One table of 2 altitudes, 2 turbidities and 3 suns, made once."""

    ARGUMENTS = ["--altitudes-km", "0,12", "--turbidities", "0,0.3", "--suns", "60:90,60:270,20:0", *COARSE]

    @classmethod
    def setUpClass(cls):
        cls.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        cls.screen = cls.work.succeed("table", "--out", "out/one", "--threads", "1", "--save-maps", *cls.ARGUMENTS)
        cls.rows = rows_of(cls.work.path("out/one/table.csv"))

    @classmethod
    def tearDownClass(cls):
        cls.work.__exit__()

    def test_columns_are_those_of_the_guide(self):
        self.assertEqual(list(self.rows[0]), COLUMNS)

    def test_rows_run_over_altitude_then_turbidity_then_sun(self):
        keys = [(row["altitude_km"], row["turbidity"], row["sun_zenith_deg"], row["sun_azimuth_deg"])
                for row in self.rows]
        self.assertEqual(keys, [(altitude, turbidity, zenith, azimuth)
                                for altitude in ("0", "12") for turbidity in ("0", "0.3")
                                for zenith, azimuth in (("60", "90"), ("60", "270"), ("20", "0"))])

    def test_mirror_suns_have_the_same_coefficients(self):
        # Only where the worst directions lie turns with the sun.
        names = [name for name in COLUMNS[4:] if not name.endswith("_azimuth_deg")]
        for east, west in zip(self.rows[0::3], self.rows[1::3]):
            self.assertEqual([east[name] for name in names], [west[name] for name in names])
            turned = (float(west["worst_Y_azimuth_deg"]) - float(east["worst_Y_azimuth_deg"])) % 360
            self.assertIn(turned, (0, 180))

    def test_the_zenith_darkens_with_altitude(self):
        for low, high in zip(self.rows[:6], self.rows[6:]):
            self.assertGreater(float(low["Y_zenith_kcd_m2"]), float(high["Y_zenith_kcd_m2"]))

    def test_every_B_is_negative(self):
        for row in self.rows:
            for channel in "Yxy":
                self.assertLess(float(row[f"B_{channel}"]), 0)

    def test_two_threads_write_the_same_bytes(self):
        self.work.succeed("table", "--out", "out/two", "--threads", "2", "--save-maps", *self.ARGUMENTS)
        one = {name[len("out/one"):]: data for name, data in self.work.contents().items()
               if name.startswith("out/one/")}
        two = {name[len("out/two"):]: data for name, data in self.work.contents().items()
               if name.startswith("out/two/")}
        self.assertEqual(one.keys(), two.keys())
        for name, data in one.items():
            self.assertTrue(data == two[name], name)

    def test_the_reports_recipe_fits_every_row_alone(self):
        # Its 271 directions, all alike; then a row does not depend on the others, and skylut fit makes it of the map.
        report = ["--directions", "utm271", "--altitudes-km", "0,12", "--turbidities", "0.3", *COARSE]
        self.work.succeed("table", "--out", "out/report", "--save-maps", "--suns", "60:270,20:0", *report)
        rows = rows_of(self.work.path("out/report/table.csv"))
        self.work.succeed("table", "--out", "out/alone", "--suns", "60:270", *report)
        alone = rows_of(self.work.path("out/alone/table.csv"))
        self.assertEqual(alone, [rows[0], rows[2]])
        for row in (1, 4):
            name = f"fit_{row}.json"
            self.work.succeed("fit", f"out/report/maps/entry_{row:03}.csv", "-o", name)
            found = json.loads(self.work.path(name).read_text(encoding="utf-8"))
            for channel in "Yxy":
                for letter in "ABCDE":
                    # The map's numbers read back exactly; angles go through degrees once more, which moves the
                    # coefficients by rounding.
                    expected = float(rows[row - 1][f"{letter}_{channel}"])
                    self.assertAlmostEqual(found[channel]["coefficients"][letter] / expected, 1, places=5)

    def test_json_says_what_was_fitted_together(self):
        report = json.loads(self.work.path("out/one/table.json").read_text(encoding="utf-8"))
        self.assertEqual(report["fitted_together"], "all 2 altitudes x 2 turbidities x 2 sun zenith angles together")
        self.assertEqual(report["inputs"]["weights"], "horizon")
        self.assertEqual(report["inputs"]["directions"]["name"], "dome")
        for entry in report["rows"]:
            for channel in "Yxy":
                self.assertEqual(entry[channel]["termination"], "converged")

    def test_light_below_90_is_there_aloft(self):
        for low, high in zip(self.rows[:6], self.rows[6:]):
            self.assertEqual((low["Y_below_90_kcd_m2"], low["light_below_90"]), ("0", "0"))
            self.assertGreater(float(high["Y_below_90_kcd_m2"]), float(high["Y_zenith_kcd_m2"]))
            self.assertTrue(0 < float(high["light_below_90"]) < 0.5)

    def test_to_horizon_stretches_the_formula(self):
        self.work.succeed("table", "--out", "out/horizon", "--to-horizon", "--altitudes-km", "0,12",
                          "--turbidities", "0.3", "--suns", "60:90", *COARSE)
        low, high = rows_of(self.work.path("out/horizon/table.csv"))
        self.assertEqual(low["horizon_zenith_deg"], "90")
        self.assertAlmostEqual(float(high["horizon_zenith_deg"]), 93.5, delta=0.1)
        self.assertGreater(float(high["worst_Y_zenith_deg"]), 0)

    def test_json_says_how_to_make_it_again(self):
        report = json.loads(self.work.path("out/one/table.json").read_text(encoding="utf-8"))
        self.assertEqual(len(report["rows"]), 12)
        command = report["command"].split()
        self.assertEqual(command[0], "skylut")
        self.work.succeed(*command[1:], "--out", "out/again")
        self.assertTrue(self.work.path("out/again/table.csv").read_bytes()
                        == self.work.path("out/one/table.csv").read_bytes())

    def test_json_and_csv_hold_the_same_numbers(self):
        report = json.loads(self.work.path("out/one/table.json").read_text(encoding="utf-8"))
        for row, entry in zip(self.rows, report["rows"]):
            for channel in "Yxy":
                for name in "ABCDE":
                    self.assertEqual(float(row[f"{name}_{channel}"]), entry[channel]["coefficients"][name])

    def test_maps_are_numbered_as_the_rows(self):
        maps = sorted(path.name for path in self.work.path("out/one/maps").iterdir())
        self.assertEqual(maps, [f"entry_{row:03}.csv" for row in range(1, 13)])
        lines = self.work.path("out/one/maps/entry_011.csv").read_text(encoding="utf-8").splitlines()
        self.assertIn("# altitude_km=12", lines)
        self.assertIn("# turbidity=0.3", lines)
        self.assertIn("# sun_azimuth_deg=270", lines)
        sky = rows_of(self.work.path("out/one/maps/entry_011.csv"))
        self.assertEqual(len(sky), 271)
        self.assertEqual(list(sky[0])[:7], ["zenith_deg", "azimuth_deg", "gamma_deg", "Y_cd_m2", "x", "y", "L_400"])
        # The first direction is the zenith, whose colour the table holds from its smooth dome.
        self.assertAlmostEqual(float(sky[0]["Y_cd_m2"]) / (1000 * float(self.rows[10]["Y_zenith_kcd_m2"])), 1, delta=1e-3)

    def test_the_screen_shows_every_row_and_all_turbidities(self):
        self.assertIn("12 rows", self.screen)
        self.assertIn("preetham-t", self.screen)
        self.assertIn("wrote out/one/table.csv", self.screen)


class Interrupted(unittest.TestCase):
    def test_leaves_no_file(self):
        """SIGTERM during the computation: exit code 143, nothing written."""
        with Workplace(os.environ["SKYLUT_PROGRAM"]) as work:
            with subprocess.Popen([work.program, "table", "--out", "out"], cwd=work.folder, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) as program:
                time.sleep(0.3)
                program.send_signal(signal.SIGTERM)
                self.assertEqual(program.wait(timeout=60), 143)
            self.assertEqual(work.contents(), {})


if __name__ == "__main__":
    unittest.main()
