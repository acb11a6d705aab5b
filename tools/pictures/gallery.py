"""The pictures of docs/gallery.md."""

import csv
import pathlib
import subprocess
import tempfile

import numpy
import OpenImageIO
from matplotlib import pyplot

from pictures.tone import LUMINANCE, geometric_mean, tone_mapped

WEST_DEG = 270
SUNS = (92, 88, 80, 60, 30, 0)
ALTITUDES_KM = (0, 12, 30)
LOADS = {"clear": 0.05, "hazy": 0.5}
# Linear Rec. 709 from XYZ, IEC 61966-2-1.
RGB_OF_XYZ = numpy.array([[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]])


class Skies:
    """Skies of the program as arrays of linear Rec. 709."""

    def __init__(self, skylut, size):
        self.skylut, self.size = skylut, size

    def picture(self, *options):
        with tempfile.TemporaryDirectory() as scratch:
            file = pathlib.Path(scratch) / "sky.exr"
            self.run("-o", file, *options)
            return OpenImageIO.ImageBuf(str(file)).get_pixels(OpenImageIO.FLOAT).astype(float)

    def grid(self, zeniths_deg, azimuths_deg, *options):
        """[zenith][azimuth][RGB] in single directions."""
        with tempfile.TemporaryDirectory() as scratch:
            asked, answer = pathlib.Path(scratch) / "directions.csv", pathlib.Path(scratch) / "sky.csv"
            asked.write_text("zenith_deg,azimuth_deg\n" + "".join(f"{z:.6g},{a:.6g}\n" for z in zeniths_deg for a in azimuths_deg),
                             encoding="utf-8")
            self.run("-o", answer, "--directions", asked, *options)
            with open(answer, newline="", encoding="utf-8") as file:
                rows = csv.reader(line for line in file if not line.startswith("#"))
                names = next(rows)
                columns = [names.index(name) for name in ("Y_cd_m2", "x", "y")]
                luminance, x, y = numpy.array([[float(row[i]) for i in columns] for row in rows]).T
        xyz = numpy.stack([luminance * x / y, luminance, luminance * (1 - x - y) / y], axis=-1)
        return (xyz @ RGB_OF_XYZ.T).reshape(len(zeniths_deg), len(azimuths_deg), 3)

    def run(self, *options):
        subprocess.run([self.skylut, "map", *map(str, options)], check=True, stdout=subprocess.DEVNULL)


def save(figure, file):
    # No date and no version in the file: the same picture gives the same bytes.
    figure.savefig(file, metadata={"Software": None})
    pyplot.close(figure)


def sunrise_to_noon(skies, name, file):
    """A row per altitude, a fisheye per sun; one exposure per row."""
    figure, axes = pyplot.subplots(len(ALTITUDES_KM), len(SUNS), figsize=(8.0, 4.4), dpi=100, layout="constrained")
    for row, altitude_km in zip(axes, ALTITUDES_KM):
        strip = [skies.picture("--projection", "fisheye", "--size", skies.size, "--altitude-km", altitude_km, "--turbidity", LOADS[name],
                               "--sun-zenith-deg", sun, "--sun-azimuth-deg", WEST_DEG) for sun in SUNS]
        inside = [numpy.maximum(sky @ LUMINANCE, 1e-3)[sky.sum(axis=-1) > 0] for sky in strip]
        half_cd_m2 = 1.5 * geometric_mean(numpy.concatenate(inside[1:]))
        for axis, sky, sun in zip(row, strip, SUNS):
            shown = tone_mapped(sky, half_cd_m2)
            shown[sky.sum(axis=-1) == 0] = 1
            axis.imshow(shown, interpolation="bilinear")
            axis.set_xticks([])
            axis.set_yticks([])
            axis.set_frame_on(False)
            if altitude_km == 0:
                axis.set_title(f"{90 - sun}°", fontsize=9)
        row[0].set_ylabel(f"{altitude_km} km\n{half_cd_m2:.0f} cd/m²", fontsize=9)
    figure.suptitle(f"sun from 2° below the horizon to the zenith, {name} (aerosol optical depth {LOADS[name]})", fontsize=10)
    save(figure, file)


def strip(rgb, extent, title, half_cd_m2, aspect, file):
    figure, axis = pyplot.subplots(figsize=(9.6, 4.2), dpi=100, layout="constrained")
    axis.imshow(tone_mapped(rgb, half_cd_m2), extent=extent, interpolation="bilinear", aspect=aspect)
    axis.set_xlabel("azimuth, degrees (90 east, 270 west)", fontsize=8)
    axis.set_ylabel("zenith angle, degrees", fontsize=8)
    axis.tick_params(labelsize=8)
    axis.set_title(title, fontsize=10)
    save(figure, file)


def limb(skies, file):
    """The horizon from 12 km, seven degrees of zenith angle stretched 20 times against azimuth."""
    zeniths, azimuths = numpy.arange(88, 95.01, 0.02), numpy.arange(90, 270.01, 0.5)
    rgb = skies.grid(zeniths, azimuths, "--altitude-km", 12, "--turbidity", 0.1, "--sun-zenith-deg", 90, "--sun-azimuth-deg", WEST_DEG,
                     "--wavelengths-nm", "380:780:20")
    strip(rgb, (90, 270, 95, 88), "limb from 12 km, sun on the astronomical horizon at 270°, zenith angle stretched 20 times",
          geometric_mean(rgb @ LUMINANCE), 10, file)


def belt_of_venus(skies, file):
    """Towards the antisun from 12 km."""
    rgb = skies.grid(numpy.arange(55, 100.01, 0.25), numpy.arange(30, 150.01, 0.25), "--altitude-km", 12, "--turbidity", 0.05,
                     "--sun-zenith-deg", 93.5, "--sun-azimuth-deg", WEST_DEG, "--wavelengths-nm", "380:780:20")
    strip(rgb, (30, 150, 100, 55), "towards the antisun (90°) from 12 km, sun 3.5° below the horizon in the west",
          1.2 * geometric_mean(rgb @ LUMINANCE), 1, file)


GALLERY = {
    "day-clear": lambda skies, file: sunrise_to_noon(skies, "clear", file),
    "day-hazy": lambda skies, file: sunrise_to_noon(skies, "hazy", file),
    "limb-12km": limb,
    "belt-of-venus": belt_of_venus,
}
