#!/usr/bin/env python3
"""Every option of every command, as --help lists it, refuses what is no value of its kind: in one line of ours."""

import os
import re
import unittest

from expect import Workplace

# What each command needs before its options are looked at.
COMMANDS = {
    ("table",): ["--out", "out"],
    ("map",): ["-o", "sky.csv", "--sun-zenith-deg", "45"],
    ("sun",): ["--sun-zenith-deg", "45"],
    ("fit",): ["sky.csv"],
    ("compare",): ["out", "--against", "utm2005"],
    ("solve",): ["case.json"],
    ("profile", "show"): ["ussa1976"],
    ("profile", "case"): ["ussa1976", "--wavelength-nm", "550"],
    ("aerosol", "show"): ["rural"],
    ("aerosol", "mie"): ["--size-parameter", "1", "--index", "1.5,0"],
}
NO_NUMBERS = ["nan", "inf", "-inf", "", "1e999", "abc", "99999999999999999999", "0x10", "5..5"]
WRONG = {
    "NUMBER": NO_NUMBERS,
    "COUNT": [*NO_NUMBERS, "-5", "1.5"],
    "LIST": [*NO_NUMBERS, ",", "0,,1", "0,nan"],
    "LIST|LO:HI:STEP": [*NO_NUMBERS, "0:10", "10:0:1", "0:nan:1", "0:10:0"],
    "LO:HI:STEP": [*NO_NUMBERS, "380:780", "nan:780:5", "380:780:nan", "380:inf:5", "380:780:0", "380:780:-5", "1:2:3:4"],
    "Z:A,...": [*NO_NUMBERS, "45", "nan:0", "0:inf", "0:0,", "0:0:0"],
    "RE,IM": [*NO_NUMBERS, "1.5", "nan,0", "1.5,inf", "1,2,3"],
    "ANGLE": ["", "nan", "inf", "abc", "1e999", "9999", "48:75"],
    "TIME": ["", "noon", "nan", "2024-06-21", "2024-02-30T00:00Z"],
    "TIME|START/END/STEP": ["", "noon", "nan", "2024-06-21", "2024-06-21T09:00Z/2024-06-21T08:00Z/1h",
                            "2024-06-21T09:00Z/2024-06-21T10:00Z/0min", "2024-06-21T09:00Z/2024-06-21T10:00Z"],
    "DATE": ["", "today", "nan", "2024-02-30"],
    "NAME": ["", "nan", "best of all", "\u00fc"],
    "NAME=VALUE,...": ["", "optical-step", "optical-step=nan", "optical-step=1e9", "step=1", "=", "a=1=2"],
    "NAME|FILE": ["", "no such name", "/no/such/file", "."],
    "NUMBER|NAME|FILE": ["", "nan", "inf", "-1", "1e999", "no such name", "/no/such/file"],
    "DIR": ["", "/dev/null/x"],
    "FILE": ["", "/no/such/folder/file.csv", "."],
    "KIND": ["", "nan"],
}
# An option as CLI11 lays it out: "  -o,--output FILE" or "  --size COUNT=256 ...".
OPTION = re.compile(r"^  (?:-\w,)?(--[\w-]+) ([^\s=]+(?:=VALUE,\.\.\.)?)(?:=\S+)?(?:\s|$)")


class OptionValues(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)

    def options_of(self, command):
        for line in self.work.succeed(*command, "--help").splitlines():
            if match := OPTION.match(line):
                yield match.group(1), match.group(2)

    def refused(self, command, option, value):
        needed = list(COMMANDS[command])
        for name in (option, "-o" if option == "--output" else option):
            if name in needed:
                del needed[needed.index(name):needed.index(name) + 2]
        if option in ("--projection", "--channels", "--size"):
            needed[needed.index("sky.csv")] = "sky.exr"
        result = self.work.run(*command, *needed, f"{option}={value}")
        lines = result.stderr.split("\n")
        said = f"{' '.join(command)} {option}={value!r}: exit {result.returncode}, {result.stderr!r}"
        self.assertEqual(result.returncode, 2, said)
        self.assertEqual(len(lines), 2, said)
        self.assertTrue(lines[0].startswith("skylut: "), said)
        for foreign in ("FAILED", "std::", "required", "basic_string", "what()", "parse error", "type_error", "TEXT"):
            self.assertNotIn(foreign, lines[0], said)
        if value == "":
            self.assertIn("-o" if option == "--output" else option, lines[0], said)
        self.assertEqual(result.stdout, "", said)
        self.assertEqual(self.work.contents(), {}, said)

    def test_wrong_values_are_refused(self):
        tried = 0
        for command in COMMANDS:
            for option, placeholder in self.options_of(command):
                for value in WRONG[placeholder]:
                    self.refused(command, option, value)
                    tried += 1
        self.assertGreater(tried, 500)

    def test_nothing_of_ours_is_said_in_another_way(self):
        """--threads, --quality, --weights and so on are refused in the same words by every command."""
        for value, options in (("99999999", ("--threads",)), ("best", ("--quality",)), ("none", ("--weights",)),
                               ("linke", ("--turbidity-kind",)), ("120", ("--humidity",)), ("-5", ("--ozone-du",))):
            for option in options:
                said = set()
                for command in COMMANDS:
                    if any(option == name for name, _ in self.options_of(command)):
                        said.add(self.work.run(*command, *COMMANDS[command], option, value).stderr)
                self.assertEqual(len(said), 1, said)


if __name__ == "__main__":
    unittest.main()
