#pragma once

#include <string>

#include "skylut/core/provenance.hpp"
#include "skylut/sky/sky_map.hpp"

namespace skylut {

/// A sky map as CSV. First the line that names the columns, so that pandas, NumPy and R read the file with
/// one line each: zenith_deg,azimuth_deg,gamma_deg,Y_cd_m2,x,y and one L_<nm> per wavelength (W m⁻² sr⁻¹
/// nm⁻¹; none if the map has no radiances). Then lines that begin with '#': version, altitude, turbidity,
/// sun, units, and how the map was made. Then one row per direction. Numbers are the shortest that read back
/// exactly.
std::string sky_csv(const SkyMap& map, const Provenance& provenance);

}  // namespace skylut
