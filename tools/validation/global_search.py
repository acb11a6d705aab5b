"""Search for the best Perez coefficients that shares nothing with the program's.

Formula: F(theta, gamma) = (1 + A e^(B/cos theta)) (1 + C e^(D gamma) + E cos^2 gamma), and the sky
v = v_zenith F(theta, gamma)/F(0, theta_sun). Unknowns here: a, c, e of the equivalent form without poles

    v/v_zenith = (1 + a (e^(B (1/cos theta - 1)) - 1))
                 (1 + c (e^(D gamma) - e^(D theta_sun)) + e (cos^2 gamma - cos^2 theta_sun)),

and B, D mapped into the program's bounds by a logistic function. All five move at once under SciPy's
Levenberg-Marquardt (the program eliminates c and e), and the starts are random (the program's are the valleys
of a grid).
"""

import numpy
from scipy.optimize import least_squares

B_BOUNDS = (-80.0, -1e-5)
D_BOUNDS = (-80.0, 25.0)


def horizon_secant(zenith_rad):
    """1/cos of the zenith angle, infinite at the horizon."""
    cosine = numpy.cos(zenith_rad)
    return numpy.where(cosine > 1e-12, 1.0 / numpy.maximum(cosine, 1e-12), numpy.inf)


def perez_sky(coefficients, zenith_rad, gamma_rad, sun_zenith_rad, zenith_value):
    """The sky of the published formula: what the program's coefficients mean."""
    a, b, c, d, e = coefficients

    def formula(secant, gamma):
        return (1 + a * numpy.exp(b * secant)) * (1 + c * numpy.exp(d * gamma) + e * numpy.cos(gamma) ** 2)

    return zenith_value * formula(horizon_secant(zenith_rad), gamma_rad) / formula(1.0, sun_zenith_rad)


class Problem:
    """One channel of one sky: residuals over the different directions, weighted by how often each occurs."""

    def __init__(self, zenith_deg, gamma_deg, values, sun_zenith_deg, zenith_value, relative):
        self.sun = numpy.radians(sun_zenith_deg)
        keys = numpy.round(numpy.column_stack([zenith_deg, gamma_deg]), 7)
        places, group, counts = numpy.unique(keys, axis=0, return_inverse=True, return_counts=True)
        group = group.ravel()
        self.zenith, self.gamma = numpy.radians(places).T
        self.values = numpy.bincount(group, values) / counts  # equal but for rounding
        self.secant = horizon_secant(self.zenith)
        self.scale = numpy.sqrt(counts) / (self.values if relative else 1.0)
        self.relative = relative
        self.zenith_value = zenith_value
        self.k = numpy.cos(self.gamma) ** 2 - numpy.cos(self.sun) ** 2

    def cost_of(self, coefficients):
        """Half the weighted sum of squares of published coefficients."""
        sky = perez_sky(coefficients, self.zenith, self.gamma, self.sun, self.zenith_value)
        return 0.5 * float(numpy.sum(((sky - self.values) * self.scale) ** 2))

    @staticmethod
    def shape(x):
        """B and D of the unknowns."""
        low, high = numpy.log(-B_BOUNDS[1]), numpy.log(-B_BOUNDS[0])
        b = -numpy.exp(low + (high - low) / (1 + numpy.exp(-x[1])))
        d = D_BOUNDS[0] + (D_BOUNDS[1] - D_BOUNDS[0]) / (1 + numpy.exp(-x[2]))
        return b, d

    def columns(self, x):
        b, d = self.shape(x)
        u = numpy.exp(b * (self.secant - 1)) - 1
        # The largest exponential is 1, whatever the sign of D: c takes up the rest.
        reference = self.gamma.max() if d > 0 else self.gamma.min()
        w = numpy.exp(d * (self.gamma - reference)) - numpy.exp(d * (self.sun - reference))
        return u, w

    def residuals(self, x):
        u, w = self.columns(x)
        model = (1 + x[0] * u) * (1 + x[3] * w + x[4] * self.k)
        return (self.zenith_value * model - self.values) * self.scale

    def start(self, generator):
        """Random a, B, D; c and e are the linear least squares for them."""
        x = numpy.zeros(5)
        x[0] = generator.choice([-1, 1]) * 10 ** generator.uniform(-2, 1.5)
        x[1] = generator.uniform(-3, 5)
        x[2] = generator.uniform(-1, 6) if generator.random() < 0.7 else generator.uniform(-6, 6)
        u, w = self.columns(x)
        factor = self.zenith_value * (1 + x[0] * u) * self.scale
        matrix = numpy.column_stack([factor * w, factor * self.k])
        x[3:] = numpy.linalg.lstsq(matrix, self.values * self.scale - factor, rcond=None)[0]
        return x

    def search(self, starts, generator):
        """Lowest cost of so many random starts, and how many of them came within 1 % of it."""
        costs = []
        with numpy.errstate(all="ignore"):
            for _ in range(starts):
                try:
                    end = least_squares(self.residuals, self.start(generator), method="lm", max_nfev=600,
                                        ftol=1e-10, xtol=1e-10, gtol=1e-12)
                except (ValueError, numpy.linalg.LinAlgError):
                    continue  # a start that is not finite
                if numpy.isfinite(end.cost):
                    costs.append(end.cost)
            best = min(costs)
            return best, sum(cost <= 1.01 * best for cost in costs)
