"""A measured sky: Ithaca, 2013-05-27 (Kider et al. 2014), which published models were compared with (Bruneton 2017)."""

import csv
import pathlib
import tempfile

import numpy

from .program import read_csv
from .text import Section, table

# Of Bruneton 2017, table 2: RMS over 17 scans.
PUBLISHED = [("Preetham", 88.1), ("O'Neal", 49.5), ("Hosek–Wilkie", 41.5), ("Nishita 93", 26.6), ("Nishita 96", 18.3),
             ("Haber", 14.7), ("Bruneton", 11.3), ("Elek", 11.3)]
# Aerosol and its optical depth at 500 nm, chosen from a coarse grid with unpolarised light.
AIRS = [("urban", 0.10), ("continental-average", 0.085), ("rural", 0.087)]
PLACE = ["--latitude", "42.44337", "--longitude", "-76.48163", "--date", "2013-05-27", "--pressure-hpa", "985",
         "--albedo", "grass"]
WAVELENGTHS_NM = 360.0 + 11.75 * numpy.arange(31)
GRID_NM = numpy.arange(360.0, 721.0, 5.0)
UNRELIABLE = 0  # sample of every scan; the mean of its neighbours stands in
AROUND_SUN_DEG = 10.0
SIDEWAYS_DEG = (70.0, 110.0)


def rows_of(path):
    """Text cells by column; lines that begin with # are left out."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def load(folder):
    """Scans: sun (zenith angle, azimuth in the instrument's frame), directions, radiances on GRID_NM."""
    suns = {row["time"]: row for row in rows_of(folder / "ithaca_2013-05-27_suns.csv")}
    scans = {}
    for row in rows_of(folder / "ithaca_2013-05-27.csv"):
        scans.setdefault(row["time"], []).append(row)
    for time, rows in scans.items():
        views = numpy.array([[float(row["zenith_deg"]), float(row["azimuth_deg"])] for row in rows])
        light = numpy.array([[float(row[f"L_{nm:.0f}"]) for nm in GRID_NM] for row in rows])
        around = numpy.flatnonzero(abs(views[:, 0] - views[UNRELIABLE, 0]) < 1e-6)
        light[UNRELIABLE] = light[[around[1], around[-1]]].mean(axis=0)
        sun = suns[time]
        yield float(sun["sun_zenith_deg"]), float(sun["sun_azimuth_deg_estimated"]), views, light


def at_test_wavelengths(light):
    """Linear between the 5 nm means."""
    return numpy.array([numpy.interp(WAVELENGTHS_NM, GRID_NM, row) for row in light])


def ours(context, folder, scan, aerosol, aod500, *options):
    """Radiances in mW m⁻² sr⁻¹ nm⁻¹ in the scan's directions."""
    sun_zenith, sun_azimuth, views, _ = scan
    (folder / "views.csv").write_text("zenith_deg,azimuth_deg\n" + "".join(f"{z},{a}\n" for z, a in views))
    context.program.run("map", "-o", folder / "sky.csv", "--directions", folder / "views.csv", "--aerosol", aerosol,
                        "--turbidity", aod500, "--sun-zenith-deg", sun_zenith, "--sun-azimuth-deg", sun_azimuth % 360,
                        "--wavelengths-nm", "360:720:5", "--height-m", "270", "--threads", 1, *PLACE, *options)
    rows = read_csv(folder / "sky.csv")
    return 1e3 * numpy.array([[row[f"L_{nm:.0f}"] for nm in GRID_NM] for row in rows])


def sun_distance_deg(scan):
    """Angle of every direction from the sun."""
    sun_zenith, sun_azimuth, views, _ = scan
    sun, zenith = numpy.radians(sun_zenith), numpy.radians(views[:, 0])
    cosine = (numpy.cos(sun) * numpy.cos(zenith)
              + numpy.sin(sun) * numpy.sin(zenith) * numpy.cos(numpy.radians(views[:, 1] - sun_azimuth)))
    return numpy.degrees(numpy.arccos(numpy.clip(cosine, -1, 1)))


def run(context):
    section = Section("A measured sky")
    folder = context.reference / "measured"
    if not (folder / "ithaca_2013-05-27.csv").exists():
        section.add("Skipped: no `measured/ithaca_2013-05-27.csv` in the reference folder.")
        return section
    scans = list(load(folder))
    angles = numpy.concatenate([sun_distance_deg(scan) for scan in scans])
    measured = numpy.concatenate([at_test_wavelengths(scan[3]) for scan in scans])
    far = angles > AROUND_SUN_DEG
    sideways = (angles > SIDEWAYS_DEG[0]) & (angles < SIDEWAYS_DEG[1])
    blue = (WAVELENGTHS_NM > 380) & (WAVELENGTHS_NM < 500)
    rows, best = [], numpy.inf
    with tempfile.TemporaryDirectory(prefix="skylut-validate-") as name:
        for aerosol, aod500 in AIRS:
            for light, options in (("polarised", []), ("`--scalar`", ["--scalar"])):
                context.say(f"{aerosol}, {light}")
                found = numpy.concatenate([at_test_wavelengths(ours(context, pathlib.Path(name), scan, aerosol, aod500, *options))
                                           for scan in scans])
                error = found - measured
                rms = numpy.sqrt((error**2).mean())
                if not options:
                    best = min(best, rms)
                excess = found[sideways][:, blue].mean() / measured[sideways][:, blue].mean() - 1.0
                rows.append([aerosol, f"{aod500:g}", light, f"{rms:.2f}", f"{numpy.sqrt((error[far]**2).mean()):.2f}",
                             f"{100 * excess:+.1f} %"])
    section.add(f"Ithaca NY, 2013-05-27, {len(scans)} scans of 81 directions (Kider et al. 2014): root mean square of model − measured "
                "over scans, directions and the 31 wavelengths of Bruneton 2017 "
                f"(doi:10.1109/TVCG.2016.2622272), mW m⁻² sr⁻¹ nm⁻¹; mean measured {measured.mean():.1f}. Beside it the same beyond "
                f"{AROUND_SUN_DEG:g}° from the sun, and our excess at 70–110° from the sun, 380–500 nm, where polarisation is strongest. "
                "Air: 985 hPa, grass; optical depths at 500 nm from a coarse grid.")
    section.add(table(["aerosol", "depth", "light", "RMS", "RMS beyond 10°", "excess at 70–110°"], rows))
    section.add("Published for 17 scans of that day: " + ", ".join(f"{model} {value:g}" for model, value in PUBLISHED) + ".")
    section.check("measured sky, Ithaca", f"{len(scans)} scans, best of {len(AIRS)} aerosols", f"RMS {best:.2f}",
                  "11.3 (best published)", best < 11.3)
    section.add("Rerun: `tools/validate --only measured`.")
    return section
