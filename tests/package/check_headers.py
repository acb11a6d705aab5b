#!/usr/bin/env python3
"""Compiles every installed header alone: each must bring what it needs and include no private one.

    check_headers.py PREFIX COMPILER
"""

import concurrent.futures
import pathlib
import subprocess
import sys


def words_of(compiler, include, header):
    """@return what the compiler says, empty if the header stands alone"""
    result = subprocess.run([compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-x", "c++",
                             "-I", str(include), "-"],
                            input=f'#include "{header}"\n', capture_output=True, text=True, check=False)
    return "" if result.returncode == 0 else f"{header} does not stand alone:\n{result.stderr}"


def main():
    include = pathlib.Path(sys.argv[1]) / "include"
    headers = sorted(str(path.relative_to(include)) for path in include.rglob("*.hpp"))
    if len(headers) < 50:
        print(f"only {len(headers)} headers below {include}")
        return 1
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        wrong = [words for words in pool.map(lambda header: words_of(sys.argv[2], include, header), headers) if words]
    print("\n".join(wrong) if wrong else f"{len(headers)} headers stand alone")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
