#!/usr/bin/env python3
"""Every example that README.md, the user guide and --help show can be run as it stands there.

Only made quicker: few wavelengths, draft quality, small pictures.
"""

import os
import pathlib
import re
import shlex
import unittest

from expect import Workplace

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMANDS = ["table", "map", "fit", "compare", "profile", "aerosol", "solve", "sun"]


def shell_lines(document):
    """Lines that begin with "skylut" in the ```sh blocks of a document."""
    text = (ROOT / document).read_text(encoding="utf-8")
    for block in re.findall(r"```sh\n(.*?)```", text, re.DOTALL):
        for line in block.replace("\\\n", " ").splitlines():
            if line.startswith("skylut "):
                yield shlex.split(line, comments=True)[1:]


def help_lines(text):
    """Indented lines that begin with "skylut" and a word; two blanks divide an example from what it is."""
    for line in text.splitlines():
        if line.startswith("  skylut ") and not line.startswith("  skylut  "):
            yield shlex.split(line.strip().split("  ")[0])[1:]


def quicker(arguments):
    """The same request with less to compute, where the example leaves it open."""
    arguments = list(arguments)
    if arguments[0] in ("table", "map"):
        arguments += [] if "--quality" in arguments else ["--quality", "draft"]
        arguments += [] if "--wavelengths-nm" in arguments else ["--wavelengths-nm", "400:700:50"]
    if arguments[0] == "map" and any(argument.endswith(".exr") for argument in arguments):
        if "--size" in arguments:
            arguments[arguments.index("--size") + 1] = "16"
        else:
            arguments += ["--size", "16"]
    return arguments


class Examples(unittest.TestCase):
    """Run in one folder, in the order of the documents: some read what others wrote."""

    def test_all(self):
        with Workplace(os.environ["SKYLUT_PROGRAM"]) as work:
            work.path("tests").symlink_to(ROOT / "tests")
            work.path("profiles").symlink_to(ROOT / "profiles")
            groups = {"docs/user-guide.md": list(shell_lines("docs/user-guide.md")),
                      "README.md": list(shell_lines("README.md"))}
            for command in ["", *COMMANDS]:
                page = work.run(*[command] if command else [], "--help").stdout
                groups[f"skylut {command} --help"] = list(help_lines(page))
            self.assertGreaterEqual(len(groups["README.md"]), 10)
            self.assertGreaterEqual(len(groups["docs/user-guide.md"]), 9)
            for group, examples in groups.items():
                for arguments in examples:
                    with self.subTest(f"{group}: skylut {shlex.join(arguments)}"):
                        result = work.run(*quicker(arguments))
                        self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
