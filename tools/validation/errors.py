"""How far an answer is from its reference, with the noise of a Monte Carlo reference taken out."""

import dataclasses

import numpy

# What a spherical solver has to reach: (lowest, highest sun zenith angle, every direction, RMS), fractions.
SPHERICAL_BARS = [(0.0, 87.0, 0.007, 0.003), (87.0, 91.0, 0.01, 0.004), (91.0, 93.0, 0.02, 0.008),
                  (93.0, 96.0, 0.04, 0.02)]


def bar_of_sun(sun_zenith_deg):
    """(every direction, RMS) of the group of the sun's zenith angle."""
    for lowest, highest, worst, rms in SPHERICAL_BARS:
        if lowest <= sun_zenith_deg < highest:
            return worst, rms
    raise ValueError(f"no bar for a sun at {sun_zenith_deg}")


def group_of_sun(sun_zenith_deg):
    """The name of that group."""
    for lowest, highest, _, _ in SPHERICAL_BARS:
        if lowest <= sun_zenith_deg < highest:
            return {0.0: "≤ 87°", 87.0: "87–91°", 91.0: "91–93°", 93.0: "93–96°"}[lowest]
    raise ValueError(f"no group for a sun at {sun_zenith_deg}")


@dataclasses.dataclass
class Errors:
    """Relative deviations of one or more cases and the relative standard errors of their references."""

    deviation: numpy.ndarray
    noise: numpy.ndarray
    tolerance: numpy.ndarray  # of each direction, before 3 sigma is allowed

    @classmethod
    def of(cls, ours, reference, noise, tolerance):
        return cls((ours - reference) / reference, noise / reference, numpy.full(len(reference), tolerance))

    @classmethod
    def joined(cls, several):
        several = list(several)
        return cls(*(numpy.concatenate([getattr(e, field.name) for e in several])
                     for field in dataclasses.fields(cls)))

    @property
    def count(self):
        return len(self.deviation)

    @property
    def worst(self):
        """Index of the direction that uses most of max(3 sigma, tolerance)."""
        return int(numpy.argmax(numpy.abs(self.deviation) / self.allowed))

    @property
    def allowed(self):
        return numpy.maximum(3 * self.noise, self.tolerance)

    @property
    def outside(self):
        """Number of directions beyond max(3 sigma, tolerance)."""
        return int(numpy.sum(numpy.abs(self.deviation) > self.allowed))

    @property
    def largest(self):
        return float(numpy.max(numpy.abs(self.deviation)))

    @property
    def rms(self):
        """Root mean square deviation, the reference's variance subtracted; 0 if the noise explains all of it."""
        return float(numpy.sqrt(max(0.0, numpy.mean(self.deviation**2 - self.noise**2))))

    @property
    def rms_uncertainty(self):
        """Standard error of the mean square that `rms` is the root of, as the RMS that it could hide."""
        return float(numpy.sqrt(numpy.sqrt(numpy.sum(2 * self.noise**4)) / self.count))

    @property
    def mean(self):
        return float(numpy.mean(self.deviation))

    @property
    def chi_square(self):
        """Mean square of the deviations in standard errors; 1 if nothing but noise separates the two."""
        return float(numpy.mean((self.deviation / self.noise) ** 2))
