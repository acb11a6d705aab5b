"""Spherical solver against MYSTIC, libRadtran's spherical Monte Carlo."""

import numpy

from . import cases
from .errors import Errors, bar_of_sun
from .figures import COLOURS, plt, save
from .text import Section, percent, table

# One case for each kind of sky in the figure: a clear one, haze under a low sun, and twilight.
PRINCIPAL_PLANE = {"sph_B_sza60_alt00": "haze τ 0.2, sun 60°, ground",
                   "sph_E_sza88_alt00": "thick haze, bright ground, sun 88°, ground",
                   "sph_B_sza92_alt12": "haze τ 0.2, sun 92°, 12 km"}

# Deviations of more than this many standard errors are put to our Monte Carlo as a second judge.
DOUBTFUL = 2.5
JUDGE_PHOTONS = 6_000_000


def solved(context, quality="default"):
    """(name, case, answer, seconds) of every spherical case of the reference set."""
    answers = []
    for name, document in cases.load(context.reference / "solver", "sph_*.json").items():
        answer, seconds = context.program.solve(document, "--quality", quality)
        answers.append((name, document, answer, seconds))
    return answers


def errors_of(document, answer):
    reference, noise = cases.radiances(document)
    return Errors.of(cases.radiances(answer)[0], reference, noise, bar_of_sun(document["sun_zenith_deg"])[0])


def groups(answers):
    """The sun-zenith groups that the bars are set for: name -> answers."""
    found = {}
    for item in answers:
        sun = item[1]["sun_zenith_deg"]
        name = "≤ 85°" if sun <= 85 else "88–90°" if sun <= 90 else f"{sun:g}°"
        found.setdefault(name, []).append(item)
    return dict(sorted(found.items(), key=lambda pair: max(i[1]["sun_zenith_deg"] for i in pair[1])))


def case_rows(answers):
    rows = []
    for name, document, answer, seconds in sorted(answers, key=lambda a: a[1]["sun_zenith_deg"]):
        errors = errors_of(document, answer)
        worst = errors.worst
        view = document["results"][worst]
        bar, rms_bar = bar_of_sun(document["sun_zenith_deg"])
        rows.append([name, cases.description(document), f"{document['sun_zenith_deg']:g}",
                     f"{document['observer_altitude_km']:g}", errors.count,
                     percent(numpy.sqrt(numpy.mean(errors.noise**2))), percent(errors.rms), percent(rms_bar),
                     f"{percent(errors.deviation[worst], sign=True)} ({errors.deviation[worst] / errors.noise[worst]:+.1f}σ) "
                     f"at {view['view_zenith_deg']:g}°, {view['relative_azimuth_deg']:g}°",
                     f"max(3σ, {percent(bar)})", errors.outside, f"{seconds:.2f}"])
    return rows


def draw_principal_plane(context, answers):
    """Radiance along the sun's vertical: our curve, MYSTIC's points, and the differences below."""
    figure, axes = plt.subplots(2, len(PRINCIPAL_PLANE), figsize=(11, 5), height_ratios=(3, 1), sharex="col")
    by_name = {name: document for name, document, _, _ in answers}
    for column, (name, title) in zip(axes.T, PRINCIPAL_PLANE.items()):
        document = by_name[name]
        # Towards the sun on the right of the zenith, away from it on the left; other azimuths beside them.
        signed = numpy.concatenate([numpy.arange(-97, 98, 1.0)])
        for azimuths, colour in (((0, 180), COLOURS[0]), ((90, 90), COLOURS[2])):
            curve = dict(document, results=[
                {"view_zenith_deg": abs(s), "relative_azimuth_deg": azimuths[0] if s >= 0 else azimuths[1],
                 "radiance": 0}
                for s in signed])
            answer, _ = context.program.solve(curve)
            label = "skylut, sun's vertical" if azimuths[0] == 0 else "skylut, across it"
            column[0].semilogy(signed, cases.radiances(answer)[0], color=colour, lw=1.2, label=label)
        _, _, answer, _ = next(a for a in answers if a[0] == name)
        reference, noise = cases.radiances(document)
        ours, _ = cases.radiances(answer)
        azimuth = numpy.array([r["relative_azimuth_deg"] for r in document["results"]])
        place = numpy.array([r["view_zenith_deg"] for r in document["results"]]) * numpy.where(azimuth > 90, -1, 1)
        column[0].errorbar(place, reference, 3 * noise, fmt="o", ms=3.5, color=COLOURS[1], capsize=2,
                           label="MYSTIC, 3σ")
        column[1].errorbar(place, 100 * (ours / reference - 1), 300 * noise / reference, fmt="o", ms=3.5,
                           color=COLOURS[1], capsize=2)
        column[1].axhline(0, color="black", lw=0.6)
        column[0].set_title(title, fontsize=9)
        column[1].set_xlabel("view zenith angle, sun's side positive / °")
    axes[0, 0].set_ylabel("radiance / sr$^{-1}$")
    axes[1, 0].set_ylabel("ours − MYSTIC / %")
    axes[0, 0].legend(fontsize=7)
    save(context, figure, "principal-plane")


def draw_errors(context, answers):
    """Every direction's deviation with its 3 sigma, by sun zenith angle, inside the bars."""
    figure, axis = plt.subplots(figsize=(8, 4))
    x = 0.0
    ticks, names = [], []
    for name, document, answer, _ in sorted(answers, key=lambda a: a[1]["sun_zenith_deg"]):
        errors = errors_of(document, answer)
        places = x + numpy.arange(errors.count)
        axis.fill_between([x - 0.7, x + errors.count - 0.3], -100 * errors.tolerance[0], 100 * errors.tolerance[0],
                          color=COLOURS[3], alpha=0.18, lw=0)
        axis.errorbar(places, 100 * errors.deviation, 300 * errors.noise, fmt="o", ms=2.5, lw=0.7, color=COLOURS[0])
        ticks.append(x + (errors.count - 1) / 2)
        names.append(f"{name[4]} {document['sun_zenith_deg']:g}° {document['observer_altitude_km']:g} km")
        x += errors.count + 2
    axis.axhline(0, color="black", lw=0.6)
    axis.set_xticks(ticks, names, rotation=60, ha="right", fontsize=7)
    axis.set_ylim(-6, 6)
    axis.grid(axis="x")
    axis.set_ylabel("ours − MYSTIC / %")
    save(context, figure, "spherical-errors")


def judged(context, answers):
    """Rows for the directions that deviate by more than DOUBTFUL standard errors: what our Monte Carlo says there."""
    photons = JUDGE_PHOTONS // 20 if context.quick else JUDGE_PHOTONS
    rows = []
    for name, document, answer, _ in answers:
        errors = errors_of(document, answer)
        doubtful = [i for i in range(errors.count) if abs(errors.deviation[i]) > DOUBTFUL * errors.noise[i]]
        if not doubtful:
            continue
        asked = dict(document, results=[document["results"][i] for i in doubtful])
        sampled, _ = context.program.solve(asked, "--method", "monte-carlo", "--photons", photons, "--seed", 11)
        ours = cases.radiances(answer)[0][doubtful]
        for i, mine, result in zip(doubtful, ours, sampled["results"]):
            mean, error = result["radiance"], result["std"]
            view = document["results"][i]
            rows.append([name, f"{view['view_zenith_deg']:g}°, {view['relative_azimuth_deg']:g}°",
                         f"{percent(errors.deviation[i], sign=True)} ({errors.deviation[i] / errors.noise[i]:+.1f}σ)",
                         f"{percent(mine / mean - 1, sign=True)} ± {percent(error / mean)}",
                         "yes" if abs(mine - mean) <= max(3 * error, errors.tolerance[i] * mean) else "no"])
    return photons, rows


def cleared(members, doubts):
    """What our Monte Carlo says to the directions of a group that are outside their bar, in brackets."""
    outside = {(name, f"{r['view_zenith_deg']:g}°, {r['relative_azimuth_deg']:g}°") for name, document, answer,
               _ in members
               for r, error, allowed in zip(document["results"], errors_of(document, answer).deviation,
                                            errors_of(document, answer).allowed)
               if abs(error) > allowed}
    if not outside:
        return ""
    agreed = sum((row[0], row[1]) in outside and row[-1] == "yes" for row in doubts)
    return f" ({agreed} of them within it by our Monte Carlo: section 1)"


def add_real_hazes(context, section):
    """Mie hazes, in which a cut forward peak shows at the horizon (theory.md, L6): every direction."""
    documents = cases.load(context.reference / "solver_mie", "mie_*.json")
    if not documents:
        section.add("Real hazes are skipped: no `solver_mie/mie_*.json` in the reference folder.")
        return
    rows = []
    several = []
    for name, document in documents.items():
        answer, _ = context.program.solve(document)
        errors = errors_of(document, answer)
        several.append(errors)
        for result, deviation, noise in zip(document["results"], errors.deviation, errors.noise):
            rows.append([name, f"{result['view_zenith_deg']:g}°, {result['relative_azimuth_deg']:g}°",
                         percent(deviation, sign=True), percent(noise)])
    errors = Errors.joined(several)
    section.check("MYSTIC, real hazes to the horizon", f"{len(documents)} cases, {errors.count} directions",
                  f"worst {percent(errors.deviation[errors.worst], sign=True)}, {errors.outside} outside; RMS {percent(errors.rms)}",
                  "max(3σ, 0.70 %)", errors.outside == 0)
    section.add("Real hazes (Mie, `skylut profile case`), seen from the ground down to 89.9°:")
    section.add(table(["case", "view", "ours − MYSTIC", "σ"], rows))


def run(context):
    section = Section("Spherical solver against MYSTIC")
    answers = solved(context)
    if not answers:
        section.add("Skipped: no `solver/sph_*.json` in the reference folder.")
        return section
    section.add("`skylut solve` with its defaults on round-number media: A Rayleigh, B and C with haze (C absorbing), "
                "D Rayleigh with "
                "an absorbing layer, E thick haze over a bright ground; sun at the zenith to 4° below the horizon, "
                "observers at 0–30 km.")
    photons, doubts = judged(context, answers)
    rows = []
    for name, members in groups(answers).items():
        errors = Errors.joined(errors_of(document, answer) for _, document, answer, _ in members)
        bar, rms_bar = bar_of_sun(members[0][1]["sun_zenith_deg"])
        worst_rms = max(errors_of(document, answer).rms for _, document, answer, _ in members)
        worst = percent(errors.deviation[errors.worst], sign=True)
        rows.append([name, len(members), errors.count, percent(errors.mean, sign=True), percent(errors.rms),
                     percent(errors.rms_uncertainty), percent(worst_rms), percent(rms_bar), worst,
                     f"max(3σ, {percent(bar)})", errors.outside, f"{errors.chi_square:.2f}"])
        section.check(f"MYSTIC, sun {name}", f"{len(members)} cases, {errors.count} directions",
                      f"worst {worst}, {errors.outside} outside{cleared(members, doubts)}; RMS {percent(errors.rms)}, of one case {percent(worst_rms)}",
                      f"max(3σ, {percent(bar)}); RMS {percent(rms_bar)}", errors.outside == 0 and worst_rms <= rms_bar)
        if name == "≤ 85°":
            loose = int(numpy.sum(numpy.abs(errors.deviation) > numpy.maximum(3 * errors.noise, 0.03)))
            section.check("the same, first bar", f"{errors.count} directions", f"{loose} outside", "max(3σ, 3 %)",
                          loose == 0)
    section.add(table(["sun", "cases", "directions", "mean", "RMS, noise removed", "noise hides",
                       "RMS of the worst case", "bar of RMS",
                       "worst for its bar", "bar", "outside", "χ²/n"], rows))
    section.add("*Noise hides*: an RMS of this size could hide in the uncertainty of the variance that is taken out. "
                "*Worst for its "
                "bar*: the deviation that uses most of its allowance.")
    draw_principal_plane(context, answers)
    section.figure("principal-plane", "Radiance along the sun's vertical and across it for three cases; below, every direction of the case")
    draw_errors(context, answers)
    section.figure("spherical-errors", "Every direction of every case with 3σ of MYSTIC; green: the bar without noise. Cases by sun zenith angle and observer")
    section.add(f"Directions that deviate by more than {DOUBTFUL} standard errors of MYSTIC, put to our own Monte "
                f"Carlo "
                f"(`--method monte-carlo --photons {photons} --seed 11`). Of "
                f"{sum(len(document['results']) for _, document, _, _ in answers)} "
                "directions chance alone takes 1.2 % that far, more where few photons make σ itself uncertain:")
    section.add(table(["case", "view", "ours − MYSTIC", "ours − our Monte Carlo", "within max(3σ, bar)"], doubts))
    section.add(table(["case", "medium", "sun/°", "observer/km", "directions", "noise", "RMS", "bar",
                       "worst for its bar", "bar",
                       "outside", "CPU s"], case_rows(answers)))
    add_real_hazes(context, section)
    section.add("Rerun: `tools/validate --only spherical`; one case: `skylut solve REFERENCE/solver/<case>.json`.")
    return section
