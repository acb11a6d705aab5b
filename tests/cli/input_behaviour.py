#!/usr/bin/env python3
"""Valid input that was refused or misread once: places, bands at a spectrum's ends, particles, soundings, JSON."""

import csv
import json
import os
import pathlib
import unittest

from expect import Workplace

SPECTRA = pathlib.Path(__file__).resolve().parents[2] / "profiles/spectra"
BEAM = ["--no-diffuse", "--turbidity", "0"]


def band_mean(spectrum, first_nm, last_nm):
    """Mean over [first, last] of touching 1 nm bands."""
    total = 0.0
    with open(SPECTRA / f"solar_{spectrum}.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))[1:]
    for centre, value in ((float(row[0]), float(row[1])) for row in rows):
        overlap = min(last_nm, centre + 0.5) - max(first_nm, centre - 0.5)
        total += max(0.0, overlap) * value
    return total / (last_nm - first_nm)


def column(name, unit, values):
    return f'[column.{name}]\nunit = "{unit}"\nsource = "test"\nvalues = {values}\n'


def sounding(altitude_m, temperature_k, pressure_hpa, ozone_ppmv):
    return ('name = "sounding"\ndescription = "levels"\nsource = "made up for a test"\n'
            + column("altitude", "m", altitude_m) + column("temperature", "K", temperature_k)
            + column("pressure", "hPa", pressure_hpa) + column("ozone", "ppmv", ozone_ppmv))


class Input(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)

    def sun(self, *arguments):
        result = self.work.run("sun", "-o", "sun.json", *BEAM, *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(self.work.path("sun.json").read_text(encoding="utf-8"))

    def test_places_as_documents_print_them(self):
        for latitude, longitude, zenith, azimuth in (
                ("48°51′24″N", "2°21′3″E", 42.25870, 111.14814),
                ("48° 51′ 24″ N", "2° 21′ 3″ E", 42.25870, 111.14814),
                ("N 59°12'7.7\"", "W 02°15'39.6\"", 48.88438, 115.67470)):
            sun = self.sun("--time", "2024-06-21T09:00Z", "--latitude", latitude, "--longitude", longitude,
                           "--wavelengths-nm", "500:500:5")["sun"]
            self.assertAlmostEqual(sun["zenith_deg"], zenith, delta=1e-3)
            self.assertAlmostEqual(sun["azimuth_deg"], azimuth, delta=1e-3)

    def test_bands_are_clipped_at_the_ends_of_the_spectrum(self):
        for spectrum, name, grid, first, last in (
                ("astm_g173", "astm-g173", "300:1000:100", (280.5, 350), (950, 1030.5)),
                ("astm_g173", "astm-g173", "300:900:50", (280.5, 325), (875, 925)),
                ("gueymard2003", "gueymard2003", "360:830:5", (359.5, 362.5), (827.5, 830.5))):
            above = self.sun("--sun-zenith-deg", "60", "--solar", name,
                             "--wavelengths-nm", grid)["extraterrestrial_w_m2_nm"]
            self.assertAlmostEqual(above[0], band_mean(spectrum, *first), delta=1e-9)
            self.assertAlmostEqual(above[-1], band_mean(spectrum, *last), delta=1e-9)

    def test_particles_steeper_than_rayleigh(self):
        self.work.write("aitken.toml", 'name = "aitken"\ndescription = "clear"\nsource = "made up for a test"\n'
                        '[[component]]\nname = "aitken"\nnumber_per_cm3 = 3000\nmode_radius_um = 0.02\n'
                        "sigma_g = 1.2\nr_min_um = 0.0005\nr_max_um = 0.1\nn = 1.53\nk = 0\n")
        self.work.succeed("aerosol", "show", "./aitken.toml")

    def test_the_weight_of_the_air_fixes_its_column(self):
        self.work.write("two.toml", sounding([0, 30000], [288.15, 226.51], [1013.25, 11.97], [0, 0]))
        two = self.sun("--profile", "./two.toml", "--sun-zenith-deg", "0", "--wavelengths-nm", "500:500:5")
        self.assertAlmostEqual(two["transmittance_rayleigh"][0], 0.86638, delta=1e-4)
        shown = self.work.run("profile", "show", "./two.toml")
        self.assertIn("contradict the weight of the air", shown.stdout)

    def test_soundings_from_a_hill_and_ended_by_the_burst(self):
        self.work.write("station.toml", sounding([1830, 10000, 30000], [278.15, 223.25, 226.51],
                                                 [815, 265.0, 11.97], [0.03, 0.13, 5]))
        self.work.write("burst.toml", sounding([0, 10000, 25000], [288.15, 223.25, 221.55],
                                               [1013.25, 265.0, 25.49], [0.03, 0.13, 5]))
        station = self.work.run("profile", "show", "./station.toml")
        self.assertEqual(station.returncode, 0, station.stderr)
        self.assertIn("ground 1830 m above sea level", station.stdout)
        burst = self.work.run("profile", "show", "./burst.toml")
        self.assertEqual(burst.returncode, 0, burst.stderr)
        self.assertIn("described to 25 km, continued to 100 km", burst.stdout)

    def test_deep_json_is_refused_in_one_line(self):
        self.work.write("deep.json", '{"outputs":1,"geometry":' + "[" * 65000 + "]" * 65000 + "}")
        result = self.work.run("solve", "deep.json")
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr, "skylut: deep.json: nested deeper than 64 levels\n")

    def test_a_small_planet_is_refused_with_the_file(self):
        case = pathlib.Path(__file__).resolve().parents[1] / "data/solver_cases/sph_B_sza60_alt00.json"
        document = json.loads(case.read_text(encoding="utf-8"))
        for radius in (0, 1, 999.9, 1.1e9):
            document["planet_radius_km"] = radius
            self.work.write("planet.json", json.dumps(document))
            result = self.work.run("solve", "planet.json")
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, r"^skylut: planet.json: planet_radius_km: \S+ must be a number within "
                                            r"1000-1000000000 km\n$")


if __name__ == "__main__":
    unittest.main()
