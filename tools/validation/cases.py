"""Solver cases: those of the reference sets, and those we make ourselves (schema: skylut solve)."""

import copy
import json
import math

import numpy

# Boundaries of the layers in the cases we make: those of the reference set.
LEVELS_KM = [float(z) for z in range(31)] + [35.0, 40.0, 45.0, 50.0, 60.0, 70.0, 80.0, 100.0]


def load(folder, pattern):
    """All cases of a reference folder that match, by name; empty if the folder is absent."""
    return {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in sorted(folder.glob(pattern))}


def radiances(case):
    """Radiance of each result of a case, and its standard error where there is one."""
    results = case["results"]
    return (numpy.array([r["radiance"] for r in results]), numpy.array([r.get("std", 0.0) for r in results]))


def exponential(total, scale_height_km):
    """An optical depth spread over the layers as exp(-z/H) up to the top."""
    edges = numpy.exp(-numpy.array(LEVELS_KM) / scale_height_km)
    return total * (edges[:-1] - edges[1:]) / (edges[0] - edges[-1])


def gaussian(total, centre_km, width_km):
    """An optical depth spread over the layers as a bell (standard deviation `width_km`)."""
    edges = numpy.array([math.erf((z - centre_km) / width_km / math.sqrt(2)) for z in LEVELS_KM])
    return total * (edges[1:] - edges[:-1]) / (edges[-1] - edges[0])


def case(name, *, rayleigh, aerosol, ssa, asymmetry, absorption, albedo, sun_zenith_deg, observer_altitude_km,
         views, planet_radius_km=6371.0):
    """A case in the schema of the reference set; `views` are (zenith, relative azimuth) in degrees, and a radius of
    None makes the layers plane."""
    return {
        "id": name,
        "geometry": "spherical" if planet_radius_km else "plane-parallel",
        "planet_radius_km": planet_radius_km,
        "levels_km": LEVELS_KM,
        "layers": [{"tau_rayleigh": float(r), "tau_aerosol": float(a), "ssa_aerosol": ssa, "g_aerosol": asymmetry,
                    "tau_absorption": float(x)} for r, a, x in zip(rayleigh, aerosol, absorption)],
        "albedo": albedo,
        "sun_zenith_deg": sun_zenith_deg,
        "observer_altitude_km": observer_altitude_km,
        "units": "radiance / TOA normal irradiance, sr^-1",
        "results": [{"view_zenith_deg": z, "relative_azimuth_deg": a, "radiance": 0.0} for z, a in views],
    }


def with_geometry(document, planet_radius_km):
    """The same layers on a planet of that radius, or in plane layers (None)."""
    changed = copy.deepcopy(document)
    changed["geometry"] = "spherical" if planet_radius_km else "plane-parallel"
    changed["planet_radius_km"] = planet_radius_km
    return changed


def random_haze(name, generator, asymmetry):
    """Plane layers: haze of depth 0.3-2 over a random ground, the whole sky without the horizon itself."""
    views = [(round(z, 2), round(a, 2)) for z, a in zip(generator.uniform(0, 88, 14), generator.uniform(0, 180, 14))]
    return case(name,
                rayleigh=exponential(generator.uniform(0.03, 0.4), 8.0),
                aerosol=exponential(generator.uniform(0.3, 2.0), generator.uniform(1.0, 3.0)),
                ssa=round(generator.uniform(0.85, 1.0), 3), asymmetry=asymmetry,
                absorption=gaussian(generator.uniform(0.0, 0.1), 22.0, 4.0),
                albedo=round(generator.uniform(0.0, 0.8), 2),
                sun_zenith_deg=round(generator.uniform(0.0, 82.0), 2),
                observer_altitude_km=0.0, views=views, planet_radius_km=None)


def random_sphere(index, generator, sun_zenith_deg):
    """A round planet under random air: the case of the Monte Carlo's judgement."""
    views = [(round(z, 2), round(a, 2)) for z, a in zip(generator.uniform(0, 97, 7), generator.uniform(0, 180, 7))]
    views.append((round(generator.uniform(86.0, 97.0), 2), round(generator.uniform(0, 180), 2)))
    aerosol = generator.uniform(0.0, 2.0) if index % 4 else 0.0
    return case(f"random_{index:02}",
                rayleigh=exponential(generator.uniform(0.03, 0.4), 8.0),
                aerosol=exponential(aerosol, generator.uniform(1.0, 3.0)),
                ssa=round(generator.uniform(0.85, 1.0), 3), asymmetry=round(generator.uniform(0.5, 0.85), 3),
                absorption=gaussian(generator.uniform(0.0, 0.2), 22.0, 4.0),
                albedo=round(generator.uniform(0.0, 0.8), 2), sun_zenith_deg=sun_zenith_deg,
                observer_altitude_km=round(generator.uniform(0.0, 30.0), 2) if index % 3 else 0.0, views=views)


def random_spheres():
    """Thirty cases with suns from the zenith to 94 degrees, half of them at 80 and lower in the sky."""
    generator = numpy.random.default_rng(20050801)
    suns = sorted([*generator.uniform(0, 80, 14), *generator.uniform(80, 90, 8), *generator.uniform(90, 94, 8)])
    return [random_sphere(i, generator, round(float(sun), 2)) for i, sun in enumerate(suns)]


def description(document):
    """Total optical depths and the ground, in words."""
    total = {key: sum(layer[key] for layer in document["layers"])
             for key in ("tau_rayleigh", "tau_aerosol", "tau_absorption")}
    words = f"τ_R {total['tau_rayleigh']:.2f}"
    if total["tau_aerosol"] > 0:
        hazy = next(layer for layer in document["layers"] if layer["tau_aerosol"] > 0)
        words += f", τ_A {total['tau_aerosol']:.2f}, ω {hazy['ssa_aerosol']:g}, g {hazy['g_aerosol']:g}"
    if total["tau_absorption"] > 1e-4:
        words += f", τ_abs {total['tau_absorption']:.2g}"
    return words + f", albedo {document['albedo']:g}"
