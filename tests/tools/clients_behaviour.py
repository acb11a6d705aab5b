#!/usr/bin/env python3
"""tools/clients without any client: the documented lookups against pictures whose pixels are their own directions, the directions
asked for, and that what is not installed is skipped in one line."""

import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
CLIENTS = pathlib.Path(__file__).resolve().parents[2] / "tools/clients"
sys.path.insert(0, str(CLIENTS))

import lookups  # noqa: E402
import sky  # noqa: E402

SOME = [(z, a) for z in (3, 40, 77, 88, 93, 120, 171) for a in (2, 47, 100, 160, 215, 275, 340)]


def latlong_pixel(width, height):
    """Rows from the zenith down, columns clockwise, east in the middle."""
    return lambda column, row: sky.vector((row + 0.5) * 180 / height, (column + 0.5) * 360 / width - 90)


def square_pixel(size):
    """The square of Clarberg 2008 from its pixels to the sphere."""
    def pixel(column, row):
        u, v = 2 * (column + 0.5) / size - 1, 2 * (row + 0.5) / size - 1
        edge = 1 - abs(u) - abs(v)
        radius = 1 - abs(edge)
        turn = math.pi / 4 * ((abs(v) - abs(u)) / radius + 1 if radius else 1)
        sine = radius * math.sqrt(2 - radius * radius)
        return (math.copysign(sine * math.cos(turn), u), math.copysign(sine * math.sin(turn), v),
                math.copysign(1 - radius * radius, edge))
    return pixel


class Lookups(unittest.TestCase):
    def worst_deg(self, lookup, pixel, width, height):
        return max(sky.between_deg(place, sky.angles(*lookup(pixel, width, height, sky.vector(*place)))) for place in SOME)

    def test_openexr_is_off_by_half_a_pixel_at_most_and_by_nothing_in_the_middle(self):
        pixel = latlong_pixel(512, 256)
        self.assertLess(self.worst_deg(lookups.openexr_latlong, pixel, 512, 256), 0.5 * math.sqrt(2) * 180 / 256)
        zenith, azimuth = sky.angles(*lookups.openexr_latlong(pixel, 512, 256, sky.vector(90, 90)))
        self.assertAlmostEqual(zenith, 90, places=6)
        self.assertAlmostEqual(azimuth, 90, places=6)

    def test_mitsuba_is_off_by_half_a_row_at_most(self):
        self.assertLess(self.worst_deg(lookups.mitsuba, latlong_pixel(512, 256), 512, 256), 0.5 * 180 / 256)

    def test_mitsuba_is_exact_on_the_horizon(self):
        seen = lookups.mitsuba(latlong_pixel(512, 256), 512, 256, sky.vector(90, 33))
        self.assertAlmostEqual(sky.angles(*seen)[0], 90, places=6)

    def test_pbrt_finds_the_pixel_of_the_direction(self):
        # A pixel's half diagonal at the edges of the square's triangles, where it is most stretched: less than 1.5 of its mean size.
        mean_deg = math.degrees(math.sqrt(4 * math.pi)) / 256
        self.assertLess(self.worst_deg(lookups.pbrt, square_pixel(256), 256, 256), 1.5 * mean_deg)

    def test_pbrt_square_at_the_axes(self):
        for vector, point in (((0, 0, 1), (0.5, 0.5)), ((1, 0, 0), (1, 0.5)), ((0, 1, 0), (0.5, 1)), ((-1, 0, 0), (0, 0.5))):
            for found, wanted in zip(lookups.pbrt_square(*vector), point):
                self.assertAlmostEqual(found, wanted, places=12)
        for found in lookups.pbrt_square(0.0, 0.0, -1.0):  # at any of the corners
            self.assertIn(round(found, 12), (0, 1))


class Asked(unittest.TestCase):
    def test_directions_tell_mirrored_and_turned_pictures_apart(self):
        for turn in (90, 180, 270):
            for zenith, azimuth in sky.DIRECTIONS[1:]:
                for other in ((zenith, azimuth + turn), (zenith, -azimuth), (180 - zenith, azimuth)):
                    self.assertGreater(sky.between_deg((zenith, azimuth), other), 1)

    def test_disc_around_the_sun(self):
        away = [sky.between_deg(place, (sky.SUN_ZENITH_DEG, sky.SUN_AZIMUTH_DEG)) for place in sky.around_sun()]
        self.assertLess(max(away), 1.0)
        # The mean of r/R over a disc is 2/3.
        self.assertAlmostEqual(sum(away) / len(away), 2 / 3, delta=0.01)

    def test_white_is_grey(self):
        # D65 (0.3127, 0.3290) has R = G = B = Y.
        for value in sky.rgb_of_yxy(100, 0.3127, 0.3290):
            self.assertAlmostEqual(value, 100, delta=0.1)


class Skips(unittest.TestCase):
    def test_a_client_that_is_not_there_is_one_line(self):
        with tempfile.TemporaryDirectory() as work:
            done = subprocess.run([sys.executable, CLIENTS / "check", "--program", sys.executable, "--work", work, "blender", "threejs"],
                                  capture_output=True, text=True, check=False, env={"PATH": work})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.splitlines(), ["blender: skipped: no program blender in the PATH",
                                                    "threejs: skipped: no program node in the PATH"])


if __name__ == "__main__":
    unittest.main()
