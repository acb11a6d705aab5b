"""The named qualities and the SIMD builds of the kernel: error, time, agreement."""

import numpy

from . import monte_carlo, plane_limit, spherical
from .cases import load, radiances, random_spheres
from .errors import Errors
from .program import read_csv
from .text import Section, percent, table

QUALITIES = ("draft", "default", "reference")
# The reference quality takes up to a minute for a case: of each asymmetry's hazes so many, every so-manyth random
# atmosphere, and the table on a coarser spectrum.
HAZES = 1
EVERY = 5
TABLE_WAVELENGTHS = "380:780:20"
SIMD_BUILDS = ("portable", "avx2", "avx512")
# Rounding in 32-bit floats, summed in another order.
SIMD_TOLERANCE = 1e-5


def difference(ours, theirs):
    """Worst and root mean square relative difference."""
    ratio = ours / theirs - 1
    return float(abs(ratio).max()), float(numpy.sqrt(numpy.mean(ratio**2)))


def flat_cases(context):
    """(case, truth) in the plane-parallel limit by kind: libRadtran's, and some of the random hazes."""
    single, layered = [], []
    for document in load(context.reference / "solver", "pp_*.json").values():
        (single if len(document["layers"]) == 1 else layered).append((document, radiances(document)[0]))
    for documents in plane_limit.hazes().values():
        layered += [(d, radiances(context.program.solve(d)[0])[0]) for d in documents[:HAZES]]
    return {"plane-parallel limit, one homogeneous layer": single, "plane-parallel limit, layered": layered}


def against_mystic(context, quality):
    """Rows of errors by sun-zenith group, and CPU seconds per case."""
    answers = spherical.solved(context, quality)
    rows = []
    for name, members in spherical.groups(answers).items():
        errors = Errors.joined(spherical.errors_of(case, answer) for _, case, answer, _ in members)
        rows.append(noisy_row(quality, f"MYSTIC, sun {name}", errors))
    return rows, sum(seconds for *_, seconds in answers) / max(1, len(answers))


def noisy_row(quality, reference, errors):
    return [quality, reference, errors.count, percent(errors.deviation[errors.worst], sign=True),
            percent(errors.rms), errors.outside, f"{errors.chi_square:.2f}"]


def against_monte_carlo(context, quality, sampled):
    """The same for the random atmospheres."""
    judged, spent = [], 0.0
    for document, answer in sampled:
        ours, seconds = context.program.solve(document, "--quality", quality)
        judged.append(monte_carlo.errors_of(document, ours, answer))
        spent += seconds
    return noisy_row(quality, "our Monte Carlo", Errors.joined(judged)), spent / len(sampled)


def against_plane_layers(context, quality, kinds):
    """The same in the plane-parallel limit, without noise."""
    rows, spent, count = [], 0.0, 0
    for name, pairs in kinds.items():
        if not pairs:
            continue
        solved = [plane_limit.flat_error(context, document, truth, quality) for document, truth in pairs]
        errors = numpy.concatenate([error for error, _ in solved])
        rows.append([quality, name, len(errors), percent(errors[numpy.argmax(abs(errors))], sign=True),
                     percent(numpy.sqrt(numpy.mean(errors**2))), int(numpy.sum(abs(errors) > 0.007)), "–"])
        spent += sum(seconds for _, seconds in solved)
        count += len(pairs)
    return rows, spent / count


def add_solver(context, section):
    """Each quality against MYSTIC, the plane limit and the Monte Carlo."""
    kinds = flat_cases(context)
    _, sampled = monte_carlo.sampled(context, random_spheres()[::EVERY])
    rows, times = [], []
    for quality in QUALITIES:
        context.say(quality)
        spherical_rows, spherical_time = against_mystic(context, quality)
        flat_rows, flat_time = against_plane_layers(context, quality, kinds)
        random_row, random_time = against_monte_carlo(context, quality, sampled)
        rows += [*spherical_rows, *flat_rows, random_row]
        times.append([quality, f"{spherical_time:.2f}", f"{flat_time:.2f}", f"{random_time:.2f}"])
    order = [row[1] for row in rows]
    section.add("### Solver")
    section.add(table(["quality", "reference", "directions", "worst for its bar", "RMS, noise removed", "outside", "χ²/n"],
                      sorted(rows, key=lambda row: order.index(row[1]))))
    section.add("Bars as in sections 1, 3 and 4 whatever the quality; of section 3's hazes and section 4's random atmospheres only "
                "some, because of the time. CPU seconds per case:")
    section.add(table(["quality", "MYSTIC cases", "plane-parallel limit", "random atmospheres"], times))


def add_table(context, section):
    """The 75-entry table at each quality: maps against the reference quality."""
    times, skies, rows = {}, {}, []
    for quality in QUALITIES:
        folder = context.work / f"table-{quality}"
        times[quality] = context.program.table(folder, "--quality", quality, "--save-maps",
                                               "--wavelengths-nm", TABLE_WAVELENGTHS)
        skies[quality] = maps(folder)
        context.say(f"table, {quality}: {times[quality]:.1f} s")
    for quality in QUALITIES:
        row = [quality, f"{times[quality]:.1f}"]
        for channel in ("Y_cd_m2", "x", "y"):
            worst, mean = difference(skies[quality][channel], skies["reference"][channel])
            row += [percent(worst), percent(mean)] if quality != "reference" else ["–", "–"]
        rows.append(row)
    worst, mean = difference(skies["default"]["Y_cd_m2"], skies["reference"]["Y_cd_m2"])
    section.check("quality `reference`", "luminance of the table's 75 × 271 directions at the default quality",
                  f"worst {percent(worst)}, RMS {percent(mean)}", "1 %, RMS 0.40 %", worst <= 0.01 and mean <= 0.004)
    section.add("### The 75-entry table")
    section.add("All 75 × 271 directions against the same at quality `reference`, on 21 wavelengths "
                f"(`--wavelengths-nm {TABLE_WAVELENGTHS}`); time of the whole command, one thread, maps written.")
    section.add(table(["quality", "CPU s", "Y worst", "Y RMS", "x worst", "x RMS", "y worst", "y RMS"], rows))
    ratio = skies["default"]["Y_cd_m2"] / skies["reference"]["Y_cd_m2"] - 1
    at = int(numpy.argmax(abs(ratio)))
    entry = read_csv(context.work / "table-default/table.csv")[at // 271]
    section.add(f"The default's worst is {percent(ratio[at], sign=True)}, in entry {at // 271 + 1} ({entry['altitude_km']:g} km, "
                f"aod500 {entry['turbidity']:g}, sun {entry['sun_zenith_deg']:g}°) at zenith angle "
                f"{skies['default']['zenith_deg'][at]:g}°, {skies['default']['gamma_deg'][at]:.0f}° from the sun; "
                f"{numpy.mean(abs(ratio) > 0.005) * 100:.2f} % of the directions differ by more than 0.5 %.")


def maps(folder):
    """Every map of a table, one array per column."""
    rows = [row for path in sorted((folder / "maps").glob("entry_*.csv")) for row in read_csv(path)]
    return {name: numpy.array([row[name] for row in rows]) for name in rows[0]}


def add_simd(context, section):
    """The kernel's builds against each other, over every wavelength of the table's maps."""
    native = maps(context.table())
    rows = []
    for build in SIMD_BUILDS:
        folder = context.work / f"table-{build}"
        try:
            seconds = context.program.table(folder, "--save-maps", simd=build)
        except RuntimeError as failure:
            rows.append([f"`SKYLUT_SIMD={build}`", "–", "–", str(failure).splitlines()[-1].rsplit(": ", 1)[-1]])
            continue
        sky = maps(folder)
        worst = max(difference(sky[name], native[name])[0] for name in native if name.startswith("L_"))
        colour = max(difference(sky[name], native[name])[0] for name in ("Y_cd_m2", "x", "y"))
        rows.append([f"`SKYLUT_SIMD={build}`", f"{seconds:.1f}", f"{worst:.1e}", f"{colour:.1e}"])
        section.check(f"SIMD build {build}", "the table's 75 × 271 × 81 radiances against the build that the program chooses",
                      f"largest difference {worst:.1e}", f"{SIMD_TOLERANCE:g}", worst <= SIMD_TOLERANCE)
    section.add("### SIMD builds")
    section.add("The whole table with each build of the kernel, against the build that the program chooses by itself.")
    section.add(table(["build", "CPU s", "radiance, largest relative difference", "Y, x, y"], rows))


def run(context):
    section = Section("Convergence: qualities and SIMD builds")
    add_solver(context, section)
    add_table(context, section)
    add_simd(context, section)
    section.add("Rerun: `tools/validate --only qualities`; one table: `skylut table --out DIR --quality reference "
                "--wavelengths-nm 380:780:20 --save-maps --threads 1`; one build: `SKYLUT_SIMD=portable skylut table --out DIR --save-maps --threads 1`.")
    return section
