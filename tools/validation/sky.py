"""Luminance and colour at the zenith beside libRadtran's, and whether the table is physically possible."""

import csv

import numpy
from scipy.spatial import ConvexHull

from .figures import COLOURS, plt, save
from .program import read_csv
from .text import Section, percent, table

# Zenith luminance in kcd/m2 and x, y by libRadtran (plane-parallel DISORT, AFGL US standard, rural aerosol with
# exponent 1.3 over a background stratosphere, ground albedo 0.2): (aod500, sun zenith, altitude, Y, x, y).
LIBRADTRAN = [(0, 0, 0, 1.83, 0.234, 0.241), (0, 0, 12, 0.368, None, None), (0, 0, 30, 0.023, None, None),
              (0, 45, 0, 1.36, 0.233, 0.239), (0, 45, 12, 0.279, 0.227, 0.229), (0, 45, 30, 0.018, None, None),
              (0, 80, 0, 0.657, 0.236, 0.249), (0, 80, 12, 0.159, None, None), (0, 80, 30, 0.011, None, None),
              (0.1, 45, 0, 2.62, 0.262, 0.273), (0.1, 45, 12, 0.381, None, None), (0.1, 45, 30, 0.022, None, None),
              (0.5, 45, 0, 6.65, 0.289, 0.305), (0.5, 45, 12, 0.390, None, None), (0.5, 45, 30, 0.022, None, None)]
PEAK_LUMENS_PER_WATT = 683.002


def spectrum_csv(path):
    """Columns of a CSV file as arrays."""
    rows = read_csv(path)
    return {name: numpy.array([row[name] for row in rows]) for name in rows[0]}


def colour_matching(context):
    """Wavelengths and x, y, z of our own table."""
    with open(context.profiles / "spectra/cie1931_2deg.csv", encoding="utf-8") as file:
        lines = list(csv.reader(line for line in file if not line.startswith("#")))
    values = numpy.array(lines[1:], dtype=float)
    return values[:, 0], values[:, 1:4]


def yxy(wavelengths, radiance, matching):
    """Luminance and chromaticity by the sum over equally spaced wavelengths."""
    nodes, curves = matching
    step = wavelengths[1] - wavelengths[0]
    curves = numpy.column_stack([numpy.interp(wavelengths, nodes, curve) for curve in curves.T])
    xyz = PEAK_LUMENS_PER_WATT * step * radiance @ curves
    return xyz[1], xyz[0] / xyz.sum(), xyz[1] / xyz.sum()


def zenith(context, turbidity, sun_zenith_deg, altitude_km):
    """The zenith's row of a map: Y, x, y and the spectrum."""
    directions = context.work / "zenith.csv"
    directions.write_text("zenith_deg,azimuth_deg\n0,0\n", encoding="utf-8")
    out = context.work / "zenith-map.csv"
    context.program.run("map", "-o", out, "--altitude-km", altitude_km, "--turbidity", turbidity, "--sun-zenith-deg",
                        sun_zenith_deg, "--directions", directions, "--threads", 1)
    row = read_csv(out)[0]
    wavelengths = numpy.array([float(name[2:]) for name in row if name.startswith("L_")])
    return row, wavelengths, numpy.array([row[name] for name in row if name.startswith("L_")])


def under_another_sun(context, matching, wavelengths, radiance):
    """Chromaticity of the same sky under Kurucz's spectrum: as 5 nm bands, and sampled at 10 nm points."""
    kurucz = spectrum_csv(context.reference / "data/solar_kurucz_gueymard_1nm.csv")
    names = list(kurucz)
    nm, flux = kurucz[names[0]], kurucz[next(n for n in names if "kurucz" in n.lower())]
    own = spectrum_csv(context.profiles / "spectra/solar_astm_g173.csv")
    own_nm, own_flux = (own[name] for name in list(own)[:2])
    per_sun = radiance / numpy.interp(wavelengths, own_nm, own_flux)
    bands = numpy.array([flux[(nm >= w - 2.5) & (nm <= w + 2.5)].mean() for w in wavelengths])
    points = numpy.interp(wavelengths, nm, flux)
    return yxy(wavelengths, per_sun * bands, matching), yxy(wavelengths[::2], (per_sun * points)[::2], matching)


def add_zenith(context, section):
    section.add("### Zenith luminance and chromaticity beside libRadtran")
    section.add("libRadtran: plane-parallel DISORT, AFGL US standard, rural aerosol with exponent 1.3 over a "
                "background stratosphere, ground albedo "
                "0.2. Ours is another model of the same air (spherical, our aerosol shape and albedo): near, not "
                "equal.")
    matching = colour_matching(context)
    has_kurucz = (context.reference / "data/solar_kurucz_gueymard_1nm.csv").exists()
    rows, ratios, plain, sampled = [], [], [], []
    for aod, sun, altitude, luminance, x, y in LIBRADTRAN:
        ours, wavelengths, radiance = zenith(context, aod, sun, altitude)
        ratio = ours["Y_cd_m2"] / 1000 / luminance - 1
        if aod == 0 and sun < 80 and altitude < 30:
            ratios.append(abs(ratio))
        row = [f"{aod:g}", f"{sun:g}", f"{altitude:g}", f"{luminance:g}", f"{ours['Y_cd_m2'] / 1000:.4g}",
               percent(ratio, sign=True),
               f"{x:.3f}, {y:.3f}" if x else "–", f"{ours['x']:.4f}, {ours['y']:.4f}"]
        if has_kurucz:
            bands, points = under_another_sun(context, matching, wavelengths, radiance)
            row += [f"{bands[1]:.4f}, {bands[2]:.4f}", f"{points[1]:.4f}, {points[2]:.4f}"]
            if x and aod == 0:
                plain.append(max(abs(ours["x"] - x), abs(ours["y"] - y)))
                sampled.append(max(abs(points[1] - x), abs(points[2] - y)))
        rows.append(row)
    header = ["aod500", "sun/°", "altitude/km", "Y libRadtran / kcd m⁻²", "ours", "difference", "x, y libRadtran",
              "ours"]
    section.add(table(header + (["ours, Kurucz's sun in 5 nm bands",
                                 "ours, Kurucz's sun at 10 nm points"] if has_kurucz else []), rows))
    section.check("libRadtran's zenith luminance, no aerosol", "sun 0° and 45°, 0 and 12 km",
                  f"worst {percent(max(ratios))}", "5 %", max(ratios) <= 0.05)
    if has_kurucz:
        section.check("libRadtran's zenith chromaticity, no aerosol",
                      "as it is; with libRadtran's solar spectrum as it was sampled",
                      f"worst {max(plain):.4f}; {max(sampled):.4f}", "0.004 with the same sun", max(sampled) <= 0.004)
        section.add("Why y differs: libRadtran's figures used the solar spectrum of Kurucz (1992) sampled at 10 nm "
                    "points, whose absorption lines "
                    "happen to miss or hit the points. The last two columns put that spectrum in the place of ours "
                    "(ASTM G173, 5 nm means) in "
                    "the same skies: as 5 nm means it changes little, at 10 nm points it raises y by 0.006–0.008, to "
                    "libRadtran's "
                    "figures. The means are right: the eye integrates.")
    section.add("Where there is aerosol the two models put it differently; from 12 and 30 km only the stratospheric "
                "layer is left. At aod500 = 0 "
                "ours has no aerosol at all, also in the stratosphere.")


def add_plausibility(context, section):
    rows = read_csv(context.table() / "table.csv")
    key = lambda row: (row["altitude_km"], row["turbidity"], row["sun_zenith_deg"])
    names = [f"{k}_{c}" for c in "Yxy" for k in "ABCDE"] + ["Y_zenith_kcd_m2", "x_zenith", "y_zenith"]
    suns = {}
    for row in rows:
        suns.setdefault(key(row), []).append(row)
    mirror = max(abs(pair[0][n] / pair[1][n] - 1) for pair in suns.values() if len(pair) == 2 for n in names)
    pairs = sum(len(pair) == 2 for pair in suns.values())
    altitudes = sorted({row["altitude_km"] for row in rows})
    rises = 0
    for turbidity, sun in {(t, s) for _, t, s in suns}:
        luminance = [suns[(z, turbidity, sun)][0]["Y_zenith_kcd_m2"] for z in altitudes]
        rises += sum(high >= low for low, high in zip(luminance, luminance[1:]))
    locus = locus_hull(context)
    inside = sum(all(locus[:, :2] @ (sky["x"], sky["y"]) + locus[:, 2] <= 0)
                 for path in sorted((context.table() / "maps").glob("entry_*.csv")) for sky in read_csv(path))
    skies = 271 * len(rows)
    section.add("### Plausibility of the 75-entry table")
    section.add("What no table can break and be physics: see the summary for the verdicts (mirror-symmetric suns, "
                "zenith luminance over altitude, "
                "chromaticities of all 75 × 271 directions, sign of B).")
    section.check("mirror suns", f"{pairs} pairs of rows, coefficients and zenith",
                  f"largest relative difference {mirror:.1e}", "1e-6", mirror <= 1e-6)
    section.check("zenith luminance falls with altitude", "9 columns of 5 altitudes", f"{rises} rises", "0", rises == 0)
    section.check("chromaticities inside the spectral locus", f"{skies} directions", f"{skies - inside} outside", "0",
                  inside == skies)
    positive = sum(row[f"B_{c}"] >= 0 for row in rows for c in "Yxy")
    section.check("B < 0, finite at the horizon", "225 fits", f"{positive} not negative", "0", positive == 0)
    draw(context, rows)
    section.figure("zenith-luminance", "Luminance of the zenith over altitude in the table; lines join the table's five altitudes")


def locus_hull(context):
    """Half-planes (a, b, c), a x + b y + c <= 0, of the convex hull of the spectrum's chromaticities."""
    _, curves = colour_matching(context)
    total = curves.sum(axis=1, keepdims=True)
    return ConvexHull(curves[:, :2] / total).equations


def draw(context, rows):
    loads = sorted({row["turbidity"] for row in rows})
    suns = sorted({row["sun_zenith_deg"] for row in rows})
    figure, axes = plt.subplots(1, len(loads), figsize=(10, 3.4), sharey=True)
    for axis, load_ in zip(axes, loads):
        for sun, colour in zip(suns, COLOURS):
            points = sorted({(r["altitude_km"], r["Y_zenith_kcd_m2"]) for r in rows
                             if r["turbidity"] == load_ and r["sun_zenith_deg"] == sun and r["sun_azimuth_deg"] <= 90})
            axis.semilogy(*zip(*points), "o-", ms=4, lw=1, color=colour, label=f"sun zenith angle {sun:g}°")
        axis.set_title(f"aod500 = {load_:g}", fontsize=9)
        axis.set_xlabel("altitude / km")
    axes[0].set_ylabel("zenith luminance / kcd m$^{-2}$")
    axes[0].legend(fontsize=8)
    save(context, figure, "zenith-luminance")


def run(context):
    section = Section("The sky: luminance, colour, plausibility")
    add_zenith(context, section)
    add_plausibility(context, section)
    section.add("Rerun: `tools/validate --only sky`; one zenith: `skylut map -o sky.csv --turbidity 0.1 "
                "--sun-zenith-deg 45 --altitude-km 0`, its first row; "
                "the table: `skylut table --out DIR --save-maps`.")
    return section
