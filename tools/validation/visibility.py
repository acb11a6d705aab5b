"""Visibility and the other kinds of turbidity for the same air."""

import json
import math

from .text import Section, table

AOD500 = (0, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0)
KOSCHMIEDER = 3.912
ANGSTROM_EXPONENT = 1.3
HAZE_SCALE_HEIGHT_KM = 2.0
STRATOSPHERIC_AOD500 = 0.005
# Rayleigh extinction at the ground at 550 nm: the optical depth 0.0971 of Bodhaine et al. 1999 over the scale
# height of the column, R T/(M g) = 8.43 km at 288.15 K.
RAYLEIGH_PER_KM = 0.0971 / 8.43


def koschmieder_km(aod500):
    """The visibility that the definitions give on paper: haze exp(-z/2 km) under 0.005 of stratospheric aerosol."""
    haze550 = max(0.0, aod500 - STRATOSPHERIC_AOD500) * (550 / 500) ** -ANGSTROM_EXPONENT
    ground = haze550 / (HAZE_SCALE_HEIGHT_KM * (1 - math.exp(-100 / HAZE_SCALE_HEIGHT_KM)))
    return KOSCHMIEDER / (RAYLEIGH_PER_KM + ground)


def kinds(context, name, values):
    """Every kind of turbidity for the values of one kind, as table.json lists them."""
    folder = context.work / f"turbidity-{name}"
    context.program.run("table", "--out", folder, "--turbidity-kind", name, "--turbidities", ",".join(map(str, values)),
                        "--altitudes-km", "0",
                        "--suns", "45:180", "--wavelengths-nm", "400:700:50", "--quality", "draft", "--threads", 1)
    return json.loads((folder / "table.json").read_text(encoding="utf-8"))["inputs"]["turbidities"]


def run(context):
    section = Section("Visibility and turbidity")
    section.add("The same air in each kind. Koschmieder: 3.912 over the extinction at the ground at 550 nm; beside it "
                "the same from the definitions "
                "on paper (Rayleigh 0.0971 over 8.43 km; haze of 2 km scale height, 0.005 of it in the stratosphere). "
                "Back: aod500 that "
                "`--turbidity-kind visibility-km` returns for that visibility.")
    given = kinds(context, "aod500", AOD500)
    # Not the clearest air: that visibility is one bit from being refused as longer than pure air's.
    back = kinds(context, "visibility-km", [g["visibility-km"] for g in given[1:]])
    rows, worst, round_trip = [], 0.0, 0.0
    for i, row in enumerate(given):
        paper = koschmieder_km(row["aod500"])
        worst = max(worst, abs(row["visibility-km"] / paper - 1))
        returned = back[i - 1]["aod500"] if i else None
        # A visibility cannot tell the stratospheric layer: what comes back is that layer plus the haze.
        if i:
            round_trip = max(round_trip, abs(returned / row["aod500"] - 1))
        rows.append([f"{row['aod500']:g}", f"{row['aod550']:.4f}", f"{row['angstrom-beta']:.4f}",
                     f"{row['preetham-t']:.3f}",
                     f"{row['visibility-km']:.2f}", f"{paper:.2f}", f"{returned:.6f}" if i else "–"])
    section.add(table(["aod500", "aod550", "Ångström β", "Preetham T", "visibility/km", "on paper/km", "aod500 back"],
                      rows))
    section.check("Koschmieder's visibility on paper", f"{len(rows)} loads, aod500 0–2", f"worst {100 * worst:.2f} %",
                  "0.5 %", worst <= 0.005)
    section.check("visibility there and back", f"{len(rows) - 1} loads", f"aod500 within {round_trip:.1e}", "1e-6",
                  round_trip <= 1e-6)
    section.add("Rerun: `tools/validate --only visibility`; one load: `skylut profile show ussa1976 --turbidity 0.1`, "
                "or `--turbidity-kind visibility-km --turbidity 23`.")
    return section
