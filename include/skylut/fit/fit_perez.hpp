#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skylut/models/perez.hpp"

namespace skylut {

/// One direction of a sky, for one channel (Y, x or y).
struct SkySample {
  double zenith_rad = 0.0;  ///< view zenith angle, [0, π/2]
  double gamma_rad = 0.0;   ///< angle to the sun, [0, π]
  double value = 0.0;       ///< in the unit of the zenith value
  double weight = 1.0;      ///< >= 0; relative to the others
};

enum class ResidualKind {
  relative,  ///< (model - value) / value: for luminance; every value must be > 0
  absolute,  ///< model - value: for chromaticity
};

enum class SampleWeights {
  uniform,      ///< every direction counts the same, as in the sources
  solid_angle,  ///< every direction counts with the solid angle of its ring, divided among the ring
  horizon,      ///< the same, times horizon_emphasis()
};

enum class Termination {
  not_run,
  converged,       ///< at a minimum, within the bounds
  no_convergence,  ///< stopped at the limit of iterations, or where no step lowers the cost
};

std::string_view to_string(Termination termination);

/// What the fit may do. The default bounds keep the formula finite everywhere and representable in 32-bit
/// floats. In any case 1 + A e^B > 0: the gradation has one sign.
struct FitOptions {
  ResidualKind residual = ResidualKind::relative;
  double B_lower = -80.0;  ///< the gradation is then gone 15° from the zenith; e^{-B} still fits a float
  double B_upper = -1e-5;  ///< B < 0: finite at the horizon
  double D_lower = -80.0;  ///< 1/rad: an aureole 0.7° wide, narrower than a map of directions resolves
  double D_upper = 25.0;   ///< 1/rad: brightens away from the sun, by e^79 to the antisolar point
  double largest_gradation = std::numeric_limits<double>::infinity();   ///< of 1 + A e^B, > 1
  double largest_scattering = std::numeric_limits<double>::infinity();  ///< of 1 + C e^{Dθ_s} + E cos²θ_s,
                                                                        ///< then > 0; > 1; infinite: any sign
  int starts = 24;           ///< Levenberg-Marquardt runs per fit, from the best places of the search
  int max_iterations = 200;  ///< per run; as many again by Newton's method where they do not suffice
};

/// What the fit found, for one channel.
struct FitReport {
  PerezCoefficients coefficients;
  double zenith_value = 0.0;  ///< v_z of v(θ,γ) = v_z F(θ,γ)/F(0,θ_s): the value of the zenith sample
  double rmse = -1.0;         ///< weighted root mean square residual (relative or absolute); -1: not computed
  double worst_residual = 0.0;      ///< signed, the largest in size among the samples of weight > 0
  std::size_t worst_direction = 0;  ///< its index in the samples as given
  Termination termination = Termination::not_run;
  std::string message = "fit was not run";
  double cost = -1.0;  ///< ½ Σ weight · residual², weights scaled to mean 1
  std::array<double, 5>
      standard_error{};              ///< of A…E, from the covariance at the minimum; infinity if unbounded
  std::array<bool, 5> determined{};  ///< whether the data fix A…E; see fit_perez
  std::array<bool, 5> at_bound{};    ///< whether B or D ended on a bound of FitOptions
  int iterations = 0;                ///< of the run that won
};

/// Fits v(θ, γ) = v_z F(θ, γ)/F(0, θ_s), v_z being fixed, by Levenberg-Marquardt from the
/// best places of a search over B and D in which A, C and E are eliminated, and from Preetham's coefficients;
/// by Newton's method with automatic derivatives (Ceres) from where that creeps. [fit.md F2-F6]
///
/// The order of the samples does not matter: mirror-symmetric skies give the same bits.
///
/// A coefficient counts as determined if it is not on a bound, and if errors of the size of the residuals, or
/// of 1e-4 of the data if that is more, move it by less than its own size (or less than 0.1, if that is
/// more). Equal samples in equal directions relative to the sun count as one datum. If γ is a function of θ,
/// as with the sun at the zenith, no coefficient is determined: the data do not tell the two factors of the
/// formula apart.
///
/// @param samples         at least 6 different directions
/// @param sun_zenith_rad  [0, π]
/// @param zenith_value    v_z; not 0
/// @throws InputError  too few samples, a value that is not finite (or not > 0 if residuals are
///                     relative), angles or weights or options out of range
/// @throws WorkError   numbers that overflow: no start has a finite cost, or the result has no finite
/// coefficients
FitReport fit_perez(std::span<const SkySample> samples, double sun_zenith_rad, double zenith_value,
                    const FitOptions& options);

/// A place where the cost has a minimum within the bounds.
struct PerezMinimum {
  PerezCoefficients coefficients;
  double cost = 0.0;
  Termination termination = Termination::not_run;
  std::string message;
  int iterations = 0;
};

/// The different minima that fit_perez finds whose cost is up to a share `within` above the least, which
/// comes first. Arguments and errors as fit_perez.
std::vector<PerezMinimum> perez_minima(std::span<const SkySample> samples, double sun_zenith_rad,
                                       double zenith_value, const FitOptions& options, double within);

/// What fit_perez reports, of any of the minima.
FitReport perez_report(std::span<const SkySample> samples, double sun_zenith_rad, double zenith_value,
                       const FitOptions& options, const PerezMinimum& minimum);

/// The cost that fit_perez minimises, for any coefficients: ½ Σ weight · residual², weights scaled to mean 1.
double perez_cost(std::span<const SkySample> samples, double sun_zenith_rad, double zenith_value,
                  ResidualKind residual, const PerezCoefficients& coefficients);

}  // namespace skylut
