#!/usr/bin/env python3
"""What `skylut fit`, `skylut solve` and `skylut map` say beside their results."""

import csv
import json
import os
import pathlib
import unittest

from expect import Workplace

CASES = pathlib.Path(__file__).parent.parent / "data" / "solver_cases"
COARSE = ["--wavelengths-nm", "400:700:50", "--quality", "draft"]


class Solve(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)

    def test_a_summary_goes_to_the_screen_and_json_to_the_file(self):
        case = str(CASES / "sph_B_sza60_alt00.json")
        screen = self.work.succeed("solve", case, "--quality", "draft", "-o", "solved.json")
        solved = json.loads(self.work.path("solved.json").read_text(encoding="utf-8"))
        rows = [line.split() for line in screen.splitlines() if line.count("e-") >= 1]
        self.assertEqual(len(rows), len(solved["results"]))
        for row, result in zip(rows, solved["results"]):
            self.assertAlmostEqual(float(row[2]) / result["radiance"], 1, places=6)
        again = json.loads(self.work.succeed("solve", case, "--quality", "draft", "-o", "-"))
        self.assertEqual(solved, again)

    def test_every_schema_has_a_summary(self):
        self.assertIn("flux: direct", self.work.succeed("solve", str(CASES / "pp_E_multilayer_sza45_ground.json")))
        self.assertRegex(self.work.succeed("solve", str(CASES / "disort_3a.json")), r"48 streams\n +tau +cos view")

    def test_polarised_cases_have_i_q_and_u(self):
        case = CASES / "pol_natraj2009_sza78_ground.json"
        screen = self.work.succeed("solve", str(case), "-o", "solved.json")
        self.assertRegex(screen, r"I/sr-1 +Q +U")
        solved = json.loads(self.work.path("solved.json").read_text(encoding="utf-8"))
        for ours, published in zip(solved["results"], json.loads(case.read_text(encoding="utf-8"))["results"]):
            for key in ("radiance", "stokes_q", "stokes_u"):
                self.assertAlmostEqual(ours[key], published[key], delta=1e-6 * published["radiance"])
            self.assertEqual((ours["std_q"], ours["std_u"]), (0, 0))

    def test_many_views_are_cut_short(self):
        case = json.loads((CASES / "sph_B_sza60_alt00.json").read_text(encoding="utf-8"))
        case["results"] = [{"view_zenith_deg": i % 80, "relative_azimuth_deg": i % 180} for i in range(500)]
        self.work.write("many.json", json.dumps(case))
        screen = self.work.succeed("solve", "many.json", "--quality", "draft")
        self.assertLess(len(screen.splitlines()), 50)
        self.assertIn("... and 460 more", screen)

    def test_limits_may_be_given_together_or_apart(self):
        case = str(CASES / "sph_B_sza60_alt00.json")
        one = self.work.succeed("solve", case, "--limit", "tolerance=1e-5,ray-step-km=5", "-o", "-")
        two = self.work.succeed("solve", case, "--limit", "tolerance=1e-5", "--limit", "ray-step-km=5", "-o", "-")
        self.assertEqual(one, two)


class Fit(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)
        self.work.succeed("map", "-o", "sky.csv", "--sun-zenith-deg", "45", "--sun-azimuth-deg", "90", *COARSE)

    def test_another_sun_than_the_files_is_said(self):
        self.work.succeed("fit", "sky.csv", "--sun-zenith-deg", "48", "--json",
                          warning="--sun-zenith-deg 48: used instead of sun_zenith_deg 45 of sky.csv")
        self.work.succeed("fit", "sky.csv", "--sun-azimuth-deg", "-80",
                          warning="--sun-azimuth-deg 280: used instead of sun_azimuth_deg 90 of sky.csv")

    def test_the_same_sun_is_not(self):
        self.work.succeed("fit", "sky.csv", "--sun-zenith-deg", "45", "--sun-azimuth-deg", "450")


class Map(unittest.TestCase):
    def test_azimuths_of_any_turn_are_taken(self):
        with Workplace(os.environ["SKYLUT_PROGRAM"]) as work:
            rows = {}
            for azimuth in ("-90", "270", "990"):
                work.write("views.csv", f"zenith_deg,azimuth_deg\n60,{azimuth}\n")
                work.succeed("map", "-o", "sky.csv", "--sun-zenith-deg", "45", "--sun-azimuth-deg", azimuth, "--directions",
                             "views.csv", *COARSE)
                with open(work.path("sky.csv"), newline="", encoding="utf-8") as file:
                    rows[azimuth] = list(csv.reader(line for line in file if not line.startswith("#")))
            self.assertEqual(rows["-90"], rows["270"])
            self.assertEqual(rows["990"], rows["270"])
            self.assertEqual(rows["270"][1][1], "270")


class Cache(unittest.TestCase):
    def test_is_left_alone_on_request(self):
        with Workplace(os.environ["SKYLUT_PROGRAM"]) as work:
            os.environ["XDG_CACHE_HOME"] = str(work.path("cache"))
            self.addCleanup(os.environ.pop, "XDG_CACHE_HOME")
            work.succeed("aerosol", "show", "rural", "--no-cache")
            self.assertEqual(list(work.contents()), [])
            work.succeed("aerosol", "show", "rural")
            self.assertIn("cache/skylut", work.contents())


if __name__ == "__main__":
    unittest.main()
