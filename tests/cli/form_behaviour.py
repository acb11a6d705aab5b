#!/usr/bin/env python3
"""What `skylut fit INPUT --form NAME` does with maps and tables: the same air, the same bytes, clear refusals."""

import json
import os
import unittest

from expect import Workplace

COARSE = ["--wavelengths-nm", "400:700:50", "--quality", "draft"]
AIR = ["--ozone-du", "250", "--albedo", "grass", "--aerosol", "preetham", "--height-m", "800", "--latitude", "45",
       "--solar", "sun's.csv"]
SUN = "wavelength_nm,irradiance_W_m2_nm\n300,1.0\n1000,0.7\n"


class Form(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)
        self.work.write("sun's.csv", SUN)

    def refused(self, *arguments):
        """The one line of a request that is wrong."""
        before = self.work.contents()
        result = self.work.run(*arguments)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertEqual(self.work.contents(), before)
        return result.stderr

    def make_table(self, *more):
        self.work.succeed("table", "--out", "my table", "--altitudes-km", "0", "--turbidities", "0.2", "--suns",
                          "40:120,55:120", *COARSE, *AIR, *more)

    def model(self, path):
        return json.loads(self.work.path(path).read_text())

    def test_a_table_stands_for_its_air(self):
        self.make_table("--save-maps")
        table = self.model("my table/table.json")
        self.work.succeed("fit", "my table", "--form", "perez", "-o", "model.json")
        model = self.model("model.json")
        for name in ("profile", "air", "wavelengths_nm", "solar", "suns", "quality"):
            self.assertEqual(model["inputs"][name], table["inputs"][name], name)
        # The zenith of a row is the table's own sky, through the same air; grass is green in both.
        row, known = model["model"]["rows"][1], table["rows"][1]
        self.assertEqual(row["sun_zenith_deg"], 55)
        self.assertAlmostEqual(row["zenith"][0] / (1000 * known["zenith"]["Y"]), 1, delta=3e-3)
        self.assertAlmostEqual(row["zenith"][1], known["zenith"]["x"], delta=3e-4)
        self.assertEqual(model["domain"]["sun_zenith_deg"], [40, 55])
        # Its maps are skies, too: lines of sight, from which the rows' smooth domes differ by some 1e-4.
        self.work.succeed("fit", "my table/maps", "--form", "perez", "-o", "maps.json")
        zenith = self.model("maps.json")["model"]["rows"][1]["zenith"]
        self.assertAlmostEqual(zenith[0] / (1000 * known["zenith"]["Y"]), 1, delta=1e-3)
        # The same command makes the same bytes, on any number of threads.
        bytes_before = self.work.path("model.json").read_bytes()
        self.work.succeed("fit", "my table", "--form", "perez", "-o", "model.json", "--threads", "1")
        self.assertEqual(self.work.path("model.json").read_bytes(), bytes_before)

    def test_a_table_whose_files_changed_is_refused(self):
        self.make_table()
        self.work.write("sun's.csv", SUN.replace("0.7", "0.6"))
        self.assertRegex(self.refused("fit", "my table", "--form", "perez", "-o", "m.json"),
                         "my table/table.json: its command now gives another sun's.csv")
        self.work.path("sun's.csv").unlink()
        self.assertRegex(self.refused("fit", "my table", "--form", "perez", "-o", "m.json"),
                         "my table: its command cannot be run again: sun's.csv: cannot read")
        table = self.model("my table/table.json")
        self.work.write("sun's.csv", SUN)
        table["inputs"]["air"]["planet_radius_km"] = 6000.0
        self.work.write("my table/table.json", json.dumps(table))
        self.assertRegex(self.refused("fit", "my table", "--form", "perez", "-o", "m.json"),
                         "my table/table.json: its command now gives another air")
        table["command"] += " --no-such-option 3"
        self.work.write("my table/table.json", json.dumps(table))
        self.assertRegex(self.refused("fit", "my table", "--form", "perez", "-o", "m.json"),
                         "cannot be run again: --no-such-option")

    def test_maps_that_do_not_suffice_are_refused(self):
        self.work.succeed("map", "-o", "sky.csv", "--sun-zenith-deg", "40", *COARSE)
        self.assertRegex(self.refused("fit", "sky.csv", "--form", "hosek-wilkie", "-o", "m.json"),
                         "sky.csv: the form needs skies of its own choice.*must be a table folder")
        self.work.succeed("fit", "sky.csv", "--form", "perez-spectral", "--bands-nm", "400:700:100", "-o", "m.json")
        model = self.model("m.json")
        self.assertEqual(len(model["model"]["rows"][0]["ABCDE"]), 4)
        self.assertLess(model["error"]["fitted"]["rms_x"]["worst"], 0.005)

    def test_wrong_requests(self):
        self.work.succeed("map", "-o", "sky.csv", "--sun-zenith-deg", "40", *COARSE)
        for arguments, wrong in [
                (["--form", "hosek-wilky", "-o", "m.json"], "did you mean hosek-wilkie"),
                (["--form", "perez"], "needs -o MODEL.json"),
                (["--form", "perez", "--json", "-o", "m.json"], "--json: must not be given with --form"),
                (["--form", "perez", "--grid", "runtim", "-o", "m.json"], "did you mean runtime"),
                (["--form", "perez", "--grid", "runtime", "-o", "m.json"], "--grid: .*must be a table folder"),
                (["--grid", "runtime"], "--grid: is for --form NAME"),
                (["--form", "preetham", "--albedos", "0,1", "-o", "m.json"],
                 "--albedos: changes nothing of form preetham: is for hosek-wilkie"),
                (["--form", "perez", "--bands-nm", "400:700:100", "-o", "m.json"], "--bands-nm: .*perez-spectral"),
                (["--form", "perez", "--spectral", "-o", "m.json"], "--spectral: .*hosek-wilkie or skylut"),
                (["--form", "hosek-wilkie", "--error", "0.01", "-o", "m.json"], "--error: .*is for skylut"),
                (["--form", "hosek-wilkie", "--bands-nm", "400:700:100", "-o", "m.json"], "needs --spectral"),
                (["--form", "hosek-wilkie", "--albedos", "0,0", "-o", "m.json"], "--albedos: must not hold a value twice"),
                (["--form", "hosek-wilkie", "--albedos", "0,1.5", "-o", "m.json"], "within 0 to 1")]:
            self.assertRegex(self.refused("fit", "sky.csv", *arguments), wrong)


if __name__ == "__main__":
    unittest.main()
