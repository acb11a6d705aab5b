"""The spherical solver on a planet so large that its layers are plane, against numbers without noise."""

import numpy

from . import cases
from .figures import COLOURS, plt, save
from .plane_parallel import relative, rms
from .text import Section, percent, table

FLAT_RADIUS_KM = 6.4e7
ASYMMETRIES = (0.6, 0.65, 0.7, 0.75, 0.8, 0.85)
HAZES_PER_ASYMMETRY = 6
AUREOLE_DEG = 10.0


def sun_distance_deg(document):
    """Angle between each view and the sun."""
    sun = numpy.radians(document["sun_zenith_deg"])
    zenith = numpy.radians([r["view_zenith_deg"] for r in document["results"]])
    azimuth = numpy.radians([r["relative_azimuth_deg"] for r in document["results"]])
    cosine = numpy.cos(sun) * numpy.cos(zenith) + numpy.sin(sun) * numpy.sin(zenith) * numpy.cos(azimuth)
    return numpy.degrees(numpy.arccos(numpy.clip(cosine, -1, 1)))


def hazes():
    """Seeded families of hazes: asymmetry -> plane-parallel cases."""
    generator = numpy.random.default_rng(1999)
    return {g: [cases.random_haze(f"haze_{g:g}_{i}", generator, g) for i in range(HAZES_PER_ASYMMETRY)]
            for g in ASYMMETRIES}


def flat_error(context, document, truth, quality="default"):
    """Relative error of the spherical solver on the flattened planet, and its CPU seconds."""
    flat = cases.with_geometry(document, FLAT_RADIUS_KM)
    answer, seconds = context.program.solve(flat, "--quality", quality)
    return relative(cases.radiances(answer)[0], truth), seconds


def draw(context, points):
    """Errors by angle from the sun, a colour for each asymmetry."""
    figure, axis = plt.subplots(figsize=(8, 3.6))
    shades = plt.get_cmap("viridis")(numpy.linspace(0, 0.9, len(points)))
    for (asymmetry, (angles, errors)), shade in zip(points.items(), shades):
        axis.plot(angles, 100 * errors, "o", ms=3, color=shade, label=f"g {asymmetry:g}")
    axis.axhspan(-0.7, 0.7, color=COLOURS[3], alpha=0.15, lw=0)
    axis.set_xlabel("angle from the sun / °")
    axis.set_ylabel("spherical − plane-parallel / %")
    axis.legend(ncols=3, fontsize=8)
    save(context, figure, "plane-limit")


def add_hazes(context, section):
    rows, points = [], {}
    every = []
    for asymmetry, documents in hazes().items():
        angles, errors, seconds = [], [], 0.0
        for document in documents:
            truth = cases.radiances(context.program.solve(document)[0])[0]
            error, spent = flat_error(context, document, truth)
            errors.append(error)
            angles.append(sun_distance_deg(document))
            seconds += spent
        errors, angles = numpy.concatenate(errors), numpy.concatenate(angles)
        points[asymmetry] = (angles, errors)
        every.append(errors)
        near = errors[angles < AUREOLE_DEG]
        worst = int(numpy.argmax(abs(errors)))
        rows.append([f"{asymmetry:g}", len(documents), len(errors), percent(errors[worst], sign=True),
                     f"{angles[worst]:.0f}",
                     percent(rms(errors)), percent(abs(near).max()) if len(near) else "–",
                     f"{seconds / len(documents):.2f}"])
    every = numpy.concatenate(every)
    section.add("### Random hazes")
    section.add("Depth 0.3–2 with scale heights 1–3 km, ω 0.85–1, over Rayleigh 0.03–0.4 and an absorbing layer, "
                "albedo 0–0.8, sun 0–82°, "
                "14 views each between the zenith and 88°; truth is our plane-parallel solver.")
    section.add(table(["g", "cases", "directions", "worst", "at ° from the sun", "RMS", "worst within 10° of the sun",
                       "CPU s per case"], rows))
    draw(context, points)
    section.figure("plane-limit", "The spherical solver on a flat planet: every direction of the random hazes. Green: ± 0.7 %")
    section.check("our plane-parallel solver, random hazes",
                  f"{len(ASYMMETRIES) * HAZES_PER_ASYMMETRY} cases, g 0.6–0.85, τ 0.3–2, {len(every)} directions",
                  f"worst {percent(abs(every).max())}, RMS {percent(rms(every))}", "0.70 %, RMS 0.30 %",
                  abs(every).max() <= 0.007 and rms(every) <= 0.003)


def add_reference(context, section):
    documents = {name: d for name, d in cases.load(context.reference / "solver", "pp_*.json").items()
                 if d["sun_zenith_deg"] <= 82}
    section.add("### libRadtran's plane-parallel cases")
    if not documents:
        section.add("Skipped: no `solver/pp_*.json` in the reference folder.")
        return
    rows, every = [], []
    for name, document in documents.items():
        error, seconds = flat_error(context, document, cases.radiances(document)[0])
        every.append(error)
        worst = int(numpy.argmax(abs(error)))
        view = document["results"][worst]
        rows.append([name, len(error), percent(error[worst], sign=True),
                     f"{view['view_zenith_deg']:g}°, {view['relative_azimuth_deg']:g}°", percent(rms(error)),
                     f"{seconds:.2f}"])
    every = numpy.concatenate(every)
    section.add(table(["case", "directions", "worst", "at", "RMS", "CPU s"], rows))
    section.add("The `homogeneous` cases are one layer from the ground to 100 km, which no atmosphere is: its sublayers are as thick "
                "as the solver allows, where the layers of an atmosphere are thinner by themselves. Section 5 has the same at the other "
                "qualities: the error falls with the sublayers' depth.")
    section.check("DISORT, spherical solver on a flat planet", f"{len(rows)} cases, {len(every)} directions",
                  f"worst {percent(abs(every).max())}, RMS {percent(rms(every))}", "0.70 %, RMS 0.30 %",
                  abs(every).max() <= 0.007 and rms(every) <= 0.003)


def run(context):
    section = Section("Spherical solver in the plane-parallel limit")
    section.add(f"The main solver with a planet radius of {FLAT_RADIUS_KM:g} km: what differs from plane layers is "
                f"below 1e-4, and there is no "
                "noise, so these are the sharpest figures for the solver's own error (levels, angles, nodes).")
    add_reference(context, section)
    add_hazes(context, section)
    section.add("Rerun: `tools/validate --only plane-limit`; one case: set "
                "`\"geometry\": \"spherical\", \"planet_radius_km\": 6.4e7` in "
                "`REFERENCE/solver/pp_<case>.json` and run `skylut solve` on it.")
    return section
