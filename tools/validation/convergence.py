"""Every number of the quality `reference` refined by itself: levels, angles, sun nodes, steps, orders."""

import numpy

from .cases import case, exponential, gaussian, load, radiances
from .text import Section, percent, table

# Each with its value at the qualities default and reference, and a finer one. A share of the forward peak sets the
# Legendre degrees, and with them the azimuthal orders and the polar nodes.
NUMBERS = {
    "levels: scaled optical depth of a sublayer": ("optical-step", 0.04, 0.02, 0.01),
    "levels: thin layers merged": ("merge-layers", 1, 0, None),
    "angles: forward peak cut off": ("truncated-peak", 0.015, 0.006, 0.003),
    "angles: polar nodes per degree": ("polar-per-degree", 0.7, 0.9, 1.2),
    "angles: fewest polar nodes": ("polar-nodes", 10, 16, 24),
    "sun nodes: density": ("sun-nodes", 0, 1, 2),
    "line of sight: step, km": ("ray-step-km", 10, 5, 2.5),
    "sunbeam: change of its lowest altitude, km": ("sunbeam-step-km", 0.25, 0.125, 0.06),
    "orders: tolerance of the iteration": ("tolerance", 1e-3, 1e-4, 1e-5),
}
REFERENCE_CASES = ("sph_A_alb03_sza30_alt12", "sph_B_sza85_alt12", "sph_D_sza90_alt30", "sph_D_sza94_alt20")
# The highest orders of a hazy sky over a bright ground.
ORDERS = (1, 2, 4, 8, 16, 32)
BAR = 0.002


def hazy(name, sun_zenith_deg, observer_altitude_km, aerosol, asymmetry):
    """The whole sky, the horizon and a view of the aureole, in haze."""
    views = [(z, a) for z in (0.0, 30.0, 60.0, 80.0, 88.0) for a in (0.0, 90.0, 180.0)]
    views.append((max(0.0, min(89.0, sun_zenith_deg - 5.0)), 0.0))
    return case(name, rayleigh=exponential(0.2, 8.0), aerosol=exponential(aerosol, 2.0), ssa=0.95,
                asymmetry=asymmetry, absorption=gaussian(0.03, 22.0, 4.0), albedo=0.2,
                sun_zenith_deg=sun_zenith_deg, observer_altitude_km=observer_altitude_km, views=views)


def documents(context):
    """Cases by name: clear and hazy, from a high sun to twilight."""
    found = load(context.reference / "solver", "sph_*.json")
    chosen = {name: found[name] for name in REFERENCE_CASES if name in found}
    for made in (hazy("haze 0.5, g 0.7, sun 45°, 0 km", 45.0, 0.0, 0.5, 0.7),
                 hazy("haze 1, g 0.8, sun 75°, 6 km", 75.0, 6.0, 1.0, 0.8),
                 hazy("haze 0.3, g 0.7, sun 90°, 0 km", 90.0, 0.0, 0.3, 0.7)):
        chosen[made["id"]] = made
    return chosen


def solved(context, cases, *options):
    """Radiances of all cases in a row."""
    return numpy.concatenate([radiances(context.program.solve(document, *options)[0])[0]
                              for document in cases.values()])


def add_numbers(context, section, cases):
    """Each number coarse, as in the reference, and finer, all others as in the reference."""
    base = solved(context, cases, "--quality", "reference")
    rows, worst_finer, rms_finer = [], 0.0, 0.0
    for what, (name, coarse, usual, fine) in NUMBERS.items():
        row = [what]
        for value in (coarse, fine):
            if value is None:
                row += ["–", "–", "–"]
                continue
            context.say(f"{name} {value:g}")
            ratio = solved(context, cases, "--quality", "reference", "--limit", f"{name}={value}") / base - 1
            rms = float(numpy.sqrt(numpy.mean(ratio**2)))
            row += [f"{value:g}", percent(abs(ratio).max()), percent(rms)]
            if value == fine:
                worst_finer, rms_finer = max(worst_finer, float(abs(ratio).max())), max(rms_finer, rms)
        rows.append([row[0], f"{usual:g}", *row[1:]])
    section.check("convergence of quality `reference`", f"{len(base)} directions of {len(cases)} cases, one number finer at a time",
                  f"worst {percent(worst_finer)}, RMS {percent(rms_finer)}", f"RMS {percent(BAR)}", rms_finer <= BAR)
    section.add("### One number at a time")
    section.add(f"{len(base)} directions of {len(cases)} cases ({', '.join(cases)}). Change of the radiance against quality "
                "`reference` when one number (`skylut solve --limit NAME=VALUE`) is that of the quality `default`, "
                "or finer than the reference's.")
    section.add(table(["number", "reference", "default's", "worst", "RMS", "finer", "worst", "RMS"], rows))


def add_orders(context, section, cases):
    """Sums of the first orders of scattering against all."""
    section.add("### Orders of scattering")
    section.add("Largest share of the radiance that is missing after so many orders (`--orders N`); with `--orders` the "
                "forward peak is not cut off, so the last column tells how far the sum to 64 orders is from the "
                "converged answer with delta-M.")
    rows = []
    for name, document in cases.items():
        context.say(f"orders, {name}")
        whole = radiances(context.program.solve(document, "--orders", 64)[0])[0]
        row = [name]
        for orders in ORDERS:
            part = radiances(context.program.solve(document, "--orders", orders)[0])[0]
            row.append(percent(abs(part / whole - 1).max()))
        converged = radiances(context.program.solve(document)[0])[0]
        rows.append([*row, percent(numpy.sqrt(numpy.mean((converged / whole - 1) ** 2)))])
    section.add(table(["case", *map(str, ORDERS), "delta-M, RMS"], rows))


def run(context):
    """The section."""
    section = Section("Convergence: one number at a time")
    cases = documents(context)
    add_numbers(context, section, cases)
    add_orders(context, section, cases)
    section.add("Rerun: `tools/validate --only convergence`.")
    return section
