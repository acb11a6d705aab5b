"""Running skylut, and how much CPU time it took."""

import csv
import json
import os
import pathlib
import subprocess
import tempfile


class Program:
    """The program under test. Times are CPU seconds (user + system), which other work on the machine hardly
    changes; every run uses one thread, so that they are also the wall time of an idle core."""

    def __init__(self, path):
        self.path = str(path.resolve())
        self.version = self.run("--version")[0].split()[-1]

    def run(self, *arguments, simd=None):
        """Standard output and CPU seconds; stops the validation if the program fails."""
        environment = dict(os.environ)
        if simd:
            environment["SKYLUT_SIMD"] = simd
        with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as err:
            child = subprocess.Popen([self.path, *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=out,
                                     stderr=err, env=environment)
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0)
            err.seek(0)
            if child.returncode != 0:
                raise ProgramFailed(f"skylut {' '.join(map(str, arguments))}: exit {child.returncode}: {err.read().strip()}")
            return out.read(), usage.ru_utime + usage.ru_stime

    def solve(self, case, *options, simd=None):
        """The answer to a solver case (a path, or the document itself) and its CPU seconds."""
        if isinstance(case, (str, pathlib.Path)):
            text, seconds = self.run("solve", case, "-o", "-", "--threads", 1, *options, simd=simd)
        else:
            with tempfile.TemporaryDirectory(prefix="skylut-validate-") as folder:
                path = pathlib.Path(folder) / "case.json"
                path.write_text(json.dumps(case), encoding="utf-8")
                text, seconds = self.run("solve", path, "-o", "-", "--threads", 1, *options, simd=simd)
        return json.loads(text), seconds

    def table(self, folder, *options, simd=None):
        """Writes a table with maps into the folder; CPU seconds."""
        return self.run("table", "--out", folder, "--threads", 1, *options, simd=simd)[1]


class ProgramFailed(RuntimeError):
    """The program ended with another exit code than 0."""


def read_csv(path):
    """Rows of numbers, by column; lines that begin with # are left out."""
    with open(path, newline="", encoding="utf-8") as file:
        return [{name: float(value) for name, value in row.items()}
                for row in csv.DictReader(line for line in file if not line.startswith("#"))]
