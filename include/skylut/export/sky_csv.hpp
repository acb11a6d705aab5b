#pragma once

#include <string>

#include "skylut/sky/sky_map.hpp"

namespace skylut {

/// A sky map as CSV: lines beginning with '#' that say version, altitude, turbidity, sun and units,
/// then columns zenith_deg,azimuth_deg,gamma_deg,Y_cd_m2,x,y and one L_<nm> per wavelength
/// (W m⁻² sr⁻¹ nm⁻¹), one row per direction. Numbers are the shortest that read back exactly.
std::string sky_csv(const SkyMap& map);

}  // namespace skylut
