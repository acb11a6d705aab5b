#!/usr/bin/env python3
"""What is left of a run that is stopped: nothing, and the exit code says which signal it was."""

import os
import pathlib
import resource
import signal
import subprocess
import time
import unittest

from expect import Workplace

MAP = ["map", "-o", "sky.csv", "--sun-zenith-deg", "45", "--wavelengths-nm", "400:700:50", "--quality", "draft"]


def starts_handling(pid, number):
    """Waits until the program has set its handler, which it does first of all."""
    for _ in range(1000):
        for line in pathlib.Path(f"/proc/{pid}/status").read_text(encoding="ascii").splitlines():
            if line.startswith("SigCgt:") and int(line.split()[1], 16) >> (number - 1) & 1:
                return True
        time.sleep(0.01)
    return False


class Stopped(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])

    def tearDown(self):
        self.work.__exit__()

    def run_with(self, preexec, *arguments):
        return subprocess.run([self.work.program, *arguments], cwd=self.work.folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, preexec_fn=preexec, timeout=600, check=False).returncode

    def test_every_signal_during_the_computation(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE, signal.SIGXCPU, signal.SIGXFSZ):
            with self.subTest(number.name), subprocess.Popen(
                    [self.work.program, "table", "--out", "out"], cwd=self.work.folder,
                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as program:
                self.assertTrue(starts_handling(program.pid, number))
                time.sleep(0.1)
                program.send_signal(number)
                self.assertEqual(program.wait(timeout=60), 128 + number)
                self.assertEqual(self.work.contents(), {})

    def test_a_series_leaves_whole_frames(self):
        suns = ",".join(f"{zenith / 100}:90" for zenith in range(1000, 5000, 10))
        with subprocess.Popen([self.work.program, *MAP[:2], "sky.exr", "--suns", suns, "--size", "16", *MAP[5:]],
                              cwd=self.work.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as program:
            while not list(self.work.folder.glob("sky_*.exr")):
                self.assertIsNone(program.poll())
                time.sleep(0.01)
            program.send_signal(signal.SIGINT)
            self.assertEqual(program.wait(timeout=60), 128 + signal.SIGINT)
        left = self.work.contents()
        self.assertTrue(all(name.startswith("sky_0") and name.endswith(".exr") for name in left), list(left))

    def test_the_limit_on_file_size_stops_the_write_itself(self):
        self.work.write("sky.csv", "old")
        code = self.run_with(lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, resource.RLIM_INFINITY)), *MAP)
        self.assertEqual(code, 128 + signal.SIGXFSZ)
        self.assertEqual(self.work.contents(), {"sky.csv": b"old"})

    def test_the_limit_on_cpu_time(self):
        code = self.run_with(lambda: resource.setrlimit(resource.RLIMIT_CPU, (1, resource.RLIM_INFINITY)),
                             "table", "--out", "out", "--quality", "reference")
        self.assertEqual(code, 128 + signal.SIGXCPU)
        self.assertEqual(self.work.contents(), {})

    def test_a_reader_that_goes_away(self):
        reading, writing = os.pipe()
        os.close(reading)
        code = subprocess.run([self.work.program, "profile", "show", "ussa1976"], stdout=writing,
                              stderr=subprocess.DEVNULL, check=False).returncode
        os.close(writing)
        self.assertEqual(code, 128 + signal.SIGPIPE)

    def test_nohup_holds(self):
        """A signal that was ignored at the start stays ignored."""
        with subprocess.Popen([self.work.program, *MAP], cwd=self.work.folder, stdout=subprocess.DEVNULL,
                              preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)) as program:
            self.assertTrue(starts_handling(program.pid, signal.SIGTERM))
            program.send_signal(signal.SIGHUP)
            self.assertEqual(program.wait(timeout=60), 0)

    def test_the_next_run_clears_what_a_killed_one_left(self):
        self.work.write("sky.csv.skylut-0123456789abcdef.tmp", "half")
        self.work.succeed(*MAP)
        self.assertEqual(list(self.work.contents()), ["sky.csv"])


if __name__ == "__main__":
    unittest.main()
