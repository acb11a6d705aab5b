"""Polarised light: the spherical solver against MYSTIC and our own solvers, and how much it matters."""

import tempfile
import pathlib

import numpy

from . import cases
from .plane_limit import FLAT_RADIUS_KM
from .plane_parallel import rms
from .program import read_csv
from .text import Section, percent, table

STOKES = ("radiance", "stokes_q", "stokes_u")
DEVIATIONS = ("std", "std_q", "std_u")
AIRS = (("clear", 0.0), ("average", 0.1), ("hazy", 0.5))
SUNS_DEG = (0, 30, 60, 80, 88, 92, 96)
ALTITUDES_KM = (0, 12)
RINGS_DEG = (0, 15, 30, 45, 60, 75, 85, 89)


def stokes(document):
    """I, Q, U of every result, and their standard errors: two arrays [result][Stokes]."""
    results = document["results"]
    return (numpy.array([[r[name] for name in STOKES] for r in results]),
            numpy.array([[r.get(name, 0.0) for name in DEVIATIONS] for r in results]))


def polarised(document):
    """The case with polarised light."""
    return {**document, "polarised": True}


def add_mystic(context, section):
    documents = {**cases.load(context.reference / "vector_spherical", "pol_*.json"),
                 **cases.load(context.reference / "solver", "pol_*.json")}
    section.add("### MYSTIC, spherical shells")
    if not documents:
        section.add("Skipped: no `vector_spherical/pol_*.json` in the reference folder.")
        return
    rows, beyond, count = [], 0, 0
    for name, document in documents.items():
        truth, noise = stokes(document)
        ours, _ = stokes(context.program.solve(document)[0])
        error, sigma = (ours - truth) / truth[:, :1], noise / truth[:, :1]
        out = abs(error) > numpy.maximum(3 * sigma, 0.01)
        beyond, count = beyond + int(out.sum()), count + out.size
        rows.append([name, len(error), *(percent(abs(error[:, i]).max()) for i in range(3)), percent(sigma[:, 0].max()),
                     int(out.sum())])
    section.add(table(["case", "directions", "worst I", "worst Q, of I", "worst U, of I", "largest σ of I", "beyond"], rows))
    section.check("MYSTIC with polarisation", f"{len(documents)} cases, {count} Stokes parameters",
                  f"{beyond} beyond", "max(3σ, 1 % of I)", beyond == 0)


def add_plane_limit(context, section):
    generator = numpy.random.default_rng(1690)
    rows, every = [], []
    for asymmetry in (0.0, 0.6, 0.7, 0.8):
        errors = []
        for i in range(3 if context.quick else 6):
            document = polarised(cases.random_haze(f"pol_{i}", generator, asymmetry))
            if asymmetry == 0.0:
                for layer in document["layers"]:
                    layer["tau_aerosol"] = 0.0
            truth, _ = stokes(context.program.solve(document)[0])
            ours, _ = stokes(context.program.solve(cases.with_geometry(document, FLAT_RADIUS_KM))[0])
            errors.append((ours - truth) / truth[:, :1])
        errors = numpy.concatenate(errors)
        every.append(errors)
        rows.append([f"g {asymmetry:g}" if asymmetry else "air alone", len(errors),
                     *(percent(f(errors[:, i])) for i in range(3) for f in (rms, lambda e: abs(e).max()))])
    every = numpy.concatenate(every)
    section.add("### A flat planet, against our plane-parallel solver")
    section.add("Random hazes (Henyey–Greenstein, which makes no polarisation but hands it on) over air; RMS and worst, Q and U of I.")
    section.add(table(["medium", "directions", "I RMS", "I worst", "Q RMS", "Q worst", "U RMS", "U worst"], rows))
    section.check("our plane-parallel solver with polarisation", f"{len(every)} directions, I, Q, U",
                  f"worst {percent(abs(every).max())}, RMS {percent(rms(every.ravel()))}", "0.70 %, RMS 0.30 %",
                  abs(every).max() <= 0.007 and rms(every.ravel()) <= 0.003)


def sky(context, folder, turbidity, sun_deg, altitude_km, *options):
    """Y, x, y in the directions of views.csv."""
    out = folder / "sky.csv"
    context.program.run("map", "-o", out, "--directions", folder / "views.csv", "--turbidity", turbidity,
                        "--sun-zenith-deg", sun_deg, "--altitude-km", altitude_km, "--threads", 1, *options)
    rows = read_csv(out)
    return numpy.array([[row["Y_cd_m2"], row["x"], row["y"]] for row in rows])


def add_how_much(context, section):
    rows, largest = [], 0.0
    with tempfile.TemporaryDirectory(prefix="skylut-validate-") as name:
        folder = pathlib.Path(name)
        views = [(z, a) for z in RINGS_DEG for a in (0, 90, 180)]
        (folder / "views.csv").write_text("zenith_deg,azimuth_deg\n" + "".join(f"{z},{a}\n" for z, a in views))
        for air, turbidity in AIRS:
            for altitude_km in ALTITUDES_KM:
                for sun_deg in SUNS_DEG:
                    full = sky(context, folder, turbidity, sun_deg, altitude_km)
                    scalar = sky(context, folder, turbidity, sun_deg, altitude_km, "--scalar")
                    ratio = scalar[:, 0] / full[:, 0] - 1.0
                    largest = max(largest, abs(ratio).max())
                    shift = abs(scalar[:, 1:] - full[:, 1:]).max()
                    rows.append([air, altitude_km, sun_deg, percent(ratio[0], sign=True), percent(ratio.min(), sign=True),
                                 percent(ratio.max(), sign=True), f"{shift:.4f}"])
    section.add("### How much it matters")
    section.add("Luminance of `--scalar` over that of polarised light − 1, at the zenith and over 24 directions (zenith angles "
                "0–89°, azimuths 0, 90, 180° from the sun), and the largest change of x or y. Air: ussa1976, rural aerosol, "
                "depth at 500 nm 0, 0.1, 0.5.")
    section.add(table(["air", "km", "sun / °", "zenith", "least", "most", "x, y"], rows))
    section.check("unpolarised light", "luminance, clear to hazy, suns 0–96°, 0 and 12 km", f"up to {percent(largest)} off", "–", None)


def run(context):
    section = Section("Polarised light")
    section.add("Stokes I, Q, U as [polarisation.md](polarisation.md) defines them; deviations of Q and U are in units of I.")
    add_mystic(context, section)
    add_plane_limit(context, section)
    add_how_much(context, section)
    section.add("Rerun: `tools/validate --only polarisation`.")
    return section
