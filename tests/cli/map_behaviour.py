#!/usr/bin/env python3
"""What `skylut map` does when the request is right."""

import csv
import math
import os
import unittest

from expect import Workplace

COARSE = ["--wavelengths-nm", "400:700:50", "--quality", "draft"]


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [{name: float(value) for name, value in row.items()}
                for row in csv.DictReader(line for line in file if not line.startswith("#"))]


class Map(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)

    def map(self, *arguments):
        return self.work.succeed("map", *arguments, *COARSE)

    def test_csv_holds_the_271_directions(self):
        self.map("-o", "sky.csv", "--sun-zenith-deg", "45", "--sun-azimuth-deg", "90")
        rows = rows_of(self.work.path("sky.csv"))
        self.assertEqual(len(rows), 271)
        for row in rows:
            theta, phi = math.radians(row["zenith_deg"]), math.radians(row["azimuth_deg"] - 90)
            cosine = (math.cos(theta) + math.sin(theta) * math.cos(phi)) * math.sqrt(0.5)
            self.assertAlmostEqual(math.cos(math.radians(row["gamma_deg"])), cosine, places=12)
            self.assertGreater(row["Y_cd_m2"], 0)

    def test_other_directions(self):
        self.map("-o", "sky.csv", "--sun-zenith-deg", "45", "--directions", "preetham343")
        self.assertEqual(len(rows_of(self.work.path("sky.csv"))), 343)
        self.work.write("mine.csv", "azimuth_deg,zenith_deg\n10,20\n30,140\n")
        self.map("-o", "mine_sky.csv", "--sun-zenith-deg", "45", "--directions", "mine.csv")
        rows = rows_of(self.work.path("mine_sky.csv"))
        self.assertEqual([(row["zenith_deg"], row["azimuth_deg"]) for row in rows], [(20, 10), (140, 30)])

    def test_a_map_is_the_tables_map(self):
        self.work.succeed("table", "--out", "out", "--altitudes-km", "6", "--turbidities", "0.2",
                          "--suns", "45:90", "--save-maps", *COARSE)
        self.map("-o", "sky.csv", "--altitude-km", "6", "--turbidity", "0.2", "--sun-zenith-deg", "45",
                 "--sun-azimuth-deg", "90")
        self.assertEqual(rows_of(self.work.path("sky.csv")), rows_of(self.work.path("out/maps/entry_001.csv")))

    def test_pictures_go_to_one_file_per_kind(self):
        screen = self.map("-o", "sky.exr", "--sun-zenith-deg", "45", "--size", "8",
                          "--channels", "rgb,xyz,spectral")
        self.assertEqual(sorted(self.work.contents()), ["sky_rgb.exr", "sky_spectral.exr", "sky_xyz.exr"])
        self.assertIn("128 pixels", screen)

    def test_a_picture_of_one_kind_has_the_name_asked_for(self):
        self.map("-o", "sky.exr", "--sun-zenith-deg", "45", "--size", "8", "--channels", "xyz")
        self.assertEqual(list(self.work.contents()), ["sky.exr"])

    def test_threads_change_no_byte(self):
        for threads in ("1", "2"):
            self.map("-o", f"{threads}.exr", "--sun-zenith-deg", "85", "--size", "8", "--threads", threads,
                     "--channels", "spectral")
        self.assertEqual(self.work.path("1.exr").read_bytes(), self.work.path("2.exr").read_bytes())

    def test_a_sun_of_its_own(self):
        small = ["--sun-zenith-deg", "45", "--size", "8", "--channels", "luminance"]
        self.map("-o", "sky.exr", "--sun", "file", "--channels", "rgb,xyz", *small[:4])
        self.assertEqual(sorted(self.work.contents()),
                         ["sky_rgb.exr", "sky_rgb_sun.exr", "sky_xyz.exr", "sky_xyz_sun.exr"])
        bright = self.map("-o", "disc.exr", "--sun", "disc", *small)
        dark = self.map("-o", "off.exr", *small)
        brightest = [float(screen.split("luminance ")[1].split()[2]) for screen in (bright, dark)]
        # 8 rows: the disc, 6.8e-5 sr of some 1e9 cd/m2, in a pixel of 0.1 sr.
        self.assertGreater(brightest[0], 2e5)
        self.assertLess(brightest[1], 1e5)

    def test_a_day_is_a_series_of_numbered_pictures(self):
        screen = self.map("-o", "sky.exr", "--size", "8", "--latitude", "48:51N", "--longitude", "2:21E", "--time",
                          "2024-03-20T00:00Z/2024-03-20T23:00Z/1h")
        names = sorted(self.work.contents())
        frames = [name for name in names if name.endswith(".exr")]
        with open(self.work.path("sky.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        self.assertEqual([row["file"] for row in rows], frames)
        self.assertEqual(frames, [f"sky_{i:04}.exr" for i in range(1, len(frames) + 1)])
        self.assertEqual(names, ["sky.csv", *frames])
        self.assertIn(f"{24 - len(frames)} suns are more than 99 deg", screen)
        self.assertIn(len(frames), (13, 14))  # equinox: 12 hours and two twilights of 55 minutes
        noon = rows[[row["time"] for row in rows].index("2024-03-20T12:00:00Z")]
        self.assertAlmostEqual(float(noon["sun_zenith_deg"]), 48.85, delta=0.3)
        for row in rows:
            beam = float(row["direct_normal_lux"]) * max(0, math.cos(math.radians(float(row["sun_zenith_deg"]))))
            self.assertAlmostEqual(float(row["direct_horizontal_lux"]), beam, delta=1e-6 * beam)
            self.assertGreater(float(row["diffuse_horizontal_lux"]), 0)

    def test_frames_do_not_depend_on_threads_or_company(self):
        suns = ["--suns", "45:90,60:100,85:110", "--size", "8", "--sun", "disc", "--preview", "look.png"]
        for folder, threads in (("one", "1"), ("two", "2")):
            self.work.path(folder).mkdir()
            self.map("-o", f"{folder}/sky.exr", *suns, "--threads", threads)
            self.assertTrue(self.work.path("look_0003.png").exists())
        for name in ("sky_0001.exr", "sky_0002.exr", "sky_0003.exr", "sky.csv"):
            self.assertEqual(self.work.path(f"one/{name}").read_bytes(), self.work.path(f"two/{name}").read_bytes())

    def test_times_from_a_file(self):
        self.work.write("mine.csv", "name,time\nearly,2024-06-21T06:00Z\nlate,2024-06-21T15:00+02:00\n")
        self.map("-o", "sky.exr", "--size", "8", "--latitude", "48:51N", "--longitude", "2:21E", "--times", "mine.csv")
        self.assertEqual(sorted(self.work.contents()), ["mine.csv", "sky.csv", "sky_0001.exr", "sky_0002.exr"])
        self.assertIn("2024-06-21T13:00:00Z", self.work.path("sky.csv").read_text(encoding="utf-8"))

    def test_place_and_time_give_the_sun(self):
        # Summer solstice noon at Greenwich: the sun stands 51.48 - 23.44 = 28.04 deg from the zenith, in the south;
        # 0.1 deg leaves room for the equation of time (2 min) and the change of declination over the day.
        self.map("-o", "sky.csv", "--latitude", "51:28:40N", "--longitude", "0", "--time", "2024-06-21T12:00Z")
        lines = self.work.path("sky.csv").read_text(encoding="utf-8").splitlines()
        values = dict(line[2:].split("=", 1) for line in lines if line.startswith("# ") and "=" in line)
        self.assertAlmostEqual(float(values["sun_zenith_deg"]), 28.04, delta=0.1)
        self.assertAlmostEqual(float(values["sun_azimuth_deg"]), 180, delta=2)

    def test_an_existing_file_is_replaced(self):
        self.work.write("sky.csv", "old")
        self.map("-o", "sky.csv", "--sun-zenith-deg", "45")
        self.assertEqual(len(rows_of(self.work.path("sky.csv"))), 271)
        self.assertEqual(list(self.work.contents()), ["sky.csv"])


if __name__ == "__main__":
    unittest.main()
