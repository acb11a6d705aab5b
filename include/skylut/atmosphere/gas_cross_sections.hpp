#pragma once

#include "skylut/atmosphere/absorbing_gas.hpp"

/// Gases that absorb smoothly (or by bands broad enough to resolve), 300-1000 nm. Temperatures outside
/// the measured ones take the nearest measured. Sources in the files of profiles/spectra. [docs/air.md §5]
namespace skylut {

struct Context;

/// Absorption cross-section of ozone, 5 nm band means: Huggins (to 340 nm), Chappuis (450-850 nm) and the
/// foot of the Wulf bands; 203-293 K.
CrossSection load_ozone_cross_section(const Context& context);

/// Absorption cross-section of nitrogen dioxide, 5 nm band means; 223-293 K; 0 beyond 800 nm.
CrossSection load_nitrogen_dioxide_cross_section(const Context& context);

/// Absorption by pairs of oxygen molecules, 5 nm band means, in m⁵: the optical depth is its product with
/// ∫ n(O2)² ds, n in m⁻³. Without temperature dependence (296 K).
CrossSection load_oxygen_pair_cross_section(const Context& context);

}  // namespace skylut
