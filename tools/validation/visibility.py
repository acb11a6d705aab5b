"""Visibility and the other kinds of turbidity for the same air; visibility by turbidity as Preetham's Fig. 3 has it."""

import json
import math

from .text import Section, percent, table

AOD500 = (0, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0)
AEROSOLS = ("rural", "preetham")
KOSCHMIEDER = 3.912
# Rayleigh depth at 550 nm at sea level: Bodhaine et al. 1999, table 3.
RAYLEIGH_DEPTH = 0.0971
TOP_KM = 100
BOLTZMANN = 1.380649e-23
# Preetham, Shirley & Smits 1999, A.3, at 550 nm: the haze's K (their table 2), concentration (10^-18 for 10^-16, errata E11).
PREETHAM_K = 0.678
# Their Fig. 3 is not in the text. A drawing of it in the manual of SLIB's package `daylight` (A. Jaffer) gives these: ten columns
# and two lines for a factor of 2, so that a range is known within 20 % of the drawing; the drawing is itself a smooth curve made to
# resemble the figure.
FIGURE_3_KM = {1: 362, 2: 36, 4: 8, 8: 3.4, 16: 2, 32: 1.4, 64: 1}
# Where the words stand beside the drawn curve: turbidity, range/km.
FIGURE_3_WORDS = {"exceptionally clear": (1.2, 181), "very clear": (1.8, 45), "clear": (2.8, 16),
                  "light haze": (5.1, 5.7), "haze": (14, 2)}


def rayleigh_per_km():
    """Rayleigh extinction at the ground at 550 nm: cross-section by Bodhaine et al. 1999, eq. 29, times p/(kT) at 1013.25 hPa and
    288.15 K."""
    square = 0.55**2
    cross_section_m2 = 1e-32 * ((1.0455996 - 341.29061 / square - 0.90230850 * square) /
                                (1 + 0.0027059889 / square - 85.968563 * square))
    return 1000 * cross_section_m2 * 101325 / (BOLTZMANN * 288.15)


def scale_height_km(shape):
    """Column of the haze over its extinction at the ground: a mixed layer under exp(-z/H), or a table that is exponential between
    its altitudes."""
    if "altitude_km" not in shape:
        height = shape["scale_height_km"]
        return shape["mixed_layer_km"] + height * (1 - math.exp(-(TOP_KM - shape["mixed_layer_km"]) / height))
    z, value = shape["altitude_km"], shape["relative_extinction"]
    return sum((high - low) * (a - b) / math.log(a / b)
               for low, high, a, b in zip(z, z[1:], value, value[1:])) / value[0]


def koschmieder_km(aerosol, aod500):
    """The visibility that the definitions give on paper for an aerosol as `skylut aerosol show` describes it: extinction relative to
    500 nm, vertical shape, and a stratospheric layer that does not reach the ground."""
    haze500 = max(0.0, aod500 - aerosol["stratosphere"]["aod500"])
    haze550 = haze500 * aerosol["relative_extinction"][aerosol["wavelength_nm"].index(550)]
    return KOSCHMIEDER / (rayleigh_per_km() + haze550 / scale_height_km(aerosol["shape"]))


def paper_range_km(turbidity):
    """Meteorological range by the formulas of Preetham, Shirley & Smits 1999, A.3, at 550 nm."""
    wavelength_m = 550e-9
    molecules = 8 * math.pi**3 * (1.0003**2 - 1)**2 / (3 * 2.545e25 * wavelength_m**4) * (6 + 3 * 0.035) / (6 - 7 * 0.035)
    concentration = (0.6544 * turbidity - 0.6510) * 1e-18
    haze = 0.434 * concentration * math.pi * (2 * math.pi / wavelength_m)**2 * PREETHAM_K
    return KOSCHMIEDER / (1000 * (molecules + haze))


def described(context, name):
    return json.loads(context.program.run("aerosol", "show", name, "--json")[0])


def kinds(context, aerosol, name, value):
    """Every kind of turbidity for a value of one kind."""
    return json.loads(context.program.run("profile", "show", "ussa1976", "--json", "--aerosol", aerosol, "--turbidity-kind", name,
                                          "--turbidity", value)[0])["turbidity"]


def add_kinds(context, section):
    section.add("The same air in each kind, aerosol `rural`, then `preetham`. Koschmieder: 3.912 over the extinction at the ground at 550 nm; "
                "beside it the same from the definitions on paper: Bodhaine's cross-section times p/(kT), and the haze's depth at 550 nm "
                "over its scale height (extinction relative to 500 nm and shape from `skylut aerosol show NAME --json`). "
                "Back: aod500 that `--turbidity-kind visibility-km` returns for that visibility.")
    for name in AEROSOLS:
        aerosol = described(context, name)
        rows, worst, round_trip = [], 0.0, 0.0
        for aod500 in AOD500:
            row = kinds(context, name, "aod500", aod500)
            paper = koschmieder_km(aerosol, aod500)
            worst = max(worst, abs(row["visibility-km"] / paper - 1))
            # Not the clearest air: that visibility is one bit from being refused as longer than pure air's.
            returned = kinds(context, name, "visibility-km", row["visibility-km"])["aod500"] if aod500 else None
            if aod500:
                round_trip = max(round_trip, abs(returned / aod500 - 1))
            rows.append([f"{aod500:g}", f"{row['aod550']:.4f}", f"{row['angstrom-beta']:.4f}", f"{row['preetham-t']:.3f}",
                         f"{row['visibility-km']:.2f}", f"{paper:.2f}", f"{returned:.6f}" if aod500 else "–"])
        section.add(f"`{name}`, on paper: scale height {scale_height_km(aerosol['shape']):.4f} km, {aerosol['stratosphere']['aod500']:g} "
                    "of the load in the stratosphere.")
        section.add(table(["aod500", "aod550", "Ångström β", "Preetham T", "visibility/km", "on paper/km", "aod500 back"], rows))
        section.check(f"Koschmieder's visibility on paper, `{name}`", f"{len(rows)} loads, aod500 0–2", f"worst {percent(worst)}",
                      "0.5 %", worst <= 0.005)
        section.check(f"visibility there and back, `{name}`", f"{len(rows) - 1} loads", f"aod500 within {round_trip:.1e}", "1e-6",
                      round_trip <= 1e-6)


def add_figure_3(context, section):
    section.add("### Preetham's Fig. 3: meteorological range by turbidity")
    section.add("T = (τ_R + τ_A)/τ_R at 550 nm; range for a contrast of 2 %, 3.912 over the extinction at the ground. *A.3*: the paper's own "
                "scattering coefficients (K = 0.678, concentration with 10⁻¹⁸, [errata E11](errata.md#e11)). *Fig. 3*: the figure itself "
                "is not in the paper's text; read from a drawing of it (manual of SLIB's package `daylight`, A. Jaffer), "
                "± 20 % in range by its coarseness; it is a smooth curve made to resemble the figure, no data. *Implied height*: the scale height of haze that gives the figure's range at its T.")
    per_km = rayleigh_per_km()
    shape = scale_height_km(described(context, "preetham")["shape"])
    rows, ratios, formula, before = [], [], [], {}
    falls, worst = True, 0.0
    for turbidity, figure in FIGURE_3_KM.items():
        ours = {name: kinds(context, name, "preetham-t", turbidity)["visibility-km"] for name in AEROSOLS}
        falls = falls and all(ours[name] < before.get(name, math.inf) for name in AEROSOLS)
        before = ours
        paper = paper_range_km(turbidity)
        height = (turbidity - 1) * RAYLEIGH_DEPTH / (KOSCHMIEDER / figure - per_km) if turbidity > 1 else None
        on_paper = KOSCHMIEDER / (per_km + (turbidity - 1) * RAYLEIGH_DEPTH / shape)
        worst = max(worst, abs(ours["preetham"] / on_paper - 1))
        ratios.append(ours["preetham"] / figure)
        formula.append(ours["preetham"] / paper)
        rows.append([f"{turbidity}", f"{ours['preetham']:.3g}", f"{ours['rural']:.3g}", f"{paper:.3g}", f"{figure:g}",
                     f"{ratios[-1]:.2f}", f"{height:.2f}" if height else "–"])
    section.add(table(["T", "`preetham`/km", "`rural`/km", "A.3/km", "Fig. 3/km", "`preetham` / Fig. 3", "implied height/km"], rows))
    words = []
    for word, (turbidity, drawn_km) in FIGURE_3_WORDS.items():
        preetham, rural = (kinds(context, name, "preetham-t", turbidity)["visibility-km"] for name in ("preetham", "rural"))
        words.append(f"{word} at T {turbidity:g} and {drawn_km:g} km (`preetham` {preetham:.3g} km, `rural` {rural:.3g} km)")
    section.add(f"The drawing's words: {'; '.join(words)}.")
    section.add("T is a column, range a matter of the ground: which range belongs to a T depends on how high the haze reaches. Ours keep "
                f"one shape at every load (`preetham`: Elterman, {shape:.2f} km; `rural` 2 km; A.3: 1.2 km), so that their ranges fall "
                "nearly as 1/(T − 1). The figure's fall steeper to T ≈ 4 and less steep above 16: McCartney's hazes are shallower than "
                "Elterman's between, by the implied heights. A.3 against `preetham`: the scale heights' ratio less the 2.4 % by which "
                "A.3's concentration falls short of its own T (E11: T 6 comes back as 5.88); in pure air A.3 rounds n − 1 from 2.78e-4 "
                "to 3e-4 (340 km become 288) and leaves some haze (c = 0.0034e-18: 280). One who knows the range should give it "
                "(`--turbidity-kind visibility-km`), not a T read from the figure.")
    section.check("range falls with turbidity", f"T 1–64, {' and '.join(AEROSOLS)}", "every step" if falls else "not everywhere", "every step", falls)
    section.check("range by `preetham-t` on paper, `preetham`", f"T 1–64: 3.912/(β_R + (T − 1) {RAYLEIGH_DEPTH}/{shape:.2f} km)",
                  f"worst {percent(worst)}", "0.5 %", worst <= 0.005)
    hazy = [f for f, t in zip(formula, FIGURE_3_KM) if t >= 4]
    section.check("Preetham's A.3, range", "`preetham`, T 4–64",
                  f"ratio {min(hazy):.3f}–{max(hazy):.3f}; the heights' is {shape / 1.2:.3f}", "–", None)
    section.check("Preetham's Fig. 3, range (redrawn)", "`preetham`, T 1–64", f"ratio {min(ratios):.2f}–{max(ratios):.2f}", "–", None)


def run(context):
    section = Section("Visibility and turbidity")
    add_kinds(context, section)
    add_figure_3(context, section)
    section.add("Rerun: `tools/validate --only visibility`; one load: `skylut profile show ussa1976 --turbidity 0.1`, "
                "or `--turbidity-kind visibility-km --turbidity 23`.")
    return section
