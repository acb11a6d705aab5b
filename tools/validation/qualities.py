"""The named qualities and the SIMD builds of the kernel: error, time, agreement."""

import numpy

from . import monte_carlo, plane_limit, spherical
from .cases import load, radiances
from .errors import Errors
from .program import read_csv
from .text import Section, percent, table

QUALITIES = ("draft", "default", "reference")
SIMD_BUILDS = ("sse2", "avx2", "avx512")
# Rounding in 32-bit floats, summed in another order.
SIMD_TOLERANCE = 1e-5


def difference(ours, theirs):
    """Worst and root mean square relative difference."""
    ratio = ours / theirs - 1
    return float(abs(ratio).max()), float(numpy.sqrt(numpy.mean(ratio**2)))


def flat_cases(context):
    """(case, truth) in the plane-parallel limit: libRadtran's, and the random hazes."""
    pairs = [(d, radiances(d)[0]) for d in load(context.reference / "solver", "pp_*.json").values()]
    for documents in plane_limit.hazes().values():
        pairs += [(d, radiances(context.program.solve(d)[0])[0]) for d in documents]
    return pairs


def add_solver(context, section):
    """Each quality against MYSTIC, the plane limit and the Monte Carlo."""
    flat = flat_cases(context)
    _, sampled = monte_carlo.sampled(context)
    rows, times = [], []
    for quality in QUALITIES:
        context.say(quality)
        answers = spherical.solved(context, quality)
        spherical_time = sum(seconds for *_, seconds in answers)
        for name, members in spherical.groups(answers).items():
            errors = Errors.joined(spherical.errors_of(document, answer) for _, document, answer, _ in members)
            rows.append([quality, f"MYSTIC, sun {name}", errors.count, percent(errors.deviation[errors.worst], sign=True),
                         percent(errors.rms), f"{errors.outside}", f"{errors.chi_square:.2f}"])
        solved = [plane_limit.flat_error(context, document, truth, quality) for document, truth in flat]
        errors = numpy.concatenate([error for error, _ in solved])
        flat_time = sum(seconds for _, seconds in solved)
        rows.append([quality, "plane-parallel limit", len(errors), percent(errors[numpy.argmax(abs(errors))], sign=True),
                     percent(numpy.sqrt(numpy.mean(errors**2))), int(numpy.sum(abs(errors) > 0.007)), "–"])
        judged, random_time = [], 0.0
        for document, answer in sampled:
            ours, seconds = context.program.solve(document, "--quality", quality)
            judged.append(monte_carlo.errors_of(document, ours, answer))
            random_time += seconds
        errors = Errors.joined(judged)
        rows.append([quality, "our Monte Carlo", errors.count, percent(errors.deviation[errors.worst], sign=True),
                     percent(errors.rms), errors.outside, f"{errors.chi_square:.2f}"])
        times.append([quality, f"{spherical_time / max(1, len(answers)):.2f}", f"{flat_time / len(flat):.2f}",
                      f"{random_time / len(sampled):.2f}"])
    section.add("### Solver")
    section.add(table(["quality", "reference", "directions", "worst for its bar", "RMS, noise removed", "outside", "χ²/n"],
                      sorted(rows, key=lambda row: [r[1] for r in rows].index(row[1]))))
    section.add("Bars as in sections 1, 3 and 4 whatever the quality. CPU seconds per case:")
    section.add(table(["quality", "MYSTIC cases", "plane-parallel limit", "random atmospheres"], times))


def add_table(context, section):
    """The 75-entry table at each quality: zenith and maps against the reference quality."""
    folders, times = {}, {}
    for quality in QUALITIES:
        folders[quality] = context.work / f"table-{quality}"
        times[quality] = context.program.table(folders[quality], "--quality", quality, "--save-maps")
        context.say(f"table, {quality}: {times[quality]:.1f} s")
    skies = {quality: maps(folder) for quality, folder in folders.items()}
    rows = []
    for quality in QUALITIES:
        row = [quality, f"{times[quality]:.1f}"]
        for channel in ("Y_cd_m2", "x", "y"):
            worst, mean = difference(skies[quality][channel], skies["reference"][channel])
            row += [percent(worst), percent(mean)] if quality != "reference" else ["–", "–"]
        rows.append(row)
    worst, mean = difference(skies["default"]["Y_cd_m2"], skies["reference"]["Y_cd_m2"])
    section.check("quality reference", f"the table's 75 × 271 directions, luminance at default quality",
                  f"worst {percent(worst)}, RMS {percent(mean)}", "1 %, RMS 0.40 %", worst <= 0.01 and mean <= 0.004)
    section.add("### The 75-entry table")
    section.add("All 75 × 271 directions against the same at quality `reference`; time of the whole command, one thread, maps written.")
    section.add(table(["quality", "CPU s", "Y worst", "Y RMS", "x worst", "x RMS", "y worst", "y RMS"], rows))
    return skies["default"]


def maps(folder):
    """Every map of a table, one array per column."""
    rows = [row for path in sorted((folder / "maps").glob("entry_*.csv")) for row in read_csv(path)]
    return {name: numpy.array([row[name] for row in rows]) for name in rows[0]}


def add_simd(context, section, native):
    """The kernel's builds against each other, over every wavelength of the table's maps."""
    skies, rows = {}, []
    for build in SIMD_BUILDS:
        folder = context.work / f"table-{build}"
        try:
            seconds = context.program.table(folder, "--save-maps", simd=build)
        except RuntimeError as failure:
            rows.append([build, "–", "–", "–", str(failure).splitlines()[-1].rsplit(": ", 1)[-1]])
            continue
        skies[build] = maps(folder)
        columns = [name for name in native if name.startswith("L_")]
        worst = max(difference(skies[build][name], native[name])[0] for name in columns)
        colour = max(difference(skies[build][name], native[name])[0] for name in ("Y_cd_m2", "x", "y"))
        rows.append([f"`SKYLUT_SIMD={build}`", f"{seconds:.1f}", f"{worst:.1e}", f"{colour:.1e}", ""])
        section.check(f"SIMD build {build}", "the table's 75 × 271 × 81 radiances against the build chosen by the program",
                      f"largest difference {worst:.1e}", f"{SIMD_TOLERANCE:g}", worst <= SIMD_TOLERANCE)
    section.add("### SIMD builds")
    section.add("The whole table with each build of the kernel, against the build that the program chooses by itself.")
    section.add(table(["build", "CPU s", "radiance, largest relative difference", "Y, x, y", ""], rows))


def run(context):
    section = Section("Qualities and SIMD builds")
    add_solver(context, section)
    native = add_table(context, section)
    add_simd(context, section, native)
    section.add("Rerun: `tools/validate --only qualities`; one table: `skylut table --out DIR --quality reference --save-maps --threads 1`; "
                "one build: `SKYLUT_SIMD=sse2 skylut table --out DIR --save-maps --threads 1`.")
    return section
