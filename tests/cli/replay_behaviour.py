#!/usr/bin/env python3
"""The command that a file records makes the same file again, through a shell, whatever the names of its inputs."""

import json
import os
import pathlib
import shutil
import subprocess
import unittest

from expect import Workplace

SOURCE = pathlib.Path(__file__).resolve().parents[2]
COARSE = ["--wavelengths-nm", "400:700:50", "--quality", "draft"]
# What a shell would split, expand or end a word at.
NAME = "my dir/it's $HOME `x` \"y\" *;&.{}"
OF_AIR = ["--humidity", "80", "--ozone-du", "+250", "--water-cm", "2", "--no2-du", "0.3", "--pressure-hpa", "1e3",
          "--latitude", "-33.9", "--longitude", "18:25E", "--height-m", "-5", "--turbidity-kind", "preetham-t"]


class Replay(unittest.TestCase):
    def setUp(self):
        self.work = Workplace(os.environ["SKYLUT_PROGRAM"])
        self.addCleanup(self.work.__exit__)
        self.work.path("my dir").mkdir()
        (self.work.path("bin")).mkdir()
        (self.work.path("bin/skylut")).symlink_to(self.work.program)
        shutil.copy(SOURCE / "profiles/tropical.toml", self.work.path(NAME.format("toml")))
        shutil.copy(SOURCE / "profiles/aerosols/urban.toml", self.work.path(NAME.format("aerosol.toml")))
        self.work.write(NAME.format("albedo.csv"), "wavelength_nm,albedo\n300,0.1\n1000,0.4\n")
        self.work.write(NAME.format("sun.csv"), "wavelength_nm,irradiance_W_m2_nm\n300,1.0\n1000,0.7\n")
        self.files = ["--aerosol", NAME.format("aerosol.toml"), "--albedo", NAME.format("albedo.csv")]
        self.scene = ["--profile", NAME.format("toml"), *self.files, "--solar", NAME.format("sun.csv")]

    def command_of(self, path):
        """The command that a file records: in JSON, in a comment line, in an attribute of a picture."""
        data = self.work.path(path).read_bytes()
        if path.endswith(".json"):
            answer = json.loads(data)
            # A solved case keeps what it says of itself: its own command made the case, not the answer.
            return answer["provenance"]["command"] if "results" in answer else answer["command"]
        if path.endswith(".csv"):
            lines = data.decode("utf-8").splitlines()
            return next(line for line in lines if line.startswith("# command: "))[len("# command: "):]
        # OpenEXR: name, type, each ended by 0, then the length in four bytes and the text.
        at = data.index(b"skylutCommand\0string\0") + len(b"skylutCommand\0string\0")
        length = int.from_bytes(data[at:at + 4], "little")
        return data[at + 4:at + 4 + length].decode("utf-8")

    def air_of(self, path):
        """The description of the air that a file records."""
        data = self.work.path(path).read_bytes()
        if path.endswith(".json"):
            return json.loads(data)["inputs"]["air"]
        if path.endswith(".csv"):
            lines = data.decode("utf-8").splitlines()
            provenance = next(line for line in lines if line.startswith("# provenance: "))
            return json.loads(provenance[len("# provenance: "):])["inputs"]["air"]
        at = data.index(b"skylutProvenance\0string\0") + len(b"skylutProvenance\0string\0")
        length = int.from_bytes(data[at:at + 4], "little")
        return json.loads(data[at + 4:at + 4 + length])["inputs"]["air"]

    def replay(self, path, output_option, output):
        """Runs the command of a file through a shell, with another output; the shell must find the program."""
        command = self.command_of(path)
        self.assertTrue(command.startswith("skylut "), command)
        environment = dict(os.environ, PATH=f"{self.work.path('bin')}:{os.environ['PATH']}", HOME="/nowhere")
        result = subprocess.run(["sh", "-c", f"{command} {output_option} {output}"], cwd=self.work.folder,
                                env=environment, capture_output=True, text=True, timeout=600)
        self.assertEqual(result.returncode, 0, f"{command}: {result.stderr}")
        return command

    def same(self, one, two):
        self.assertTrue(self.work.path(one).read_bytes() == self.work.path(two).read_bytes(), f"{one} and {two} differ")

    def test_table(self):
        self.work.succeed("table", "--out", "one", *self.scene, *OF_AIR, *COARSE, "--altitudes-km", "0, 3",
                          "--turbidities", "+2,3", "--suns", "60:-90,20:400", "--weights", "solid-angle",
                          "--date", "2024-01-03", "--save-maps", "--threads", "2")
        command = self.replay("one/table.json", "--out", "two")
        self.assertNotIn("--threads", command)
        self.assertNotIn("--out", command)
        for name in ("table.json", "table.csv", "maps/entry_001.csv", "maps/entry_008.csv"):
            self.same(f"one/{name}", f"two/{name}")

    def test_table_of_defaults_spells_them_out(self):
        self.work.succeed("table", "--out", "one", *COARSE, "--altitudes-km", "0", "--turbidities", "0.1", "--suns", "45:90")
        command = self.replay("one/table.json", "--out", "two")
        for option in ("--profile ussa1976", "--aerosol rural", "--albedo 0.2", "--solar astm-g173", "--weights horizon", "--directions dome",
                       "--turbidity-kind aod500", "--quality draft"):
            self.assertIn(f" {option}", command)
        self.same("one/table.json", "two/table.json")

    def test_sun_by_angles(self):
        self.work.succeed("sun", "-o", "one.json", *self.scene, *OF_AIR, *COARSE, "--turbidity", "3", "--altitude-km", "1",
                          "--sun-zenith-deg", "75", "--sun-azimuth-deg", "-10", "--circumsolar-deg", "2.5")
        self.replay("one.json", "-o", "two.json")
        self.same("one.json", "two.json")

    def test_sun_by_default_azimuth(self):
        self.work.succeed("sun", "-o", "one.json", "--sun-zenith-deg", "75", "--no-diffuse", *COARSE)
        self.assertIn("--sun-azimuth-deg 180", self.replay("one.json", "-o", "two.json"))
        self.same("one.json", "two.json")

    def test_sun_by_time(self):
        self.work.succeed("sun", "-o", "one.json", "--latitude", "48:51:24S", "--longitude", "2d21'03\"W", "--time",
                          "2024-06-21T14:00:01.5+02:00", "--no-diffuse", *COARSE)
        self.assertNotIn("--sun-azimuth-deg", self.replay("one.json", "-o", "two.json"))
        self.same("one.json", "two.json")

    def test_sun_by_closed_form(self):
        self.work.succeed("sun", "-o", "one.json", "--sun-zenith-deg", "60", "--model", "smarts-like", *COARSE)
        self.replay("one.json", "-o", "two.json")
        self.same("one.json", "two.json")

    def test_sky_as_numbers(self):
        self.work.write(NAME.format("views.csv"), "zenith_deg,azimuth_deg\n0,0\n60,-90\n")
        self.work.succeed("map", "-o", "one.csv", *self.scene, *OF_AIR, *COARSE, "--turbidity", "3", "--altitude-km", "1",
                          "--sun-zenith-deg", "75", "--sun-azimuth-deg", "-10", "--directions", NAME.format("views.csv"))
        command = self.replay("one.csv", "-o", "two.csv")
        self.assertNotIn("--projection", command)
        self.same("one.csv", "two.csv")

    def test_sky_as_a_picture(self):
        self.work.succeed("map", "-o", "one.exr", *self.scene, *OF_AIR, *COARSE, "--turbidity", "3", "--time",
                          "2024-06-21T11:00Z", "--size", "8", "--channels", "rgb,spectral")
        command = self.replay("one_rgb.exr", "-o", "two.exr")
        self.assertNotIn("--directions", command)
        self.same("one_rgb.exr", "two_rgb.exr")
        self.same("one_spectral.exr", "two_spectral.exr")

    def test_a_sun_beside_its_sky(self):
        self.work.succeed("map", "-o", "one.exr", *COARSE, "--sun-zenith-deg", "75", "--size", "8", "--sun", "file")
        self.assertIn("--sun file", self.replay("one_sun.exr", "-o", "two.exr"))
        self.same("one.exr", "two.exr")
        self.same("one_sun.exr", "two_sun.exr")

    def test_frames_of_a_series(self):
        in_place = [*self.files, *OF_AIR, "--turbidity", "3"]
        for suns in (["--suns", "80:90,60:400"], ["--times", NAME.format("times.csv"), *in_place],
                     ["--time", "2024-06-21T09:00Z/2024-06-21T13:00+02:00/2h", *in_place]):
            self.work.write(NAME.format("times.csv"), "time\n2024-06-21T09:00Z\n2024-06-21T11:00Z\n")
            self.work.succeed("map", "-o", "one.exr", *COARSE, *suns, "--size", "8", "--sun", "disc")
            self.assertIn(" --frame 2", self.replay("one_0002.exr", "-o", "two.exr"))
            self.assertFalse(self.work.path("two_0001.exr").exists() or self.work.path("two.csv").exists())
            self.same("one_0002.exr", "two_0002.exr")
            self.assertNotIn(" --frame", self.replay("one.csv", "-o", "two.exr"))
            self.same("one_0001.exr", "two_0001.exr")
            self.assertEqual(self.work.path("one.csv").read_text(encoding="utf-8").replace("one_0", "two_0"),
                             self.work.path("two.csv").read_text(encoding="utf-8"))
            for name in ("two_0001.exr", "two_0002.exr", "two.csv"):
                self.work.path(name).unlink()

    def test_profile_case(self):
        self.work.succeed("profile", "case", NAME.format("toml"), "-o", "one.json", "--wavelength-nm", "690", "--band-nm", "5",
                          "--absorption-term", "1", *self.files, *OF_AIR, "--turbidity", "2", "--altitude-km", "2",
                          "--sun-zenith-deg", "88", "--view", "0:0, 85:-90")
        self.replay("one.json", "-o", "two.json")
        self.same("one.json", "two.json")

    def test_fit_of_a_file(self):
        sky = NAME.format("sky.csv")
        self.work.succeed("map", "-o", sky, "--sun-zenith-deg", "45", *COARSE, "--profile", "tropical")
        self.work.succeed("fit", sky, "-o", "one.json")
        self.replay("one.json", "-o", "two.json")
        self.same("one.json", "two.json")

    def test_comparison(self):
        table = NAME.format("table")
        self.work.succeed("table", "--out", table, *COARSE, "--altitudes-km", "0", "--turbidities", "0.1", "--suns", "45:90")
        self.work.succeed("compare", table, "--against", "preetham1999", "-o", "one.csv")
        self.replay("one.csv", "-o", "two.csv")
        self.same("one.csv", "two.csv")

    def test_solver_case(self):
        case = NAME.format("case.json")
        self.work.succeed("profile", "case", "ussa1976", "--wavelength-nm", "550", "--sun-zenith-deg", "60", "-o", case)
        self.work.succeed("solve", case, "--quality", "draft", "-o", "one.json")
        self.replay("one.json", "-o", "two.json")
        self.same("one.json", "two.json")

    def test_other_air_is_other_provenance(self):
        for name, aerosol in ("one", "rural"), ("two", "urban"):
            scene = ["--aerosol", aerosol, "--sun-zenith-deg", "45", *COARSE]
            self.work.succeed("map", "-o", f"{name}.csv", *scene)
            self.work.succeed("map", "-o", f"{name}.exr", "--size", "4", *scene)
            self.work.succeed("table", "--out", name, "--aerosol", aerosol, *COARSE, "--altitudes-km", "0", "--turbidities",
                              "0.1", "--suns", "45:90")
        for one, two in ("one.csv", "two.csv"), ("one.exr", "two.exr"), ("one/table.json", "two/table.json"):
            self.assertNotEqual(self.command_of(one), self.command_of(two))
            self.assertNotEqual(self.air_of(one), self.air_of(two), f"{one} and {two} name the same air")


if __name__ == "__main__":
    unittest.main()
