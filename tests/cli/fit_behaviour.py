#!/usr/bin/env python3
"""What `skylut fit` does where the search is hard: arrive, or say that it did not."""

import json
import math
import os
import unittest

from expect import Workplace

SUN_ZENITH_DEG, SUN_AZIMUTH_DEG = 60.0, 160.0
RINGS = [(84, 30), (72, 30), (60, 24), (48, 24), (36, 18), (24, 12), (12, 6)]  # zenith angle, directions


def cie_clear(zenith, gamma):
    """CIE sky type 12 (CIE S 011:2003), not scaled."""
    gradation = 1.0 - math.exp(-0.32 / math.cos(zenith))
    scattering = 1.0 + 10.0 * (math.exp(-3.0 * gamma) - math.exp(-1.5 * math.pi)) + 0.45 * math.cos(gamma) ** 2
    return gradation * scattering


def clear_sky(zenith_reads):
    """A measured sky whose zenith reading is `zenith_reads` times the right one."""
    sun = math.radians(SUN_ZENITH_DEG)
    lines = [f"# sun_zenith_deg={SUN_ZENITH_DEG}", f"# sun_azimuth_deg={SUN_AZIMUTH_DEG}", "zenith_deg,azimuth_deg,Y,x,y",
             f"0,0,{5000.0 * zenith_reads},0.31,0.33"]
    for zenith_deg, count in RINGS:
        for i in range(count):
            zenith, azimuth = math.radians(zenith_deg), 360.0 * i / count
            gamma = math.acos(math.cos(sun) * math.cos(zenith) + math.sin(sun) * math.sin(zenith)
                              * math.cos(math.radians(azimuth - SUN_AZIMUTH_DEG)))
            luminance = 5000.0 * cie_clear(zenith, gamma) / cie_clear(0.0, sun)
            lines.append(f"{zenith_deg},{azimuth},{luminance:.6f},0.31,0.33")
    return "\n".join(lines) + "\n"


# As many samples as it takes, far from any sky: along the best valley the cost falls for ever.
NO_SKY = """zenith_deg,azimuth_deg,Y_cd_m2,x,y
# sun_zenith_deg=60
# sun_azimuth_deg=0
0,0,1.7e+16,0.3,0.3
30,0,2.13e+19,0.3,0.3
30,60,5.26e+20,0.3,0.3
30,120,3.61e+24,0.3,0.3
30,180,1.91e+19,0.3,0.3
60,0,1.08e+24,0.3,0.3
60,60,5.7,0.3,0.3
60,120,1.36e+12,0.3,0.3
60,180,3.82e+24,0.3,0.3
85,0,8.14e+16,0.3,0.3
85,60,2.99e+23,0.3,0.3
85,120,891,0.3,0.3
85,180,1.67e+12,0.3,0.3
"""


class Fit(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)

    def test_arrives_at_the_end_of_a_curved_valley(self):
        self.work.write("sky.csv", clear_sky(zenith_reads=1.8))
        answer = json.loads(self.work.succeed("fit", "sky.csv", "--json"))
        self.assertEqual(answer["Y"]["termination"], "converged")
        self.assertTrue(answer["Y"]["at_bound"]["B"])
        # What Levenberg-Marquardt alone creeps up to without arriving (0.30017).
        self.assertAlmostEqual(answer["Y"]["rmse"], 0.300169, delta=1e-6)

    def test_a_sky_of_the_formula_is_found(self):
        self.work.write("sky.csv", clear_sky(zenith_reads=1.0))
        answer = json.loads(self.work.succeed("fit", "sky.csv", "--json"))
        self.assertLess(answer["Y"]["rmse"], 1e-8)
        self.assertAlmostEqual(answer["Y"]["coefficients"]["B"], -0.32, places=5)

    def test_no_convergence_is_exit_1_and_the_file_says_so(self):
        self.work.write("sky.csv", NO_SKY)
        for arguments in (["fit", "sky.csv", "-o", "fit.json"], ["fit", "sky.csv", "--json"]):
            result = self.work.run(*arguments)
            self.assertEqual(result.returncode, 1)
            self.assertRegex(result.stderr, r"\Askylut: .*the fit of Y did not converge.*\n\Z")
        self.assertEqual(json.loads(result.stdout)["Y"]["termination"], "no_convergence")
        self.assertEqual(json.loads(self.work.path("fit.json").read_text())["Y"]["termination"], "no_convergence")


if __name__ == "__main__":
    unittest.main()
