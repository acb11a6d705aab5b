"""The sky that the clients are asked about: its pictures, and its radiance along lines of sight."""

import csv
import math
import re
import subprocess

SUN_ZENITH_DEG, SUN_AZIMUTH_DEG = 55, 230
AIR = ("--turbidity", "0.1", f"--sun-zenith-deg={SUN_ZENITH_DEG}", f"--sun-azimuth-deg={SUN_AZIMUTH_DEG}")
# Not the very zenith: Blender blends the first row with the last there. No two are mirror images of each other, so that a client that mirrors or turns a picture is noticed; two look at the ground.
DIRECTIONS = [(1, 0), (20, 60), (45, 290), (60, 10), (65, 110), (75, 200), (80, 330), (86, 75), (110, 45), (150, 250)]
# Of the size asked for. pbrt takes the nearest pixel and does not interpolate.
SIZE_RATIO = {"latlong": 1, "cube": 0.5, "octahedral": 2}
# XYZ to linear Rec. 709 (IEC 61966-2-1).
RGB_OF_XYZ = ((3.2406, -1.5372, -0.4986), (-0.9689, 1.8758, 0.0415), (0.0557, -0.2040, 1.0570))


def vector(zenith_deg, azimuth_deg):
    """(east, north, up)"""
    zenith, azimuth = math.radians(zenith_deg), math.radians(azimuth_deg)
    return (math.sin(zenith) * math.sin(azimuth), math.sin(zenith) * math.cos(azimuth), math.cos(zenith))


def angles(east, north, up):
    """Zenith angle and azimuth of a vector of any length, degrees."""
    return (math.degrees(math.atan2(math.hypot(east, north), up)), math.degrees(math.atan2(east, north)) % 360)


def between_deg(a, b):
    """Angle between two directions, each (zenith, azimuth) in degrees."""
    cosine = sum(p * q for p, q in zip(vector(*a), vector(*b)))
    return math.degrees(math.acos(max(-1.0, min(1.0, cosine))))


def around_sun(count=37, radius_deg=1.0):
    """Directions that fill a disc about the sun evenly: Vogel's spiral."""
    toward = vector(SUN_ZENITH_DEG, SUN_AZIMUTH_DEG)
    down = vector(SUN_ZENITH_DEG + 90, SUN_AZIMUTH_DEG)
    aside = vector(90, SUN_AZIMUTH_DEG + 90)
    directions = []
    for i in range(count):
        distance, turn = math.radians(radius_deg) * math.sqrt((i + 0.5) / count), i * math.radians(137.50776)
        x, y = math.tan(distance) * math.cos(turn), math.tan(distance) * math.sin(turn)
        directions.append(angles(*(t + x * d + y * a for t, d, a in zip(toward, down, aside))))
    return directions


class Sky:
    """Calls the program; keeps the pictures in a folder."""

    def __init__(self, program, folder, size):
        self.program, self.folder, self.size = program, folder, size

    def run(self, *arguments):
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"skylut {' '.join(map(str, arguments))}: {done.stderr.strip()}")
        return done.stdout

    def picture(self, projection):
        """The file, or of a cube the pattern with {} for the face; made when first asked for."""
        size = round(self.size * SIZE_RATIO[projection])
        file = self.folder / f"{projection}-{size}.exr"
        pattern = self.folder / f"{projection}-{size}_{{}}.exr" if projection == "cube" else file
        probe = str(pattern).format("px")
        if not (self.folder / probe).exists():
            self.run("map", "-o", file, "--projection", projection, "--size", size, *AIR)
        return pattern

    def exact_rgb(self, directions):
        """Linear Rec. 709 in cd/m2 by lines of sight, not through any picture."""
        asked, answer = self.folder / "directions.csv", self.folder / "answer.csv"
        asked.write_text("zenith_deg,azimuth_deg\n" + "".join(f"{z!r},{a!r}\n" for z, a in directions), encoding="utf-8")
        self.run("map", "-o", answer, "--directions", asked, "--exact", *AIR)
        with open(answer, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        return [rgb_of_yxy(*(float(row[name]) for name in ("Y_cd_m2", "x", "y"))) for row in rows]

    def illuminance_rgb(self):
        """What `skylut sun` says of the light in linear Rec. 709, lux: the sun's on a plane normal to it, the sky's on the horizontal."""
        said = self.run("sun", *AIR)
        return tuple([float(number) for number in re.search(rf"^ *{words} .*$", said, re.MULTILINE)[0].split()[-3:]]
                     for words in ("sun, normal to it", "sky, on the horizontal"))


def rgb_of_yxy(luminance, x, y):
    xyz = (luminance * x / y, luminance, luminance * (1 - x - y) / y)
    return [sum(weight * value for weight, value in zip(row, xyz)) for row in RGB_OF_XYZ]
