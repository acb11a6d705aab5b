"""The aerosol presets and Mie's theory against published figures."""

import json
import math

from .text import Section, table

# At 550 nm: single-scattering albedo, asymmetry; Angstrom exponents of 350-500 and 500-800 nm. Hess, Koepke & Schult 1998
# (OPAC), table 4, at 80 % humidity.
OPAC = {"continental-clean": (0.972, 0.709, 1.10, 1.42), "continental-average": (0.925, 0.703, 1.11, 1.42),
        "continental-polluted": (0.892, 0.698, 1.13, 1.45), "urban": (0.817, 0.689, 1.14, 1.43),
        "desert": (0.888, 0.729, 0.20, 0.17), "maritime-clean": (0.997, 0.772, 0.12, 0.08),
        "maritime-polluted": (0.975, 0.756, 0.41, 0.35)}
# Shettle & Fenn 1979, rural at 70 % humidity: wavelength -> extinction relative to 550 nm, albedo, asymmetry.
SHETTLE_FENN = {300.0: (1.74165, 0.9379, 0.6928), 550.0: (1.0, 0.9462, 0.6630)}
# Preetham, Shirley & Smits 1999, table 2: K; their extinction goes as K / wavelength^2.
PREETHAM_K = {400: 0.656, 450: 0.666, 550: 0.678, 650: 0.685}
# (x, n, k, Q_ext, Q_sca, g). Wiscombe 1979, NCAR/TN-140+STR, appendix; six decimals.
WISCOMBE = [(10, 0.75, 0, 2.232265, 2.232265, 0.896473), (1000, 0.75, 0, 1.997908, 1.997908, 0.844944),
            (100, 1.33, 1e-5, 2.101321, 2.096594, 0.868959), (0.055, 1.5, 1, 0.101491, 0.000011, 0.000491),
            (0.056, 1.5, 1, 0.103347, 0.000012, 0.000509), (1, 1.5, 1, 2.336321, 0.663454, 0.192136),
            (100, 1.5, 1, 2.097502, 1.283697, 0.850252), (10000, 1.5, 1, 2.004368, 1.236574, 0.846310),
            (1, 10, 10, 2.532993, 2.049405, -0.110664), (100, 10, 10, 2.071124, 1.836785, 0.556215),
            (10000, 10, 10, 2.005914, 1.795393, 0.548194)]
# Bohren & Huffman 1983, appendix A: radius 0.525 um, 632.8 nm, index 1.55; five decimals.
BOHREN_HUFFMAN = (5.21281571, 1.55, 0, 3.10543, 3.10543, 0.63314)
# Wiscombe's case x = 100, 1.5 + i: S11 by angle, six digits. (0 to 10 degrees excluded: his cosines were in single precision there.)
WISCOMBE_S11 = {0: 2.75830e7, 10: 1.39151e4, 30: 1208.65, 60: 606.236, 90: 474.503, 120: 438.391, 150: 431.440}


def shown(context, name):
    return json.loads(context.program.run("aerosol", "show", name, "--json")[0])


def sphere(context, size, n, k, *options):
    return json.loads(context.program.run("aerosol", "mie", "--size-parameter", size, "--index", f"{n},{k}", "--json",
                                          *options)[0])


def at(optics, key, nm):
    return optics[key][optics["wavelength_nm"].index(nm)]


def pair(ours, published, digits):
    return f"{ours:.{digits}f} ({published:.{digits}f})"


def add_presets(context, section):
    section.add("### Presets")
    section.add("At 550 nm; Ångström exponents of 350–500 and 500–800 nm. In brackets the published figure: OPAC (Hess, Koepke & Schult 1998, "
                "table 4, 80 % humidity); Shettle & Fenn 1979 for `rural`; K/λ² of Preetham, Shirley & Smits 1999, table 2, for `preetham` "
                "(400–450 and 550–650 nm).")
    rows, albedo_off, asymmetry_off, exponent_off = [], [], [], []
    for name, (albedo, asymmetry, short, long) in OPAC.items():
        optics = shown(context, name)
        exponents = optics["angstrom_exponent"]
        ours = (at(optics, "single_scattering_albedo", 550), at(optics, "asymmetry", 550), exponents["350-500"], exponents["500-800"])
        albedo_off.append(abs(ours[0] - albedo))
        asymmetry_off.append(abs(ours[1] - asymmetry))
        exponent_off += [abs(ours[2] - short), abs(ours[3] - long)]
        rows.append([f"`{name}`", pair(ours[0], albedo, 3), pair(ours[1], asymmetry, 3), pair(ours[2], short, 2),
                     pair(ours[3], long, 2), ratio(optics, 400), ratio(optics, 700)])
    rural = shown(context, "rural")
    for nm, (_, albedo, asymmetry) in SHETTLE_FENN.items():
        albedo_off.append(abs(at(rural, "single_scattering_albedo", nm) - albedo))
        asymmetry_off.append(abs(at(rural, "asymmetry", nm) - asymmetry))
    rows.append(["`rural`", pair(at(rural, "single_scattering_albedo", 550), SHETTLE_FENN[550][1], 4),
                 pair(at(rural, "asymmetry", 550), SHETTLE_FENN[550][2], 4),
                 f"{rural['angstrom_exponent']['350-500']:.2f}", f"{rural['angstrom_exponent']['500-800']:.2f}", ratio(rural, 400),
                 ratio(rural, 700)])
    haze = shown(context, "preetham")
    slopes = [(slope(haze, a, b), 2 - exponent(PREETHAM_K[b] / PREETHAM_K[a], b / a)) for a, b in ((400, 450), (550, 650))]
    rows.append(["`preetham`", f"{at(haze, 'single_scattering_albedo', 550):.3f}", f"{at(haze, 'asymmetry', 550):.3f}",
                 *[pair(*s, 2) for s in slopes], ratio(haze, 400), ratio(haze, 700)])
    section.add(table(["aerosol", "albedo", "asymmetry", "exponent, short waves", "long waves", "extinction 400/550 nm", "700/550 nm"],
                      rows))
    at300 = at(rural, "relative_extinction", 300) / at(rural, "relative_extinction", 550)
    section.add(f"`rural`, extinction at 300 nm relative to 550: {at300:.4f} (Shettle & Fenn {SHETTLE_FENN[300][0]:.4f}).")
    section.check("aerosol presets, published albedo", "OPAC, 7; Shettle & Fenn, rural at 300 and 550 nm", f"worst {max(albedo_off):.4f}",
                  "0.001", max(albedo_off) <= 0.001)
    section.check("aerosol presets, published asymmetry", "the same", f"worst {max(asymmetry_off):.4f}", "0.002", max(asymmetry_off) <= 0.002)
    section.check("aerosol presets, published Ångström exponents", "OPAC, 7 presets, 2 ranges", f"worst {max(exponent_off):.3f}",
                  "0.01", max(exponent_off) <= 0.01)
    section.check("rural extinction, 300 to 550 nm", "Shettle & Fenn 1979", f"{100 * (at300 / SHETTLE_FENN[300][0] - 1):+.3f} %", "0.2 %",
                  abs(at300 / SHETTLE_FENN[300][0] - 1) <= 0.002)


def exponent(ratio_of_values, ratio_of_wavelengths):
    """d ln y / d ln x between two points."""
    return math.log(ratio_of_values) / math.log(ratio_of_wavelengths)


def slope(optics, first_nm, second_nm):
    """Angstrom exponent between two wavelengths."""
    return -exponent(at(optics, "relative_extinction", second_nm) / at(optics, "relative_extinction", first_nm), second_nm / first_nm)


def ratio(optics, nm):
    return f"{at(optics, 'relative_extinction', nm) / at(optics, 'relative_extinction', 550):.4f}"


def add_spheres(context, section):
    section.add("### One sphere")
    section.add("`skylut aerosol mie` against Wiscombe 1979 (NCAR/TN-140+STR, appendix, six decimals) and Bohren & Huffman 1983 (appendix A, five); "
                "in brackets: ours less the printed figure, in 1e-6.")
    rows, worst = [], 0.0
    for case in [*WISCOMBE, BOHREN_HUFFMAN]:
        size, n, k, *published = case
        answer = sphere(context, size, n, k)
        off = [answer[key] - value for key, value in zip(("q_ext", "q_sca", "asymmetry"), published)]
        if case in WISCOMBE:
            worst = max(worst, *map(abs, off))
        rows.append([f"{size:g}", f"{n:g} + {k:g}i", *[f"{value + d:.6f} ({1e6 * d:+.1f})" for value, d in zip(published, off)]])
    section.add(table(["x", "index", "Q_ext", "Q_sca", "asymmetry"], rows))
    section.check("Mie efficiencies and asymmetry", "Wiscombe 1979, 11 spheres, x 0.055–10000", f"worst {worst:.1e}",
                  "1.0e-6 (printed digits)", worst <= 1.01e-6)
    answer = sphere(context, 100, 1.5, 1, "--angles", ",".join(map(str, WISCOMBE_S11)))
    # S11 = p x^2 Q_sca / 4.
    ours = [p * 100**2 * answer["q_sca"] / 4 for p in answer["phase_function"]]
    off = [a / b - 1 for a, b in zip(ours, WISCOMBE_S11.values())]
    section.add("Intensity S11 of the sphere with x = 100, index 1.5 + i:")
    section.add(table(["angle/°", "Wiscombe", "ours", "difference"],
                      [[f"{angle}", f"{s11:.6g}", f"{a:.7g}", f"{d:+.1e}"] for (angle, s11), a, d in zip(WISCOMBE_S11.items(), ours, off)]))
    section.check("Mie phase function", f"Wiscombe 1979, x = 100, {len(off)} angles", f"worst {max(map(abs, off)):.1e}", "1e-5",
                  max(map(abs, off)) <= 1e-5)


def run(context):
    section = Section("Aerosols")
    add_presets(context, section)
    add_spheres(context, section)
    section.add("Rerun: `tools/validate --only aerosols`; one preset: `skylut aerosol show urban`; one sphere: `skylut aerosol mie "
                "--size-parameter 100 --index 1.33,1e-5`. Against 60–1000 digits, x 0.03–500: [aerosols.md](aerosols.md).")
    return section
