"""Spherical solver against our own backward Monte Carlo on random round planets."""

import json

import numpy

from . import cases
from .errors import Errors, bar_of_sun, group_of_sun
from .text import Section, percent, table

PHOTONS = 1_000_000
PHOTONS_QUICK = 50_000
SEED = 7


def sampled(context):
    """The Monte Carlo's answers to the thirty cases: (case, answer) pairs. Kept in the work folder, whence
    --reuse-monte-carlo takes them: they do not depend on the solver under test."""
    photons = PHOTONS_QUICK if context.quick else PHOTONS
    folder = context.work / f"monte-carlo-{photons}"
    folder.mkdir(parents=True, exist_ok=True)
    pairs = []
    for document in cases.random_spheres():
        kept = folder / f"{document['id']}.json"
        if context.reuse_monte_carlo and kept.exists():
            answer = json.loads(kept.read_text(encoding="utf-8"))
            if answer["layers"] == document["layers"] and answer["sun_zenith_deg"] == document["sun_zenith_deg"]:
                pairs.append((document, answer))
                continue
        answer, _ = context.program.solve(document, "--method", "monte-carlo", "--photons", photons, "--seed", SEED)
        kept.write_text(json.dumps(answer), encoding="utf-8")
        context.say(f"{document['id']} sampled")
        pairs.append((document, answer))
    # The cases themselves, for whoever wants to run one again.
    for document, _ in pairs:
        (folder / f"{document['id']}.case.json").write_text(json.dumps(document, indent=1), encoding="utf-8")
    return photons, pairs


def errors_of(document, ours, answer):
    """Deviation of an answer of the solver from the Monte Carlo's."""
    mean, error = cases.radiances(answer)
    return Errors.of(cases.radiances(ours)[0], mean, error, bar_of_sun(document["sun_zenith_deg"])[0])


def run(context):
    photons, pairs = sampled(context)
    all_errors, rows = {}, []
    for document, answer in pairs:
        ours, _ = context.program.solve(document)
        errors = errors_of(document, ours, answer)
        all_errors[document["id"]] = (document["sun_zenith_deg"], errors)
        worst = errors.worst
        view = document["results"][worst]
        rows.append([document["id"], f"{document['sun_zenith_deg']:.1f}", f"{document['observer_altitude_km']:.1f}",
                     cases.description(document), percent(numpy.sqrt(numpy.mean(errors.noise**2))),
                     percent(errors.rms), f"{errors.chi_square:.2f}",
                     f"{percent(errors.deviation[worst], sign=True)} ({errors.deviation[worst] / errors.noise[worst]:+.1f}σ) "
                     f"at {view['view_zenith_deg']:.0f}°, {view['relative_azimuth_deg']:.0f}°",
                     f"{errors.outside} of {errors.count}"])
    section = Section("Spherical solver against our Monte Carlo")
    section.add("Thirty random round planets (seeded): Rayleigh depth 0.03–0.4, haze 0–2 with g 0.5–0.85 and ω 0.85–1, an "
                "absorbing layer at 22 km, albedo 0–0.8, sun 0–94°, observers at 0–30 km, eight views each at 0–97° "
                f"zenith angle and any azimuth. The Monte Carlo (`--photons {photons} --seed {SEED}`) shares no transfer code "
                "with the solver. RMS: noise removed, 0 if noise explains all of it. χ²/n: mean square of the deviations in "
                "standard errors, 1 for noise alone; it grows without limit as photons are added, the RMS does not.")
    groups = {}
    for sun, errors in all_errors.values():
        groups.setdefault(group_of_sun(sun), (sun, []))[1].append(errors)
    group_rows = []
    for name in sorted(groups, key=lambda n: groups[n][0]):
        sun, errors = groups[name][0], Errors.joined(groups[name][1])
        bar, rms_bar = bar_of_sun(sun)
        group_rows.append([name, len(groups[name][1]), errors.count, f"{errors.chi_square:.2f}",
                           percent(errors.mean, sign=True), percent(errors.rms), percent(rms_bar),
                           percent(errors.deviation[errors.worst], sign=True), f"{errors.outside}"])
        section.check(f"Monte Carlo, 30 random atmospheres, sun {name}",
                      f"{len(groups[name][1])} atmospheres, τ_A ≤ 2, g ≤ 0.85, 0–30 km",
                      f"worst {percent(errors.deviation[errors.worst], sign=True)}, RMS {percent(errors.rms)}, "
                      f"χ²/n {errors.chi_square:.2f}, {errors.count} directions, {errors.outside} outside",
                      f"max(3σ, {percent(bar)}), RMS {percent(rms_bar)}",
                      errors.outside == 0 and errors.rms <= rms_bar)
    section.add(table(["sun", "cases", "directions", "χ²/n", "mean", "RMS", "bar of RMS", "worst for its bar",
                       "outside max(3σ, bar)"], group_rows))
    z = numpy.concatenate([e.deviation / e.noise for _, e in all_errors.values()])
    section.add(f"All {len(z)} z-scores: mean {z.mean():+.2f}, χ²/n {numpy.mean(z**2):.2f}, "
                f"{numpy.mean(numpy.abs(z) < 1) * 100:.0f} % within 1σ (normal: 68 %), "
                f"{numpy.mean(numpy.abs(z) < 2) * 100:.0f} % within 2σ (95 %), largest {numpy.abs(z).max():.1f}σ.")
    section.add(table(["case", "sun/°", "observer/km", "medium", "noise", "RMS", "χ²/n", "worst for its bar", "outside"],
                      rows))
    section.add("Rerun: `tools/validate --only monte-carlo`; one case: `skylut solve "
                f"out/validation/monte-carlo-{photons}/random_00.case.json --method monte-carlo --photons {photons} "
                f"--seed {SEED}`, and without the last three options for the solver.")
    return section
