"""Plane-parallel solver against DISORT: libRadtran's, and DISORT's own test problems."""

import numpy

from . import cases
from .text import Section, percent, table

# DISORT's radiances are compared where they are above this share of the largest; smaller ones are round-off.
NEGLIGIBLE = 1e-6


def relative(ours, theirs):
    """Relative differences where the reference is not negligible."""
    ours, theirs = numpy.ravel(ours).astype(float), numpy.ravel(theirs).astype(float)
    counted = numpy.abs(theirs) > NEGLIGIBLE * numpy.abs(theirs).max(initial=0.0)
    return ours[counted] / theirs[counted] - 1


def differences(document, answer):
    """Relative differences of radiances and of fluxes, in either schema."""
    if "outputs" in document:
        mine, theirs = answer["outputs"], document["outputs"]
        fluxes = [relative(mine[key], theirs[key]) for key in ("flux_direct", "flux_down_diffuse", "flux_up")]
        return relative(mine["radiance"], theirs["radiance"]), numpy.concatenate(fluxes)
    keys = ("direct_down", "diffuse_down", "diffuse_up")
    return (relative(cases.radiances(answer)[0], cases.radiances(document)[0]),
            relative([answer["fluxes"][k] for k in keys], [document["fluxes"][k] for k in keys]))


def rms(values):
    return numpy.sqrt(numpy.mean(values**2))


def add_set(context, section, folder, pattern, title, radiance_bar, flux_bar):
    """One reference set: a table of its cases and a line of the summary."""
    rows, all_radiances, all_fluxes = [], [], []
    for name, document in cases.load(context.reference / folder, pattern).items():
        answer, seconds = context.program.solve(document)
        radiance, flux = differences(document, answer)
        all_radiances.append(radiance)
        all_fluxes.append(flux)
        rows.append([name, len(radiance), percent(abs(radiance).max()) if len(radiance) else "–",
                     percent(rms(radiance)) if len(radiance) else "–", len(flux), percent(abs(flux).max()),
                     f"{seconds:.2f}"])
    section.add(f"### {title}")
    if not rows:
        section.add(f"Skipped: no `{folder}/{pattern}` in the reference folder.")
        return
    radiance, flux = numpy.concatenate(all_radiances), numpy.concatenate(all_fluxes)
    section.add(table(["case", "radiances", "worst", "RMS", "fluxes", "worst", "CPU s"], rows))
    section.check(title, f"{len(rows)} cases, {len(radiance)} radiances",
                  f"worst {percent(abs(radiance).max())}, RMS {percent(rms(radiance))}", percent(radiance_bar),
                  abs(radiance).max() <= radiance_bar)
    section.check(title, f"{len(rows)} cases, {len(flux)} fluxes",
                  f"worst {percent(abs(flux).max())}, RMS {percent(rms(flux))}", percent(flux_bar),
                  abs(flux).max() <= flux_bar)


def run(context):
    section = Section("Plane-parallel solver against DISORT")
    section.add("Our discrete-ordinate solver judges the spherical one in the limit of a flat planet (section 3), so "
                "it is judged "
                f"first. No noise on either side. Values below {NEGLIGIBLE:g} of the largest are left out.")
    add_set(context, section, "solver", "pp_*.json", "libRadtran DISORT, 64 streams", 0.005, 0.001)
    add_set(context, section, "disort", "disort_*.json", "DISORT's test problems, 128 streams", 0.005, 0.001)
    section.add("Rerun: `tools/validate --only plane-parallel`; one case: `skylut solve REFERENCE/solver/<case>.json` "
                "or "
                "`skylut solve REFERENCE/disort/<case>.json`.")
    return section
