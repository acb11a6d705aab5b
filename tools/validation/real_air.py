"""Zenith luminance and chromaticity of real air against our Monte Carlo, from `skylut profile case` at every wavelength."""

import json

import numpy

from .program import read_csv
from .sky import colour_matching, spectrum_csv, yxy
from .text import Section, percent, table

SKIES = {0: "clear", 0.1: "average", 0.5: "hazy"}
WAVELENGTHS_NM = range(380, 781, 20)
BAND_NM = 20
# Photons per band by sun zenith angle: for a standard error of 0.5 % or less.
PHOTONS = {0: 10_000, 45: 20_000, 75: 70_000}
PHOTONS_QUICK = 2_000
# A term of a band of lines gets its share of the photons, and no fewer than these.
LEAST_PHOTONS = 1_000
# Neighbouring layers whose Legendre moments differ by less than this share one phase function: the mean of theirs,
# weighted by what they scatter. The Monte Carlo tabulates every phase function anew, and 94 layers have as many mixtures of haze and
# stratospheric aerosol.
SAME_MOMENTS = 0.02


def difference(first, second):
    """Largest difference of two lists of moments, the shorter one continued by zeros."""
    length = max(len(first), len(second))
    return abs(numpy.pad(first, (0, length - len(first))) - numpy.pad(second, (0, length - len(second)))).max()


def with_few_phase_functions(document):
    """The case with the phase functions of like neighbours replaced by their mean."""
    groups = []
    for layer in document["layers"]:
        if "phase_moments_aerosol" not in layer:
            continue
        moments = numpy.array(layer["phase_moments_aerosol"])
        if not groups or difference(groups[-1][0][1], moments) > SAME_MOMENTS:
            groups.append([])
        groups[-1].append((layer, moments))
    for group in groups:
        length = max(len(moments) for _, moments in group)
        weights = numpy.array([layer["tau_aerosol"] * layer["ssa_aerosol"] for layer, _ in group])
        weights = weights / weights.sum() if weights.sum() > 0 else numpy.full(len(group), 1 / len(group))
        mean = sum(w * numpy.pad(m, (0, length - len(m))) for w, (_, m) in zip(weights, group)).tolist()
        mean[0] = 1.0  # but for rounding
        for layer, _ in group:
            layer["phase_moments_aerosol"] = mean
            layer["g_aerosol"] = mean[1]
    return document


def band(context, aod500, wavelength_nm):
    """The cases of a band, one for each term of its lines; their weights sum to 1."""
    documents, weight = [], 0.0
    while weight < 1 - 1e-9:
        text, _ = context.program.run("profile", "case", "ussa1976", "--wavelength-nm", wavelength_nm, "--band-nm", BAND_NM,
                                      "--turbidity", aod500, "--view", "0:0", "--absorption-term", len(documents) + 1, "-o", "-")
        documents.append(with_few_phase_functions(json.loads(text)))
        weight += documents[-1]["absorption_term_weight"]
    return documents


def sampled_and_solved(context, documents, sun_zenith_deg, seed):
    """The band's zenith radiance per irradiance above the air: Monte Carlo, its standard error, our solver."""
    photons = PHOTONS_QUICK if context.quick else PHOTONS[sun_zenith_deg]
    mean = variance = solved = 0.0
    for term, document in enumerate(documents):
        case, weight = dict(document, sun_zenith_deg=sun_zenith_deg), document["absorption_term_weight"]
        sampled = context.program.solve(case, "--method", "monte-carlo", "--photons",
                                        max(LEAST_PHOTONS, round(photons * weight)), "--seed", 10 * seed + term)[0]["results"][0]
        mean += weight * sampled["radiance"]
        variance += (weight * sampled["std"]) ** 2
        solved += weight * context.program.solve(case)[0]["results"][0]["radiance"]
    return mean, variance**0.5, solved


def irradiances(context):
    """Mean of the solar spectrum over each band, straight from its file."""
    nm, irradiance = list(spectrum_csv(context.profiles / "spectra/solar_astm_g173.csv").values())[:2]
    means = []
    for centre in WAVELENGTHS_NM:
        fine = numpy.linspace(centre - BAND_NM / 2, centre + BAND_NM / 2, 2001)
        curve = numpy.interp(fine, nm, irradiance)
        means.append(numpy.mean((curve[:-1] + curve[1:]) / 2))
    return numpy.array(means)


def spectrum_of_map(context, aod500, sun_zenith_deg):
    """The zenith's spectrum by `skylut map`, W m-2 nm-1 sr-1."""
    directions = context.work / "zenith.csv"
    directions.write_text("zenith_deg,azimuth_deg\n0,0\n", encoding="utf-8")
    out = context.work / "real-air-map.csv"
    context.program.run("map", "-o", out, "--turbidity", aod500, "--sun-zenith-deg", sun_zenith_deg, "--directions", directions,
                        "--wavelengths-nm", f"{WAVELENGTHS_NM[0]}:{WAVELENGTHS_NM[-1]}:{BAND_NM}", "--threads", 1)
    row = read_csv(out)[0]
    return numpy.array([row[name] for name in row if name.startswith("L_")])


def noise_of(wavelengths, radiance, errors, matching):
    """Standard errors of ln Y, x and y: each wavelength's own, added in squares."""
    luminance, *xy = yxy(wavelengths, radiance, matching)
    squares = numpy.zeros(3)
    for i, error in enumerate(errors):
        moved = radiance.copy()
        moved[i] += error
        other, *other_xy = yxy(wavelengths, moved, matching)
        squares += [(other / luminance - 1) ** 2, (other_xy[0] - xy[0]) ** 2, (other_xy[1] - xy[1]) ** 2]
    return numpy.sqrt(squares)


def run(context):
    section = Section("Real air at the zenith against our Monte Carlo")
    matching, sun = colour_matching(context), irradiances(context)
    wavelengths = numpy.array(WAVELENGTHS_NM, dtype=float)
    rows, luminance, chromaticity, deviations, extremes, of_layers = [], [], [], [], [], []
    seed = 0
    for aod500, name in SKIES.items():
        bands = [band(context, aod500, nm) for nm in WAVELENGTHS_NM]
        for zenith in PHOTONS:
            answers = []
            for documents in bands:
                seed += 1
                answers.append(sampled_and_solved(context, documents, zenith, seed))
            mean, error, solved = numpy.array(answers).T
            mapped = spectrum_of_map(context, aod500, zenith)
            ours, truth = yxy(wavelengths, mapped, matching), yxy(wavelengths, sun * mean, matching)
            noise = noise_of(wavelengths, sun * mean, sun * error, matching)
            off = ours[0] / truth[0] - 1
            away = max(abs(ours[1] - truth[1]), abs(ours[2] - truth[2]))
            per_band = mapped / (sun * mean) - 1
            z = (solved - mean) / error
            most = int(abs(z).argmax())
            luminance.append(off)
            chromaticity.append(away)
            deviations.append(z)
            extremes.append((abs(z[most]), f"{percent(solved[most] / mean[most] - 1, sign=True)} ± {percent(error[most] / mean[most])} "
                             f"at {WAVELENGTHS_NM[most]} nm, aod500 {aod500:g}, sun {zenith}°"))
            of_layers.append(abs(mapped / (sun * solved) - 1).max())
            rows.append([name, f"{aod500:g}", f"{zenith}", f"{truth[0] / 1000:.4g}", f"{ours[0] / 1000:.4g}",
                         f"{percent(off, sign=True)} ± {percent(noise[0])}",
                         f"{truth[1]:.4f}, {truth[2]:.4f}", f"{ours[1] - truth[1]:+.5f}, {ours[2] - truth[2]:+.5f}",
                         f"{max(noise[1:]):.5f}", percent(per_band[abs(per_band).argmax()], sign=True),
                         percent(error[abs(per_band).argmax()] / mean[abs(per_band).argmax()])])
            context.say(f"aod500 {aod500:g}, sun {zenith}°")
    z = numpy.concatenate(deviations)
    low = numpy.concatenate([d for d, sun_deg in zip(deviations, list(PHOTONS) * len(SKIES)) if sun_deg > 0])
    section.add(f"Profile `ussa1976`, aerosol `rural`, albedo 0.2, observer on the ground. For each of {len(wavelengths)} bands of "
                f"{BAND_NM} nm `skylut profile case` writes the layers (every term of lines a case of its own), our Monte Carlo solves them, and the "
                "spectrum times the solar file's band means gives Y, x and y; `skylut map` does all of it by itself in the same bands. "
                "The two share the optical properties, not the transfer, the sum of terms, or the weighting. "
                "±, noise: standard error of the Monte Carlo. With the sun at the zenith the view is into its aureole, the disc left out.")
    section.add(table(["sky", "aod500", "sun/°", "Y Monte Carlo / kcd m⁻²", "`map`", "difference", "x, y Monte Carlo", "`map` −",
                       "noise of x, y", "worst band", "noise there"], rows))
    section.add(f"Our solver on the same cases, band by band: χ²/n {numpy.mean(z**2):.2f} over {len(z)} bands, mean "
                f"{z.mean():+.2f}σ, largest {max(extremes)[0]:.1f}σ ({max(extremes)[1]}); without the suns at the zenith, where the noise is least, χ²/n "
                f"{numpy.mean(low**2):.2f}. `map` against our solver on the cases: largest difference of a "
                f"band {percent(max(of_layers))} (the cases join phase functions of neighbouring layers that differ by less than "
                f"{SAME_MOMENTS:g} in every moment).")
    section.check("Monte Carlo, zenith luminance of real air", f"{len(rows)} skies: aod500 0, 0.1, 0.5; sun 0, 45, 75°",
                  f"worst {percent(max(luminance, key=abs), sign=True)}", "3 %", max(map(abs, luminance)) <= 0.03)
    section.check("Monte Carlo, zenith chromaticity of real air", "the same", f"worst {max(chromaticity):.4f}", "0.003",
                  max(chromaticity) <= 0.003)
    section.add("Rerun: `tools/validate --only real-air`; one band: `skylut profile case ussa1976 --wavelength-nm 540 --band-nm 20 "
                f"--turbidity 0.1 --view 0:0 -o case.json`, `skylut solve case.json --method monte-carlo --photons 100000`.")
    return section
