"""The continuous sky: its own accuracy against lines of sight, illuminance from pictures, what pictures and suns cost."""

import csv
import math
import pathlib
import re
import subprocess
import sys
import tempfile

from .program import ProgramFailed
from .text import Section, percent, table

# As it is built with -DSKYLUT_BUILD_BENCHMARKS=ON, beside bin/.
ACCURACY = "bench/continuous_sky_accuracy"
SKY = ("--turbidity", 0.1, "--sun-zenith-deg", 60, "--sun-azimuth-deg", 200)
PROJECTIONS = ("latlong", "fisheye", "fisheye-equisolid", "cube", "cube-cross", "octahedral")
COSTS = [("rgb", "latlong", 32), ("rgb", "latlong", 512), ("rgb", "latlong", 2048), ("spectral", "latlong", 1024)]
# Illuminance of a horizontal plane at the ground from pixels: their average radiance times the cosine of their middle.
ILLUMINANCE_TOLERANCE = 0.002
SUNS_TOLERANCE = 3.0


def add_accuracy(context, section):
    kept = context.work / "continuous-sky-accuracy.csv"
    program = pathlib.Path(context.program.path).parents[1] / ACCURACY
    section.add("### Against lines of sight")
    if not kept.exists():
        if not program.exists():
            section.add(f"Not run: `{ACCURACY}` is not built (`cmake -DSKYLUT_BUILD_BENCHMARKS=ON`, target `continuous_sky_accuracy`).")
            return
        context.say("accuracy against lines of sight: some ten minutes")
        kept.write_text(subprocess.run([program, "rural"], capture_output=True, text=True, check=True).stdout, encoding="utf-8")
    with open(kept, newline="", encoding="utf-8") as file:
        rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
    section.add("Aerosol `rural`, ground albedo 0.2; 8 wavelengths 380–730 nm; in each case 2000 random directions of the whole sphere, a quarter of "
                "them within 6° of the horizon and a quarter within 10° of the sun. *99 %*: the error that 99 of 100 directions stay "
                "below at their worst wavelength; the worst case of the line. *CPU*: building one sky of 8 wavelengths.")

    broken = [row for row in rows if not math.isfinite(row["worst"])]

    def line(label, chosen):
        numbers = [row for row in chosen if row not in broken]
        if not numbers:
            return [label, "–", "–", "–", "not a number in any of these skies, see below", "–"]
        worst = max(numbers, key=lambda row: row["worst"])
        return [label, percent(max(row["worst_Y"] for row in numbers)), percent(max(row["p99"] for row in numbers)),
                percent(worst["worst"]), f"{worst['altitude_km']:g} km, load {worst['aod500']:g}, sun {worst['sun_zenith_deg']:g}°, zenith angle "
                f"{worst['worst_zenith_deg']:.1f}°, {worst['worst_nm']:g} nm", f"{max(row['cpu_s'] for row in chosen):.2f} s"]

    lines = [line(f"{label} {value:g}{unit}", [row for row in rows if row[key] == value])
             for key, label, unit in (("altitude_km", "altitude", " km"), ("aod500", "aod500", ""), ("sun_zenith_deg", "sun", "°"))
             for value in dict.fromkeys(row[key] for row in rows)]
    section.add(table(["of the cases with", "luminance, worst", "any wavelength, 99 %", "any wavelength, worst", "there", "CPU, at most"], lines))
    if broken:
        section.add("**Not a number** in some direction, and left out above with their skies: " +
                    "; ".join(f"{row['altitude_km']:g} km, load {row['aod500']:g}, sun {row['sun_zenith_deg']:g}°, zenith angle "
                              f"{row['worst_zenith_deg']:.2f}°" for row in broken[:8]) + (f"; and {len(broken) - 8} more." if len(broken) > 8 else "."))
    section.check("the continuous sky is a number everywhere", f"{len(rows)} skies × 2000 directions", f"not in {len(broken)} skies", "0",
                  not broken)
    quick = [row for row in rows if row["sun_zenith_deg"] <= 88]
    section.check("lines of sight, the continuous sky's luminance", f"{len(rows)} skies × 2000 directions",
                  f"worst {percent(max(row['worst_Y'] for row in rows))}; suns to 88°: {percent(max(row['worst_Y'] for row in quick))}", "–", None)


def illuminance(pictures):
    """Of a horizontal plane, lux, from luminance pictures with pixels' solid angles and directions by the projection's own definition."""
    import numpy  # only in sections that run
    import OpenImageIO
    from .picture_geometry import GEOMETRY
    total = 0.0
    for name, file in pictures:
        luminance = OpenImageIO.ImageBuf(str(file)).get_pixels(OpenImageIO.FLOAT).astype(float)[..., 0]
        up, solid_angle = GEOMETRY[name](*luminance.shape[::-1])
        total += float(numpy.nansum(luminance * solid_angle * numpy.maximum(up, 0)))
    return total


def add_illuminance(context, section):
    section.add("### Illuminance from pictures")
    said = context.program.run("sun", *SKY)[0]
    wanted = float(re.search(r"diffuse horizontal.* ([\d.]+) lux", said)[1])
    rows, worst = [], 0.0
    with tempfile.TemporaryDirectory() as scratch:
        for projection in PROJECTIONS:
            file = pathlib.Path(scratch) / f"{projection}.exr"
            context.program.run("map", "-o", file, "--projection", projection, "--size", 512, "--channels", "luminance", *SKY)
            faces = [(f"cube-{face}", file.with_name(f"{projection}_{face}.exr")) for face in ("px", "nx", "py", "pz", "nz")]
            found = illuminance(faces if projection == "cube" else [(projection, file)])
            worst = max(worst, abs(found / wanted - 1))
            rows.append([f"`{projection}`", f"{found:.1f}", percent(found / wanted - 1, sign=True)])
    section.add(f"Sun at 60°, load 0.1, at the ground, 512 pixels: the sum over the pixels above the horizon of luminance × solid angle × cosine, with directions "
                f"and solid angles computed here. `skylut sun` says {wanted:g} lux.")
    section.add(table(["projection", "lux", "difference"], rows))
    section.check("`skylut sun`, diffuse illuminance from pictures", f"{len(PROJECTIONS)} projections, 512 pixels", f"worst {percent(worst)}",
                  percent(ILLUMINANCE_TOLERANCE), worst <= ILLUMINANCE_TOLERANCE)


# A small process of its own, because a child's peak memory begins with that of the process that starts it.
MEASURE = """import resource, subprocess, sys
code = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL).returncode
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(used.ru_utime + used.ru_stime, used.ru_maxrss)
sys.exit(code)"""


def cost(context, *arguments):
    """CPU seconds and peak memory in MB of one run of the program on one thread."""
    done = subprocess.run([sys.executable, "-c", MEASURE, context.program.path, *map(str, arguments), "--threads", "1"],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise ProgramFailed(f"skylut {' '.join(map(str, arguments))}: {done.stderr.strip()}")
    seconds, kilobytes = map(float, done.stdout.split())
    return seconds, kilobytes / 1024


def add_costs(context, section):
    section.add("### What pictures and suns cost")
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        for channels, projection, size in COSTS:
            context.say(f"{channels} {2 * size} × {size}")
            seconds, megabytes = cost(context, "map", "-o", pathlib.Path(scratch) / "sky.exr", "--projection", projection, "--size", size,
                                      "--channels", channels, *SKY)
            rows.append([f"{channels}, {2 * size} × {size}", f"{seconds:.1f}", f"{megabytes:.0f}"])
        section.add(table(["picture, 81 wavelengths", "CPU seconds", "peak memory, MB"], rows))
        times = {}
        for count in (4, 40):
            suns = ",".join(f"{2 * i * 40 // count}:{9 * i * 40 // count}" for i in range(count))
            context.say(f"{count} suns")
            times[count] = cost(context, "table", "--out", pathlib.Path(scratch) / f"table{count}", "--suns", suns)[0]
    ratio = times[40] / times[4]
    section.add(f"`skylut table` with its five altitudes and three loads: 4 suns of distinct zenith angle and azimuth {times[4]:.1f} s, "
                f"40 suns {times[40]:.1f} s, {ratio:.1f} times as much for ten times the skies and fits.")
    section.check("cost of suns", "`skylut table`, 40 suns against 4", f"{ratio:.1f} times the CPU", "–", None)


def run(context):
    section = Section("Continuous sky")
    add_accuracy(context, section)
    add_illuminance(context, section)
    add_costs(context, section)
    section.add("Rerun: `tools/validate --only continuous-sky`; remove `continuous-sky-accuracy.csv` from its `--work` folder to measure the "
                "first table again.")
    return section
