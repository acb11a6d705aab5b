#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skylut/atmosphere/atmosphere.hpp"
#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/core/provenance.hpp"
#include "skylut/core/wavelength_grid.hpp"
#include "skylut/site/place.hpp"
#include "skylut/transfer/sky_radiance.hpp"

namespace skylut {

/// What to simulate: every altitude with every turbidity under every sun, through one atmosphere.
struct SkyScene {
  std::shared_ptr<const Atmosphere> atmosphere;  ///< never null
  std::vector<double> altitudes_km;              ///< of the observers, above the ground, [0, 30]
  std::vector<Turbidity> turbidities;
  std::vector<Direction> suns;        ///< zenith angle [0, 99]
  std::vector<Direction> directions;  ///< where the observers look, zenith angle [0, 180]
  std::string directions_name;        ///< of that set, for the provenance; empty: none
  WavelengthGrid wavelengths = WavelengthGrid::visible();
  std::string solar = "astm-g173";  ///< extraterrestrial spectrum: a name or file of SolarSpectrum::load
  double sun_distance_au = 1.0;     ///< the mean distance unless a date is given

  std::optional<Place> place;  ///< that gravity and radius, and with a time the sun, were taken from
  std::string time;            ///< that the sun was taken from; empty: none
};

/// Mean solar irradiance of every band on a plane normal to the beam above the air, W m⁻² nm⁻¹.
/// @throws InputError  for an unknown spectrum, or wavelengths beyond it
std::vector<double> extraterrestrial_irradiance(const Context& context, const SkyScene& scene);

/// How whatever is made from a scene comes about: its atmosphere with every number as used, observers, loads
/// in all turbidity kinds, suns, wavelengths, and the files read. The caller adds what else it depends on.
/// @param command  that makes it again
Provenance scene_provenance(const Context& context, const SkyScene& scene, std::string command);

/// Says how the transfer was solved: kernel, blocks, iterations and the error left. Not the time it took,
/// since the same inputs give the same bytes.
void describe_into(const TransferReport& report, Provenance& provenance);

}  // namespace skylut
