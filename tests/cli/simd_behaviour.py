#!/usr/bin/env python3
"""The builds of the solver's kernel give the same radiances, whichever way they are asked for."""

import json
import os
import pathlib
import unittest

from expect import Workplace

CASES = pathlib.Path(__file__).parent.parent / "data" / "solver_cases"
# Single-precision rounding of some ten thousand operations; fused multiply-adds round differently.
LARGEST_DIFFERENCE = 1e-5


class Simd(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)
        self.addCleanup(os.environ.pop, "SKYLUT_SIMD", None)

    def radiances(self, case, instruction_set):
        """None if this machine lacks the instruction set."""
        result = self.work.run("solve", str(CASES / f"{case}.json"), "--simd", instruction_set, "-o", "-")
        if result.returncode == 2 and "this processor lacks" in result.stderr:
            return None
        self.assertEqual(result.returncode, 0, result.stderr)
        answer = json.loads(result.stdout)
        self.assertEqual(answer["instruction_set"], instruction_set)
        return [view["radiance"] for view in answer["results"]]

    def compare(self, instruction_set):
        for case in ["sph_A_alb03_sza88_alt30", "sph_B_sza60_alt00", "sph_C_sza85_alt00", "sph_B_sza92_alt12",
                     "sph_D_sza94_alt20"]:
            plain = self.radiances(case, "portable")
            wide = self.radiances(case, instruction_set)
            if wide is None:
                self.skipTest(f"no {instruction_set} on this machine")
            largest = max(abs(a / b - 1) for a, b in zip(wide, plain))
            print(f"{instruction_set} {case}: {largest:.1e}")
            self.assertLess(largest, LARGEST_DIFFERENCE, case)

    def test_avx2(self):
        self.compare("avx2")

    def test_avx512(self):
        self.compare("avx512")

    def test_environment_asks_where_no_option_does(self):
        case = str(CASES / "sph_B_sza60_alt00.json")
        os.environ["SKYLUT_SIMD"] = "portable"
        answer = json.loads(self.work.succeed("solve", case, "-o", "-"))
        self.assertEqual(answer["instruction_set"], "portable")
        os.environ["SKYLUT_SIMD"] = "mmx"
        answer = json.loads(self.work.succeed("solve", case, "--simd", "portable", "-o", "-"))
        self.assertEqual(answer["instruction_set"], "portable")

    def test_unknown_instruction_set(self):
        os.environ["SKYLUT_SIMD"] = "mmx"
        result = self.work.run("solve", str(CASES / "sph_B_sza60_alt00.json"))
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"^skylut: .*SKYLUT_SIMD=mmx: must be best, portable, avx2 or avx512[^\n]*\n$")


if __name__ == "__main__":
    unittest.main()
