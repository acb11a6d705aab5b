#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "skylut/scattering/aerosol_optics.hpp"

namespace skylut {

/// An aerosol in readable columns: what it is, what it is made of, its optics by wavelength, Ångström
/// exponents, and where it is.
/// @param optics  with its description, as load_aerosol gives it
std::string aerosol_text(const AerosolOptics& optics);

/// The same in full precision, with the Legendre moments of every phase function.
nlohmann::ordered_json aerosol_report_json(const AerosolOptics& optics);

}  // namespace skylut
