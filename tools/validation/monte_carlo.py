"""Spherical solver against our own backward Monte Carlo on random round planets."""

import json

import numpy

from . import cases
from .errors import Errors, bar_of_sun, group_of_sun
from .text import Section, percent, table

PHOTONS = 1_000_000
PHOTONS_QUICK = 50_000
SEED = 7
# Photons for a second look at a direction outside its bar, in multiples of the first.
AGAIN = 20
# Directions with less noise than this show the solver's own error undisguised.
QUIET = 1e-3


def sampled(context, documents):
    """The Monte Carlo's answers to cases: photons, (case, answer) pairs. Kept in the work folder, whence --reuse-monte-carlo takes
    them: they do not depend on the solver under test."""
    photons = PHOTONS_QUICK if context.quick else PHOTONS
    folder = context.work / f"monte-carlo-{photons}"
    folder.mkdir(parents=True, exist_ok=True)
    pairs = []
    for document in documents:
        kept = folder / f"{document['id']}.json"
        answer = json.loads(kept.read_text(encoding="utf-8")) if context.reuse_monte_carlo and kept.exists() else None
        if not answer or any(answer[key] != document[key] for key in ("layers", "sun_zenith_deg", "observer_altitude_km")):
            answer, _ = context.program.solve(document, "--method", "monte-carlo", "--photons", photons, "--seed", SEED)
            kept.write_text(json.dumps(answer), encoding="utf-8")
            context.say(f"{document['id']} sampled")
        # The case itself, for whoever wants to run it again.
        (folder / f"{document['id']}.case.json").write_text(json.dumps(document, indent=1), encoding="utf-8")
        pairs.append((document, answer))
    return photons, pairs


def errors_of(document, ours, answer):
    """Deviation of an answer of the solver from the Monte Carlo's."""
    mean, error = cases.radiances(answer)
    return Errors.of(cases.radiances(ours)[0], mean, error, bar_of_sun(document["sun_zenith_deg"])[0])


def deviations(context, pairs):
    """(case, errors of the solver at its defaults) of each pair."""
    return [(document, errors_of(document, context.program.solve(document)[0], answer)) for document, answer in pairs]


def case_table(judged):
    rows = []
    for document, errors in judged:
        worst = errors.worst
        view = document["results"][worst]
        rows.append([document["id"], f"{document['sun_zenith_deg']:g}", f"{document['observer_altitude_km']:g}", cases.description(document),
                     percent(numpy.sqrt(numpy.mean(errors.noise**2))), percent(errors.rms), f"{errors.chi_square:.2f}",
                     f"{percent(errors.deviation[worst], sign=True)} ({errors.deviation[worst] / errors.noise[worst]:+.1f}σ) "
                     f"at {view['view_zenith_deg']:g}°, {view['relative_azimuth_deg']:g}°", f"{errors.outside} of {errors.count}"])
    return table(["case", "sun/°", "observer/km", "medium", "noise", "RMS", "χ²/n", "worst for its bar", "outside"], rows)


def judge_again(context, photons, judged):
    """The directions outside their bar, sampled anew with AGAIN times the photons: rows, and how many remain."""
    rows, remain = [], {}
    for document, errors in judged:
        for i in numpy.flatnonzero(numpy.abs(errors.deviation) > errors.allowed):
            view = document["results"][i]
            one = dict(document, results=[view])
            ours = context.program.solve(one)[0]
            answer, _ = context.program.solve(one, "--method", "monte-carlo", "--photons", AGAIN * photons,
                                              "--seed", SEED + 1)
            again = errors_of(one, ours, answer)
            remain[document["id"]] = remain.get(document["id"], 0) + again.outside
            rows.append([document["id"], f"{view['view_zenith_deg']:g}°, {view['relative_azimuth_deg']:g}°",
                         f"{percent(errors.deviation[i], sign=True)} ± {percent(errors.noise[i])}",
                         f"{percent(again.deviation[0], sign=True)} ± {percent(again.noise[0])}"])
    return rows, remain


def group_table(section, judged, title, remain):
    """The sun-zenith groups of cases: a table, and lines of the summary."""
    groups = {}
    for document, errors in judged:
        groups.setdefault(group_of_sun(document["sun_zenith_deg"]), []).append(
            (document["sun_zenith_deg"], errors, remain.get(document["id"], 0)))
    rows = []
    for name, members in sorted(groups.items(), key=lambda pair: pair[1][0][0]):
        errors = Errors.joined(e for _, e, _ in members)
        left = sum(count for *_, count in members)
        bar, rms_bar = bar_of_sun(members[0][0])
        worst = percent(errors.deviation[errors.worst], sign=True)
        quiet = errors.noise <= QUIET
        quiet_rms = numpy.sqrt(numpy.mean(errors.deviation[quiet] ** 2)) if quiet.any() else numpy.nan
        rows.append([name, len(members), errors.count, percent(numpy.sqrt(numpy.mean(errors.noise**2))),
                     percent(errors.mean, sign=True), percent(errors.rms), percent(rms_bar), worst,
                     f"max(3σ, {percent(bar)})", errors.outside, f"{errors.chi_square:.2f}",
                     f"{percent(quiet_rms)} of {quiet.sum()}" if quiet.any() else "–"])
        again = f" ({left} with {AGAIN} times the photons)" if errors.outside else ""
        section.check(f"{title}, sun {name}", f"{len(members)} cases, {errors.count} directions",
                      f"worst {worst}, {errors.outside} outside{again}; RMS {percent(errors.rms)}",
                      f"max(3σ, {percent(bar)}); RMS {percent(rms_bar)}", left == 0 and errors.rms <= rms_bar)
    section.add(table(["sun", "cases", "directions", "noise", "mean", "RMS, noise removed", "bar of RMS",
                       "worst for its bar", "bar", "outside", "χ²/n", f"RMS where σ ≤ {percent(QUIET)}"], rows))


def run(context):
    section = Section("Spherical solver against our Monte Carlo")
    photons, pairs = sampled(context, cases.random_spheres())
    judged = deviations(context, pairs)
    section.add(f"The Monte Carlo (`--method monte-carlo --photons {photons} --seed {SEED}`) shares no transfer code with the solver, and has "
                "less noise than the reference set. χ²/n: mean square of the deviations in standard errors. It is 1 for noise alone and "
                "grows with the number of photons as soon as the solver's own error shows; the RMS, noise removed, does not. Where few photons "
                "contribute (twilight, thick haze) the standard error is itself uncertain.")
    section.add("### Thirty random atmospheres")
    section.add("Seeded: Rayleigh depth 0.03–0.4, haze 0–2 with g 0.5–0.85 and ω 0.85–1, an absorbing layer at 22 km, albedo 0–0.8, sun 0–94°, "
                "observers at 0–30 km, eight views each at 0–97° zenith angle and any azimuth.")
    rows, remain = judge_again(context, photons, judged)
    group_table(section, judged, "Monte Carlo, 30 random atmospheres", remain)
    if rows:
        section.add(f"Directions outside, sampled anew with {AGAIN} times the photons (chance takes 0.3 % of them beyond 3σ):")
        section.add(table(["case", "view", "deviation", f"with {AGAIN} times the photons"], rows))
    z = numpy.concatenate([errors.deviation / errors.noise for _, errors in judged])
    section.add(f"All {len(z)} z-scores: mean {z.mean():+.2f}, χ²/n {numpy.mean(z**2):.2f}, {numpy.mean(numpy.abs(z) < 1) * 100:.0f} % within 1σ "
                f"(normal: 68 %), {numpy.mean(numpy.abs(z) < 2) * 100:.0f} % within 2σ (95 %), largest {numpy.abs(z).max():.1f}σ.")
    section.add(case_table(judged))
    add_reference(context, section)
    section.add("Rerun: `tools/validate --only monte-carlo`; one case: `skylut solve "
                f"out/validation/monte-carlo-{photons}/random_00.case.json --method monte-carlo --photons {photons} "
                f"--seed {SEED}`, and without the last three options for the solver.")
    return section


def add_reference(context, section):
    """The cases of the reference set again, judged by our own Monte Carlo, which is less noisy than MYSTIC's answers."""
    documents = list(cases.load(context.reference / "solver", "sph_*.json").values())
    section.add("### The reference set's cases")
    if not documents:
        section.add("Skipped: no `solver/sph_*.json` in the reference folder.")
        return
    photons, pairs = sampled(context, documents)
    judged = deviations(context, pairs)
    group_table(section, judged, "our Monte Carlo, MYSTIC's cases", judge_again(context, photons, judged)[1])
    between = Errors.joined(Errors.of(cases.radiances(answer)[0], cases.radiances(document)[0],
                                      numpy.hypot(cases.radiances(document)[1], cases.radiances(answer)[1]), 0.0)
                            for document, answer in pairs)
    section.add(f"The two Monte Carlos against each other: χ²/n {between.chi_square:.2f} over {between.count} directions, mean "
                f"{percent(between.mean, sign=True)}, largest {numpy.abs(between.deviation / between.noise).max():.1f}σ of both together.")
    section.check("MYSTIC against our Monte Carlo", f"{between.count} directions",
                  f"χ²/n {between.chi_square:.2f}, RMS {percent(between.rms)}", "χ²/n 0.77–1.23 (2σ)", abs(between.chi_square - 1) <= 2 * (2 / between.count) ** 0.5)
    section.add(case_table(judged))
