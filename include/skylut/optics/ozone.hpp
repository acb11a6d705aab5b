#pragma once

#include "skylut/optics/absorbing_gas.hpp"

namespace skylut {

/// Absorption cross-section of ozone, 5 nm band means, 300-1000 nm: Huggins (to 340 nm), Chappuis
/// (450-850 nm) and the foot of the Wulf bands. Temperatures outside the measured 203-293 K take the
/// nearest measured one. Sources in profiles/spectra/ozone_cross_section.csv.
CrossSection load_ozone_cross_section();

}  // namespace skylut
