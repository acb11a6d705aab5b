#!/usr/bin/env python3
"""What `skylut eval` does when the request is right."""

import csv
import json
import math
import os
import unittest

from expect import Workplace

COARSE = ["--wavelengths-nm", "400:700:50", "--quality", "draft"]


def number_or_text(value):
    try:
        return float(value)
    except ValueError:
        return value


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [{name: number_or_text(value) for name, value in row.items()}
                for row in csv.DictReader(line for line in file if not line.startswith("#"))]


def provenance_of(path):
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("# provenance: "):
            return json.loads(line[len("# provenance: "):])
    return None


def perez(row, channel, theta, gamma):
    A, B, C, D, E = (row[f"{name}_{channel}"] for name in "ABCDE")
    gradation = math.exp(B / math.cos(theta)) if math.cos(theta) > 1e-12 else 0.0
    return (1 + A * gradation) * (1 + C * math.exp(D * gamma) + E * math.cos(gamma) ** 2)


class Eval(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        cls.addClassCleanup(cls.work.__exit__)
        cls.work.succeed("table", "--out", "out", "--altitudes-km", "0,2,6,12", "--turbidities", "0.1,0.4",
                         "--suns", "40:90,60:90", *COARSE)

    def eval(self, source, *arguments, warning=None):
        return self.work.succeed("eval", source, *arguments, warning=warning)

    def sky(self, source, *arguments, warning=None):
        self.eval(source, "-o", "sky.csv", *arguments, warning=warning)
        return rows_of(self.work.path("sky.csv"))

    def test_at_a_row_it_is_the_rows_formula(self):
        sky = self.sky("out", "--altitude-km", "6", "--turbidity", "0.4", "--sun-zenith-deg", "60",
                       "--sun-azimuth-deg", "200")
        row = next(row for row in rows_of(self.work.path("out/table.csv"))
                   if (row["altitude_km"], row["turbidity"], row["sun_zenith_deg"]) == (6, 0.4, 60))
        self.assertEqual(len(sky), 271)
        sun = math.radians(60)
        for view in sky:
            theta, gamma = math.radians(view["zenith_deg"]), math.radians(view["gamma_deg"])
            for channel, column, zenith in (("Y", "Y_cd_m2", 1000 * row["Y_zenith_kcd_m2"]), ("x", "x", row["x_zenith"]),
                                            ("y", "y", row["y_zenith"])):
                expected = zenith * perez(row, channel, theta, gamma) / perez(row, channel, 0, sun)
                self.assertAlmostEqual(view[column] / expected, 1, delta=1e-6)
        how = provenance_of(self.work.path("sky.csv"))
        self.assertTrue(how["inputs"]["interpolation"]["at_a_row"])
        self.assertEqual({os.path.basename(source["file"]) for source in how["sources"]}, {"table.csv", "table.json"})

    def test_between_rows_it_is_between_them(self):
        no_error = "states no error between its rows"
        fields = ["--turbidity", "0.4", "--sun-zenith-deg", "60"]
        low, high = (self.sky("out", "--altitude-km", km, *fields) for km in ("2", "6"))
        between = self.sky("out", "--altitude-km", "3", *fields, warning=no_error)
        for a, b, c in zip(low, high, between):
            self.assertAlmostEqual(c["Y_cd_m2"], a["Y_cd_m2"] ** 0.75 * b["Y_cd_m2"] ** 0.25, delta=1e-6 * c["Y_cd_m2"])
        cubic = self.sky("out", "--altitude-km", "3", *fields, "--interpolation", "utm2005", warning=no_error)
        skies = [self.sky("out", "--altitude-km", km, *fields) for km in ("0", "2", "6", "12")]
        weights = [-0.1875, 1.0125, 0.1875, -0.0125]  # of Lagrange at 3 km
        for i, view in enumerate(cubic):
            expected = sum(weight * sky[i]["Y_cd_m2"] for weight, sky in zip(weights, skies))
            self.assertAlmostEqual(view["Y_cd_m2"], expected, delta=1e-6 * abs(expected))

    def test_a_runtime_table_states_its_error_and_eval_carries_it(self):
        screen = self.work.succeed("table", "--out", "runtime", "--grid", "runtime", "--altitudes-km", "1",
                                   "--turbidities", "0.1", "--suns", "40:180,60:180", *COARSE)
        self.assertIn("between its rows, sun up, 5 skies: rms of Y median", screen)
        stated = json.loads(self.work.path("runtime/table.json").read_text())["between_nodes"]
        self.assertNotIn("sun_below_horizon", stated)
        of_table, alone = (stated["sun_up"][of]["Y"] for of in ("table", "row_alone"))
        self.assertLess(alone["median"], 0.2)
        self.assertLess(of_table["median"], 1.2 * alone["median"] + 0.05)
        self.sky("runtime", "--altitude-km", "1", "--sun-zenith-deg", "50")  # no warning
        self.assertEqual(provenance_of(self.work.path("sky.csv"))["inputs"]["interpolation"]["between_nodes"], stated)

    def test_the_grid_of_preetham_is_in_his_turbidity(self):
        self.work.succeed("table", "--out", "preetham", "--grid", "preetham", "--suns", "45:180", *COARSE)
        rows = rows_of(self.work.path("preetham/table.csv"))
        self.assertEqual([row["turbidity"] for row in rows], [2, 3, 4, 5, 6])
        listed = json.loads(self.work.path("preetham/table.json").read_text())["inputs"]["turbidities"]
        self.assertEqual({one["kind"] for one in listed}, {"preetham-t"})
        self.sky("preetham", "--turbidity", "3", "--sun-zenith-deg", "45")

    def test_turbidities_of_other_kinds_are_the_tables(self):
        listed = json.loads(self.work.path("out/table.json").read_text())["inputs"]["turbidities"]
        own = self.sky("out", "--turbidity", "0.4", "--sun-zenith-deg", "60")
        other = self.sky("out", "--turbidity", repr(listed[1]["preetham-t"]), "--turbidity-kind", "preetham-t",
                         "--sun-zenith-deg", "60")
        self.assertEqual(own, other)

    def test_the_tables_own_albedo_is_not_refused(self):
        self.sky("out", "--turbidity", "0.4", "--sun-zenith-deg", "60", "--albedo", "0.2")
        wrong = self.work.run("eval", "out", "-o", "no.csv", "--turbidity", "0.4", "--sun-zenith-deg", "60",
                              "--albedo", "0.3")
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("of albedo 0.2", wrong.stderr)
        self.assertFalse(self.work.path("no.csv").exists())

    def test_extrapolation_is_said(self):
        sky = self.sky("out", "--altitude-km", "20", "--turbidity", "0.4", "--sun-zenith-deg", "60", "--extrapolate",
                       warning="extrapolated: altitude 20 km")
        self.assertEqual(provenance_of(self.work.path("sky.csv"))["inputs"]["extrapolated"],
                         ["altitude 20 km (0 to 12 km)"])
        edge = self.sky("out", "--altitude-km", "12", "--turbidity", "0.4", "--sun-zenith-deg", "60")
        for a, b in zip(sky, edge):
            self.assertAlmostEqual(a["Y_cd_m2"], b["Y_cd_m2"], delta=1e-6 * b["Y_cd_m2"])
        self.assertEqual(provenance_of(self.work.path("sky.csv"))["inputs"]["extrapolated"], [])

    def test_the_recorded_command_makes_the_same_file(self):
        self.sky("preetham1999", "--turbidity", "3", "--sun-zenith-deg", "60")
        first = self.work.path("sky.csv").read_bytes()
        command = provenance_of(self.work.path("sky.csv"))["command"].split()
        self.work.succeed(*command[1:], "-o", "again.csv")
        self.assertEqual(self.work.path("again.csv").read_bytes(), first)

    def test_pictures_do_not_depend_on_the_threads(self):
        fields = ["--turbidity", "3", "--sun-zenith-deg", "60", "--size", "32", "--channels", "rgb,luminance"]
        for threads in ("1", "4"):
            self.eval("preetham1999", "-o", f"p{threads}.exr", "--preview", f"p{threads}.png", *fields, "--threads",
                      threads)
        for name in ("_rgb.exr", "_luminance.exr", ".png"):
            self.assertEqual(self.work.path("p1" + name).read_bytes(), self.work.path("p4" + name).read_bytes())

    def test_the_sun_by_place_and_time(self):
        self.eval("preetham1999", "-o", "sky.csv", "--turbidity", "3", "--latitude", "48:51N", "--longitude", "2:21E",
                  "--time", "2024-06-21T09:00Z")
        conditions = provenance_of(self.work.path("sky.csv"))["inputs"]["conditions"]
        self.assertEqual(conditions["time"], "2024-06-21T09:00:00Z")
        self.assertAlmostEqual(conditions["sun_zenith_deg"], 42.2, delta=0.2)  # by hand

    def test_skylut_fit_takes_it_back(self):
        """The sky of a Perez model is fitted exactly."""
        self.sky("preetham1999", "--turbidity", "3", "--sun-zenith-deg", "60")
        report = json.loads(self.work.succeed("fit", "sky.csv", "--json"))
        self.assertLess(json.dumps(report).count("null"), 1)


if __name__ == "__main__":
    unittest.main()
