#!/usr/bin/env python3
"""What `skylut sun` and `skylut profile case` do when the request is right."""

import csv
import json
import math
import os
import pathlib
import unittest

from expect import Workplace

ASTM_G173 = pathlib.Path(__file__).resolve().parents[1] / "data/astm_g173_direct_10nm.csv"
COARSE = ["--wavelengths-nm", "400:700:50", "--quality", "draft"]


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [{name: float(value) for name, value in row.items()}
                for row in csv.DictReader(line for line in file if not line.startswith("#"))]


class Sun(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)

    def sun(self, *arguments):
        return self.work.succeed("sun", *arguments, *COARSE)

    def test_csv_and_json_hold_the_same(self):
        for name in ("sun.csv", "sun.json"):
            self.sun("-o", name, "--sun-zenith-deg", "60", "--circumsolar-deg", "2.5")
        first = self.work.path("sun.csv").read_text(encoding="utf-8").splitlines()[0]
        self.assertTrue(first.startswith("wavelength_nm,direct_normal_w_m2_nm,diffuse_horizontal_w_m2_nm,"
                                         "global_horizontal_w_m2_nm,extraterrestrial_w_m2_nm"), first)
        self.assertIn("transmittance_rayleigh", first)
        rows = rows_of(self.work.path("sun.csv"))
        document = json.loads(self.work.path("sun.json").read_text(encoding="utf-8"))
        for name in first.split(","):
            self.assertEqual([row[name] for row in rows], document[name], name)
        for row in rows:
            product = row["extraterrestrial_w_m2_nm"]
            for name, value in row.items():
                if name.startswith("transmittance_"):
                    product *= value
            self.assertAlmostEqual(product, row["direct_normal_w_m2_nm"], places=12)
            self.assertAlmostEqual(row["global_horizontal_w_m2_nm"],
                                   0.5 * row["direct_normal_w_m2_nm"] + row["diffuse_horizontal_w_m2_nm"], places=12)
            self.assertGreater(row["circumsolar_normal_w_m2_nm"], 0)

    def test_what_the_light_looks_like(self):
        screen = self.work.succeed("sun", "-o", "sun.json", "--sun-zenith-deg", "60", "--quality", "draft",
                                   "--wavelengths-nm", "380:780:20")
        self.assertRegex(screen, r"disc 0\.5331 deg across, 1\.[0-9]+e\+09 cd/m2 on average")
        self.assertRegex(screen, r"sun, normal to it +0\.3[0-9]+ +0\.3[0-9]+ +[45][0-9]{3} ")
        self.assertRegex(screen, r"sky, on the horizontal +0\.2[0-9]+ +0\.2[0-9]+ ")
        document = json.loads(self.work.path("sun.json").read_text(encoding="utf-8"))
        disc, sky = document["disc"], document["sky"]
        self.assertAlmostEqual(disc["illuminance_lux"] / document["sums"]["direct_normal"]["lux"], 1, places=3)
        self.assertAlmostEqual(sky["illuminance_lux"] / document["sums"]["diffuse_horizontal"]["lux"], 1, places=9)
        self.assertAlmostEqual(disc["mean_luminance_cd_m2"] * 6.79997e-5 / disc["illuminance_lux"], 1, places=5)
        self.assertEqual(disc["visible_part"], 1)
        self.assertTrue(4500 < disc["cct_k"] < 5500, disc)
        red, green, blue = sky["linear_rec709_lux"]
        self.assertLess(red, blue)
        self.assertAlmostEqual((0.2126 * red + 0.7152 * green + 0.0722 * blue) / sky["illuminance_lux"], 1, places=3)

    def test_the_disc_sets(self):
        self.assertIn("50.0 % of it above the horizon", self.sun("--sun-zenith-deg", "90", "--no-diffuse"))
        self.assertIn("deg across, below the horizon", self.sun("--sun-zenith-deg", "91", "--no-diffuse"))
        # A closed form knows the beam alone: all of the disc, or none.
        self.assertRegex(self.sun("--sun-zenith-deg", "60", "--model", "iqbal"), r"disc .*cd/m2 on average")

    def test_light_on_a_plane(self):
        screen = self.sun("-o", "wall.json", "--sun-zenith-deg", "60", "--tilt-deg", "90", "--tilt-azimuth-deg", "200")
        self.assertIn("on a plane tilted by 90 deg that faces azimuth 200 deg", screen)
        sums = json.loads(self.work.path("wall.json").read_text(encoding="utf-8"))["sums"]
        cosine = math.sin(math.radians(60)) * math.cos(math.radians(20))
        self.assertAlmostEqual(sums["plane_direct"]["lux"] / sums["direct_normal"]["lux"], cosine, places=9)
        self.assertAlmostEqual(sums["plane_ground"]["lux"] / sums["global_horizontal"]["lux"], 0.1, delta=0.001)
        self.assertAlmostEqual(sums["plane_global"]["lux"], sum(sums[part]["lux"] for part in
                                                                ("plane_direct", "plane_sky", "plane_ground")), places=6)
        command = json.loads(self.work.path("wall.json").read_text(encoding="utf-8"))["command"]
        self.assertIn("--tilt-deg 90 --tilt-azimuth-deg 200", command)

    def test_its_command_makes_the_file_again(self):
        self.sun("-o", "first.json", "--sun-zenith-deg", "75", "--altitude-km", "2", "--albedo", "snow",
                 "--solar", "kurucz1992", "--date", "2024-01-03", "--ozone-du", "250")
        command = json.loads(self.work.path("first.json").read_text(encoding="utf-8"))["command"].split()
        self.assertEqual(command[:2], ["skylut", "sun"])
        self.work.succeed(*command[1:], "-o", "again.json")
        self.assertEqual(self.work.path("first.json").read_bytes(), self.work.path("again.json").read_bytes())

    def test_threads_change_no_byte(self):
        for threads in ("1", "2"):
            self.sun("-o", f"{threads}.csv", "--sun-zenith-deg", "45", "--threads", threads)
        self.assertEqual(self.work.path("1.csv").read_bytes(), self.work.path("2.csv").read_bytes())

    def test_the_date_changes_the_distance(self):
        # Perihelion 2024-01-03, 0.98331 au; aphelion 2024-07-05, 1.01673 au: light differs by their square.
        for name, date in (("near", "2024-01-03"), ("far", "2024-07-05")):
            self.sun("-o", name + ".csv", "--sun-zenith-deg", "45", "--no-diffuse", "--date", date)
        near, far = (rows_of(self.work.path(name + ".csv"))[0]["extraterrestrial_w_m2_nm"] for name in ("near", "far"))
        self.assertAlmostEqual(near / far, (1.01673 / 0.98331) ** 2, places=4)

    def test_place_and_time_give_sun_and_distance(self):
        screen = self.sun("--latitude", "51:28:40N", "--longitude", "0", "--time", "2024-06-21T12:00Z", "--no-diffuse")
        zenith = float(screen.split()[1])
        self.assertAlmostEqual(zenith, 28.04, delta=0.1)  # solstice noon: latitude less declination
        self.assertIn("1.0162", screen)

    def test_at_night_there_is_still_a_position(self):
        screen = self.sun("--latitude", "51", "--longitude", "0", "--time", "2024-06-21T00:00Z", "--no-diffuse")
        self.assertIn("the ground hides the sun", screen)

    def test_closed_forms_have_the_columns_of_the_direct_beam(self):
        self.sun("-o", "iqbal.csv", "--sun-zenith-deg", "60", "--model", "iqbal")
        self.assertEqual(list(rows_of(self.work.path("iqbal.csv"))[0]),
                         ["wavelength_nm", "direct_normal_w_m2_nm", "extraterrestrial_w_m2_nm", "transmittance_rayleigh",
                          "transmittance_ozone", "transmittance_mixed_gases", "transmittance_water_vapour",
                          "transmittance_aerosol"])

    def test_the_direct_beam_of_astm_g173(self):
        # 400-700 nm by 10 nm bands: 3 % (water and oxygen included; they are allowed 5 %), 1 % as a whole. The
        # standard's column includes circumsolar light, 0.2-0.5 %. 1.5 % of the worst bands is understood: docs/air.md 10.
        self.work.succeed("sun", "-o", "sun.csv", "--no-diffuse", "--profile", "ussa1976", "--sun-zenith-deg", "48.236",
                          "--turbidity-kind", "aod500", "--turbidity", "0.084", "--aerosol", "rural", "--water-cm", "1.416",
                          "--ozone-du", "343.8", "--no2-du", "0.204", "--solar", "astm-g173",
                          "--wavelengths-nm", "405:695:10")
        rows = {row["wavelength_nm"]: row["direct_normal_w_m2_nm"] for row in rows_of(self.work.path("sun.csv"))}
        published = {row["lower_nm"] + 5: row["direct_normal_w_m2_nm"] for row in rows_of(ASTM_G173)}
        for wavelength_nm, value in rows.items():
            self.assertAlmostEqual(value / published[wavelength_nm], 1, delta=0.03, msg=wavelength_nm)
        self.assertAlmostEqual(sum(rows.values()) / sum(published[w] for w in rows), 1, delta=0.01)

    def test_a_bright_ground_brightens_the_sky(self):
        for ground in ("snow", "grass", "0"):
            self.sun("-o", f"{ground}.csv", "--sun-zenith-deg", "45", "--albedo", ground)
        snow, grass, black = (rows_of(self.work.path(f"{name}.csv"))[0] for name in ("snow", "grass", "0"))
        self.assertEqual(snow["direct_normal_w_m2_nm"], black["direct_normal_w_m2_nm"])
        self.assertGreater(snow["diffuse_horizontal_w_m2_nm"], 1.2 * black["diffuse_horizontal_w_m2_nm"])
        self.assertGreater(grass["diffuse_horizontal_w_m2_nm"], black["diffuse_horizontal_w_m2_nm"])


class ProfileCase(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)

    def test_solving_the_case_gives_the_maps_radiance(self):
        air = ["--turbidity", "0.3", "--sun-zenith-deg", "60", "--altitude-km", "1", "--albedo", "grass"]
        self.work.succeed("profile", "case", "ussa1976", "--wavelength-nm", "550", "-o", "case.json", *air,
                          "--view", "0:0,60:0,85:90")
        self.work.succeed("solve", "case.json", "-o", "solved.json")
        self.work.write("views.csv", "zenith_deg,azimuth_deg\n0,0\n60,180\n85,270\n")
        self.work.succeed("map", "-o", "sky.csv", "--directions", "views.csv", "--wavelengths-nm", "550:555:5", "--scalar", *air,
                          warning="count only 550-555 nm")
        self.work.succeed("sun", "-o", "sun.csv", "--sun-zenith-deg", "60", "--wavelengths-nm", "550:555:5", "--no-diffuse",
                          warning="count only 550-555 nm")
        irradiance = rows_of(self.work.path("sun.csv"))[0]["extraterrestrial_w_m2_nm"]
        solved = json.loads(self.work.path("solved.json").read_text(encoding="utf-8"))["results"]
        for row, result in zip(rows_of(self.work.path("sky.csv")), solved):
            # 1e-4: moments end where they add 1e-7 to the phase function, radiances are 32-bit floats.
            self.assertTrue(math.isclose(row["L_550"], irradiance * result["radiance"], rel_tol=1e-4), result)

    def test_without_a_file_a_summary_goes_to_the_screen(self):
        screen = self.work.succeed("profile", "case", "utm2005", "--wavelength-nm", "450")
        self.assertLess(len(screen.splitlines()), 10)
        self.assertRegex(screen, r"optical depth [0-9.]+: Rayleigh 0\.2[0-9]+, aerosol [0-9.]+, absorption")
        self.assertEqual(list(self.work.contents()), [])

    def test_the_case_goes_to_standard_output_on_request(self):
        for name in ("-", "/dev/stdout"):
            document = json.loads(self.work.succeed("profile", "case", "utm2005", "--wavelength-nm", "450", "-o", name))
            self.assertEqual(len(document["layers"]) + 1, len(document["levels_km"]))
        self.assertEqual(list(self.work.contents()), [])


if __name__ == "__main__":
    unittest.main()
