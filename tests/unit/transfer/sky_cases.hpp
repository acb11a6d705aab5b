#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "skylut/transfer/sky_radiance.hpp"
#include "support/test_context.hpp"

/// Atmospheres for the tests of the spherical solver.
namespace skylut::test {

inline const std::vector<double> kLevels_km = {0, 1, 2, 3, 4, 6, 8, 10, 12, 15, 20, 25, 30, 40, 50, 70, 100};

inline Shells earth() { return {kLevels_km, 6371.0}; }

/// A planet so large that its shells are planes: over a slant path s the curvature lifts a ray by s²/2R,
/// for s = 1000 km (100 km of air at 84°) by 8 m.
inline Shells huge_planet() { return {kLevels_km, 6.4e7}; }

/// Layer depths of an exponential atmosphere of that scale height and total depth.
inline std::vector<double> exponential_depths(double total, double scale_height_km) {
  std::vector<double> depth;
  const double below_top = 1.0 - std::exp(-kLevels_km.back() / scale_height_km);
  for (std::size_t i = 0; i + 1 < kLevels_km.size(); ++i)
    depth.push_back(
        total / below_top *
        (std::exp(-kLevels_km[i] / scale_height_km) - std::exp(-kLevels_km[i + 1] / scale_height_km)));
  return depth;
}

/// Molecules (scale height 8 km) and Henyey-Greenstein haze (2 km).
struct Air {
  double rayleigh_depth = 0.0;
  double haze_depth = 0.0;
  double haze_scattering_albedo = 1.0;
  double haze_asymmetry = 0.7;
  double absorption_depth = 0.0;  ///< spread as the molecules
  double ground_albedo = 0.0;
};

inline OpticalColumn column_of(const Air& air) {
  OpticalColumn column;
  column.ground_albedo = air.ground_albedo;
  const std::vector<double> molecules = exponential_depths(air.rayleigh_depth, 8.0);
  const std::vector<double> absorber = exponential_depths(air.absorption_depth, 8.0);
  const std::vector<double> haze = exponential_depths(air.haze_depth, 2.0);
  std::vector<double> scattered_by_haze;
  for (std::size_t i = 0; i < haze.size(); ++i) {
    column.extinction_depth.push_back(molecules[i] + absorber[i] + haze[i]);
    scattered_by_haze.push_back(haze[i] * air.haze_scattering_albedo);
  }
  if (air.rayleigh_depth > 0.0)
    column.scatterers.push_back({std::make_shared<const RayleighPhaseFunction>(), molecules});
  if (air.haze_depth > 0.0)
    column.scatterers.push_back(
        {std::make_shared<const HenyeyGreensteinPhaseFunction>(air.haze_asymmetry), scattered_by_haze});
  return column;
}

/// Unpolarised light, which costs half: for what is the same for polarised light, whose own tests are
/// plane_limit_test and spherical_reference_test.
inline TransferOptions unpolarised(Quality quality = Quality::standard) {
  TransferOptions options;
  options.discretisation = discretisation_of(quality);
  options.discretisation.polarised_degree = 0;
  return options;
}

inline SkyRadiance solve(const Shells& shells, std::span<const OpticalColumn> columns,
                         const SkyRequest& request) {
  return solve_sky_radiance(test::context, shells, columns, request, unpolarised());
}

inline SkyRadiance solve(const Shells& shells, const OpticalColumn& column, const SkyRequest& request) {
  return solve(shells, std::span(&column, 1), request);
}

}  // namespace skylut::test
