#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "skylut/atmosphere/atmosphere.hpp"
#include "skylut/core/directions.hpp"

namespace skylut {

/// What a solver case asks of an air.
struct OpticalCaseRequest {
  double wavelength_nm = 550.0;
  double band_nm = 5.0;
  double aod500 = 0.0;
  double altitude_km = 0.0;
  double sun_zenith_deg = 45.0;
  std::vector<RelativeView> views;
  /// Which of a band's absorption terms, from 1; needed where a band has several.
  std::optional<int> absorption_term;
};

/// The air at one wavelength as a case for `skylut solve`: spherical layers with the keys of every sky case,
/// and for each layer the aerosol's Legendre moments (docs/plane-parallel-and-monte-carlo.md §4). Without
/// radiances.
/// @throws InputError  out of range; several absorption terms and none chosen (the line lists them); no such
/// term
nlohmann::ordered_json optical_case(const Atmosphere& air, const OpticalCaseRequest& request);

}  // namespace skylut
