#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "skylut/colour/yxy.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/fit/fit_perez.hpp"
#include "skylut/models/sky_model.hpp"

namespace skylut {

/// A sky as three Perez formulas.
struct SkyFit {
  FitReport Y;  ///< residuals relative
  FitReport x;  ///< residuals absolute
  FitReport y;  ///< residuals absolute
  Yxy zenith;   ///< the zenith sample, to which the formulas are scaled; Y in the unit of the samples
};

/// Options of fit_sky: the fit's own (its residual kind is set per channel) and the weights.
struct SkyFitOptions {
  FitOptions fit;
  SampleWeights weights = SampleWeights::uniform;
};

/// Where a sky was seen, as the formula needs it.
struct SkyDirection {
  double zenith_rad = 0.0;
  double gamma_rad = 0.0;
};

/// Weight of each direction by solid angle: the rings of equal zenith angle share the hemisphere at the
/// middle between neighbouring rings, the directions of a ring share it evenly; scaled to mean 1.
std::vector<double> solid_angle_weights(std::span<const double> zenith_rad);

/// The weights of some directions by name. @param solid_angles_sr  of each; empty: solid_angle_weights
std::vector<double> sample_weights(std::span<const double> zenith_rad,
                                   std::span<const double> solid_angles_sr, SampleWeights weights);

/// Fits Y, x and y of one sky.
/// @param views  directions within 0-90° zenith angle, one of them the zenith (below 1e-6°)
/// @param sky    their colours, Y > 0
/// @param sun    zenith angle within 0-180°
/// @throws InputError  naming the direction and what would be right: sizes differ, fewer than 6 directions,
///                     no zenith, Y not > 0, a value that is not finite
SkyFit fit_sky(std::span<const Direction> views, std::span<const Yxy> sky, const Direction& sun,
               const SkyFitOptions& options = {});

/// The same for directions given by their angles alone.
SkyFit fit_sky(std::span<const SkyDirection> views, std::span<const Yxy> sky, double sun_zenith_rad,
               const SkyFitOptions& options = {});

/// The channels whose fit did not converge, "x, y"; empty if all did.
std::string unconverged_channels(const SkyFit& fit);

/// @throws WorkError  naming the channels whose fit did not converge
void require_converged(const SkyFit& fit);

}  // namespace skylut
