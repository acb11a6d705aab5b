#pragma once

#include <string>
#include <vector>

#include "skylut/atmosphere/atmosphere.hpp"
#include "skylut/profile/profile.hpp"
#include "skylut/sky/sky_map.hpp"
#include "skylut/transfer/sky_radiance.hpp"

/// The whole way from an atmosphere to skies: start reading here.
namespace skylut {

struct Context;

/// What to simulate: every altitude with every turbidity under every sun.
struct SkyScene {
  Profile profile;
  AtmosphereOptions air;
  std::vector<double> altitudes_km;  ///< of the observers, above the ground, [0, 30]
  std::vector<Turbidity> turbidities;
  std::vector<Direction> suns;        ///< zenith angle [0, 96]
  std::vector<Direction> directions;  ///< where the observers look, zenith angle [0, 180]
  WavelengthGrid wavelengths = WavelengthGrid::visible();
  std::string solar = "astm-g173";  ///< extraterrestrial spectrum: a name or file of SolarSpectrum::load
  double sun_distance_au = 1.0;     ///< the mean distance unless a date is given
};

/// Simulates the scene: one map per altitude, turbidity and sun, in that order, the sun varying fastest.
///
/// A map does not depend on what else is in the scene, nor on the number of threads: always the same bytes.
/// Maps of mirror-symmetric suns hold mirror-symmetric values, equal to the last bit.
///
/// @throws InputError  for values outside the ranges above (never clamped)
/// @throws WorkError   if the transfer does not converge
std::vector<SkyMap> simulate_sky(const Context& context, const SkyScene& scene,
                                 const TransferOptions& options);

}  // namespace skylut
