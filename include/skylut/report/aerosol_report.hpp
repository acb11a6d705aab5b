#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "skylut/scattering/aerosol_optics.hpp"

namespace skylut {

/// An aerosol in readable columns: what it is, what it is made of, its optics by wavelength, Ångström
/// exponents, and where it is.
std::string aerosol_text(const AerosolDescription& description, const AerosolOptics& optics);

/// The same in full precision, with the Legendre moments of every phase function.
nlohmann::ordered_json aerosol_json(const AerosolDescription& description, const AerosolOptics& optics);

}  // namespace skylut
