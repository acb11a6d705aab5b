"""The sun's direct beam against ASTM G-173, and the closed forms beside it."""

import csv
import pathlib

from .program import read_csv
from .text import Section, percent, table

TABLE = pathlib.Path(__file__).resolve().parents[2] / "tests/data/astm_g173_direct_10nm.csv"
# The standard's air.
AIR = ("--profile", "ussa1976", "--sun-zenith-deg", "48.236", "--turbidity-kind", "aod500", "--turbidity", "0.084",
       "--aerosol", "rural", "--water-cm", "1.416", "--ozone-du", "343.8", "--no2-du", "0.204", "--solar", "astm-g173")
BANDS = ("--wavelengths-nm", "405:795:10")
CIRCUMSOLAR_DEG = 2.9
# Bands in which water vapour or oxygen takes more than a few per cent of the light.
STRONG = {(590, 600), (620, 630), (640, 650), (650, 660), (680, 690), (690, 700), (700, 710), (710, 720), (720, 730),
          (730, 740), (750, 760), (760, 770), (780, 790), (790, 800)}
VISIBLE = range(400, 700)


def published():
    """Bands of the standard's direct + circumsolar column: {(lower, upper): W m-2 nm-1}."""
    with open(TABLE, newline="", encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {(int(row["lower_nm"]), int(row["upper_nm"])): float(row["direct_normal_w_m2_nm"]) for row in rows}


def computed(context, name, *options):
    """Rows of sun.csv by band."""
    path = context.work / f"sun-{name}.csv"
    context.program.run("sun", *AIR, *BANDS, *options, "-o", path)
    return {(round(row["wavelength_nm"] - 5), round(row["wavelength_nm"] + 5)): row for row in read_csv(path)}


def deviations(bands, reference, column="direct_normal_w_m2_nm"):
    """Relative deviation of each band."""
    return {band: bands[band][column] / reference[band] - 1 for band in reference}


def whole(bands, reference):
    """Relative deviation of 400-700 nm as a whole."""
    visible = [band for band in reference if band[0] in VISIBLE]
    return sum(bands[b]["direct_normal_w_m2_nm"] for b in visible) / sum(reference[b] for b in visible) - 1


def run(context):
    section = Section("The sun's direct beam")
    reference = published()
    shells = computed(context, "shells", "--circumsolar-deg", CIRCUMSOLAR_DEG)
    iqbal = computed(context, "iqbal", "--model", "iqbal")
    smarts = computed(context, "smarts-like", "--model", "smarts-like")
    section.add("Direct normal irradiance in 10 nm bands against ASTM G-173-03's published table (its *direct + circumsolar* "
                f"column), for the standard's air. Its light within {CIRCUMSOLAR_DEG}° of the sun is not in our direct beam; the "
                "column *circumsolar* says how much it is. Closed forms: `skylut sun --model`.")
    off = deviations(shells, reference)
    off_iqbal, off_smarts = deviations(iqbal, reference), deviations(smarts, reference)
    section.add(table(["band/nm", "ASTM G-173, W m⁻² nm⁻¹", "ours", "circumsolar", "iqbal", "smarts-like"],
                      [[f"{band[0]}–{band[1]}" + (" *" if band in STRONG else ""), f"{reference[band]:.4f}",
                        percent(off[band], sign=True),
                        percent(shells[band]["circumsolar_normal_w_m2_nm"] / shells[band]["direct_normal_w_m2_nm"]),
                        percent(off_iqbal[band], sign=True), percent(off_smarts[band], sign=True)]
                       for band in reference]) + "\n\n\\* water vapour or oxygen absorb strongly.")
    visible = [band for band in reference if band[0] in VISIBLE]
    clear = max(abs(off[band]) for band in visible if band not in STRONG)
    strong = max(abs(off[band]) for band in visible if band in STRONG)
    section.check("direct beam, 400–700 nm, outside strong bands", "ASTM G-173", f"worst {percent(clear)}", "3 %",
                  clear <= 0.03)
    section.check("direct beam, 400–700 nm, inside them", "ASTM G-173", f"worst {percent(strong)}", "5 %", strong <= 0.05)
    section.check("direct beam, 400–700 nm, as a whole", "ASTM G-173", percent(whole(shells, reference), sign=True), "1 %",
                  abs(whole(shells, reference)) <= 0.01)
    section.add(f"As a whole, 400–700 nm: ours {percent(whole(shells, reference), sign=True)}, iqbal "
                f"{percent(whole(iqbal, reference), sign=True)}, smarts-like {percent(whole(smarts, reference), sign=True)}.")
    section.add(f"Rerun: `tools/validate --only sun`; one spectrum: `skylut sun {' '.join(AIR)} -o sun.csv`.")
    return section
