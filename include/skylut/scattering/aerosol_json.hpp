#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "skylut/scattering/aerosol_optics.hpp"

namespace skylut {

/// An aerosol in full precision: what it is, its particles (if it was made of any), its optics at the
/// wavelengths where Mie's theory was evaluated, where it is, and the same of its stratospheric part. Phase
/// functions follow from the particles and are left out.
nlohmann::ordered_json aerosol_json(const AerosolOptics& optics);

/// The files that an aerosol and its stratospheric part were read from.
std::vector<std::string> files_of(const AerosolOptics& optics);

}  // namespace skylut
