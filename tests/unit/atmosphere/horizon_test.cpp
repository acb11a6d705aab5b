// The layers must be thin enough for an observer who looks along the horizon: there the light comes from the
// layer that the observer is in.

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/atmosphere/atmosphere.hpp"
#include "skylut/core/quadrature.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

/// Vertical optical depth above an altitude, all constituents.
double depth_above(const Atmosphere& air, double wavelength_nm, double aod500, double altitude_km) {
  double sum = 0.0;
  for (const ConstituentDepth& one :
       air.optical_depths({.wavelength_nm = wavelength_nm}, aod500, altitude_km))
    sum += one.depth;
  return sum;
}

/// Horizontal optical depth from an altitude to the top through the continuous profile. With u = √(h - h₀),
/// ds = (R + h) dh / √((h-h₀)(2R+h+h₀)) has no singularity: ds = 2 (R+h) du / √(2R+h+h₀).
double continuous_horizontal_depth(const Atmosphere& air, double wavelength_nm, double aod500,
                                   double altitude_km) {
  const double radius_km = air.shells().planet_radius_km;
  double sum = 0.0;
  constexpr int kPieces = 40;
  const double end = std::sqrt(99.0 - altitude_km);
  for (int piece = 0; piece < kPieces; ++piece) {
    const Quadrature rule = gauss_legendre(4, end * piece / kPieces, end * (piece + 1) / kPieces);
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const double h = altitude_km + rule.node[i] * rule.node[i];
      constexpr double kHalfStep_km = 0.005;  // β = -dτ/dh by central differences
      const double low = std::max(altitude_km, h - kHalfStep_km);
      const double high = h + kHalfStep_km;
      const double beta_per_km =
          (depth_above(air, wavelength_nm, aod500, low) - depth_above(air, wavelength_nm, aod500, high)) /
          (high - low);
      sum +=
          rule.weight[i] * beta_per_km * 2.0 * (radius_km + h) / std::sqrt(2.0 * radius_km + h + altitude_km);
    }
  }
  return sum;
}

double layered_horizontal_depth(const Atmosphere& air, double wavelength_nm, double aod500,
                                double altitude_km) {
  const OpticalColumn column = air.column(wavelength_nm, aod500);
  const std::vector<double>& level = air.shells().levels_km;
  const double radius_km = air.shells().planet_radius_km;
  const auto distance = [&](double h) {
    return h <= altitude_km ? 0.0 : std::sqrt((h - altitude_km) * (2.0 * radius_km + h + altitude_km));
  };
  double sum = 0.0;
  for (std::size_t layer = 0; layer + 1 < level.size(); ++layer)
    sum += column.extinction_depth[layer] / (level[layer + 1] - level[layer]) *
           (distance(level[layer + 1]) - distance(level[layer]));
  return sum;
}

// A layer of thickness d holds its mean density where the observer stands at its lower boundary: of the
// horizontal depth that is an error of about (d/H)^1.5/10: 0.7 % for the haze (d = 0.25 km, H = 2 km).
TEST(Horizon, LayersAreThinEnoughForHorizontalViews) {
  const Atmosphere air(test::context, load_profile(test::context, "ussa1976"), {});
  for (const double altitude_km : {0.0, 3.0, 6.0, 12.0, 20.0, 30.0})
    for (const double aod500 : {0.0, 0.5}) {
      const double continuous = continuous_horizontal_depth(air, 550.0, aod500, altitude_km);
      const double layered = layered_horizontal_depth(air, 550.0, aod500, altitude_km);
      EXPECT_NEAR(layered / continuous, 1.0, 0.01) << altitude_km << " km, load " << aod500;
    }
}

}  // namespace
}  // namespace skylut
