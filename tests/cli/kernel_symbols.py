#!/usr/bin/env python3
"""The kernels compiled for AVX keep their code to themselves.

    kernel_symbols.py OBJECT...

A function that a kernel's object defines weakly is merged by the linker with the same function of other
objects; if the AVX copy were kept, the program would end on a machine without AVX. So every weak function must
be a template on the lane register (whose name then says __vector), different in every build.
Exit code 77 (skipped) without nm.
"""

import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77
WEAK_FUNCTIONS = {"W", "w", "u"}  # typeinfos and vtables (V) are data


def shared_functions(path):
    lines = subprocess.run(["nm", "--defined-only", "--demangle", path], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    symbols = [line.split(maxsplit=2) for line in lines]
    weak = [name for _, kind, name in symbols if kind in WEAK_FUNCTIONS]
    return len(symbols), [name for name in weak if "__vector" not in name]


def main():
    if shutil.which("nm") is None:
        print("no nm")
        return SKIPPED
    kernels = [path for path in sys.argv[1:]
               if pathlib.Path(path).name.split(".")[0] in ("kernel_portable", "kernel_avx2", "kernel_avx512")]
    if len(kernels) != 3:
        print(f"expected three kernel objects, found {kernels}")
        return 1
    wrong = 0
    for path in kernels:
        count, shared = shared_functions(path)
        print(f"{pathlib.Path(path).name}: {count} symbols, {len(shared)} shared functions")
        for name in shared:
            print(f"  {name}")
        wrong += len(shared) + (count == 0)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
