#!/usr/bin/env python3
"""The program carries the hardening it was built with: hardening.py PROGRAM BUILD_TYPE."""

import re
import shutil
import subprocess
import sys

SKIPPED = 77


def main():
    program, build_type = sys.argv[1:]
    if shutil.which("readelf") is None:
        print("readelf is not installed")
        return SKIPPED
    said = subprocess.run(["readelf", "--wide", "--file-header", "--dynamic", "--program-headers", "--symbols", program],
                          check=True, capture_output=True, text=True).stdout
    wanted = {
        "position-independent executable": r"Type:\s+DYN",
        "PIE flag": r"FLAGS_1.*\bPIE\b",
        "all symbols bound at the start": r"\bBIND_NOW\b|FLAGS_1.*\bNOW\b",
        "read-only relocations": r"GNU_RELRO",
        "stack that cannot be executed": r"GNU_STACK\s+\S+\s+\S+\s+\S+\s+\S+\s+\S+\s+RW\s",
        "stack protector": r"__stack_chk_fail",
    }
    if build_type != "Debug":
        wanted["FORTIFY"] = r"__\w+_chk\b(?<!__stack_chk)"
    wrong = [name for name, pattern in wanted.items() if not re.search(pattern, said)]
    print("missing: " + ", ".join(wrong) if wrong else f"{len(wanted)} protections found")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
