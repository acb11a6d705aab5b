"""The clients: what each needs, and how it is asked."""

import importlib.util
import json
import os
import pathlib
import shutil
import subprocess

import lookups
from sky import DIRECTIONS, SUN_AZIMUTH_DEG, SUN_ZENITH_DEG, angles, around_sun, between_deg, vector

HERE = pathlib.Path(__file__).resolve().parent
SUN = (SUN_ZENITH_DEG, SUN_AZIMUTH_DEG)
AUREOLE = around_sun()
ASKED = [vector(*direction) for direction in DIRECTIONS + AUREOLE]
# Pictures hold averages over pixels and clients interpolate; sky and lines of sight differ by up to 0.3 %.
RADIANCE_TOLERANCE = 0.005


def finding(what, error, tolerance, shown=None):
    return {"what": what, "found": shown or f"{100 * error:.2f} %", "wanted": f"{100 * tolerance:.1f} %", "met": bool(error <= tolerance)}


def difference(found, exact):
    """The largest relative difference of the channels."""
    return max(abs(f / e - 1) for f, e in zip(found, exact))


def mean(colours):
    return [sum(channel) / len(colours) for channel in zip(*colours)]


def compare(sky, what, rgb, brightest):
    """Radiance in the directions ASKED; and that the brightest pixel, of views or steps of half a degree, is the sun's. Right at the
    sun the aureole is sharper than pixels: there the mean of a disc of 1° is compared."""
    exact = sky.exact_rgb(DIRECTIONS + AUREOLE)
    worst = max(range(len(DIRECTIONS)), key=lambda i: difference(rgb[i], exact[i]))
    error = difference(rgb[worst], exact[worst])
    zenith, azimuth = DIRECTIONS[worst]
    yield finding(f"{what}, ten directions", error, RADIANCE_TOLERANCE, f"{100 * error:.2f} %, at {zenith}°, {azimuth}°")
    rest = len(DIRECTIONS)
    yield finding(f"{what}, mean within 1° of the sun", difference(mean(rgb[rest:]), mean(exact[rest:])), RADIANCE_TOLERANCE)
    away = between_deg(angles(*brightest), SUN)
    yield {"what": f"{what}, brightest direction from the sun", "found": f"{away:.2f}°", "wanted": "0.5°", "met": bool(away <= 0.5)}


class Blender:
    needs = "blender in the PATH (Debian: blender)"

    def lacking(self, _):
        return None if shutil.which("blender") else "no program blender in the PATH"

    def run(self, sky, work):
        sun_rgb, sky_rgb = sky.illuminance_rgb()
        request, answer = work / "blender-request.json", work / "blender-answer.json"
        request.write_text(json.dumps({"picture": str(sky.picture("latlong")), "directions": ASKED,
                                       "sun": vector(*SUN), "sun_rgb_lux": sun_rgb}), encoding="utf-8")
        # Blender looks for its Python's modules beside the first python3 in the PATH: Debian's.
        environment = {**os.environ, "PATH": os.pathsep.join(["/usr/bin", os.environ["PATH"]])}
        done = subprocess.run([shutil.which("blender"), "-b", "--factory-startup", "--python-exit-code", "1", "-P", HERE / "blender_lookup.py",
                               "--", request, answer], capture_output=True, text=True, check=False, env=environment)
        if done.returncode != 0:
            raise RuntimeError(f"blender: {(done.stderr or done.stdout).strip()[-2000:]}")
        seen = json.loads(answer.read_text(encoding="utf-8"))
        name = f"Blender {seen['version']}"
        yield from compare(sky, name, seen["rgb"], seen["brightest"])
        yield finding(f"{name}, white plane under the sky", difference(seen["sky_on_horizontal"], sky_rgb), 0.01)
        both = [s + l * vector(*SUN)[2] for s, l in zip(sky_rgb, sun_rgb)]
        yield finding(f"{name}, the same with a sun lamp", difference(seen["both_on_horizontal"], both), 0.01)
        away = between_deg(angles(*seen["shadow"], 0), (90, SUN_AZIMUTH_DEG + 180))
        yield {"what": f"{name}, a pole's shadow from where it should fall", "found": f"{away:.2f}°", "wanted": "1.0°", "met": away <= 1}


class ThreeJs:
    needs = "node, chromium and the npm package three (npm install --prefix out/clients three)"

    def lacking(self, work):
        for program in ("node", "chromium"):
            if not shutil.which(program):
                return f"no program {program} in the PATH"
        if not (work / "node_modules/three").is_dir():
            return f"no package three (npm install --prefix {work} three)"
        return None

    def run(self, sky, work):
        sun_rgb, sky_rgb = sky.illuminance_rgb()
        request = {"latlong": sky.picture("latlong").name, "cube": sky.picture("cube").name,
                   "directions": ASKED, "sun": vector(*SUN), "sun_rgb_lux": sun_rgb}
        (work / "threejs-request.json").write_text(json.dumps(request), encoding="utf-8")
        done = subprocess.run(["node", HERE / "threejs_lookup.mjs", work], capture_output=True, text=True, check=False, timeout=600)
        if done.returncode != 0:
            raise RuntimeError(f"three.js: {(done.stderr or done.stdout).strip()[-2000:]}")
        seen = json.loads(done.stdout)
        for picture in ("latlong", "cube"):
            name = f"three.js r{seen['revision']}, {picture}"
            yield from compare(sky, name, seen[picture]["rgb"], seen[picture]["brightest"])
        name = f"three.js r{seen['revision']}"
        # What three.js makes of an environment for surfaces (PMREM) is coarse by its design.
        yield finding(f"{name}, white plane under the sky", difference(seen["sky_on_horizontal"], sky_rgb), 0.05)
        direct = [value * vector(*SUN)[2] for value in sun_rgb]
        yield finding(f"{name}, white plane under a sun lamp alone", difference(seen["sun_on_horizontal"], direct), 0.005)


class Documented:
    """A lookup of lookups.py."""

    needs = "python3-openimageio"

    def __init__(self, lookup, projection):
        self.lookup, self.projection = lookup, projection

    def lacking(self, _):
        return None if importlib.util.find_spec("OpenImageIO") else "no Python module OpenImageIO"

    def run(self, sky, _):
        import OpenImageIO  # only where it is there
        picture = OpenImageIO.ImageBuf(str(sky.picture(self.projection)))
        width, height = picture.spec().width, picture.spec().height

        def pixel(column, row):
            return picture.getpixel(column, row)[:3]

        name = f"{self.lookup.__name__} as documented"
        # Everywhere in steps of five degrees, of one degree around the sun and where a mirrored or turned picture would have it.
        suns = [(zenith, azimuth) for zenith in (55, 125) for azimuth in (50, 130, 230, 310)]
        places = [(zenith, azimuth) for zenith in range(181) for azimuth in range(360)
                  if zenith % 5 == azimuth % 5 == 0 or min(between_deg((zenith, azimuth), sun) for sun in suns) < 10]
        brightest = max(places, key=lambda place: self.lookup(pixel, width, height, vector(*place))[1])
        yield from compare(sky, name, [self.lookup(pixel, width, height, d) for d in ASKED], vector(*brightest))


CLIENTS = {
    "blender": Blender(),
    "threejs": ThreeJs(),
    "pbrt": Documented(lookups.pbrt, "octahedral"),
    "mitsuba": Documented(lookups.mitsuba, "latlong"),
    "openexr": Documented(lookups.openexr_latlong, "latlong"),
}
