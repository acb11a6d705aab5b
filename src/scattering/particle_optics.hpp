#pragma once

#include <vector>

#include "skylut/scattering/size_distribution.hpp"
#include "skylut/scattering/tabulated_phase_function.hpp"

namespace skylut {

struct Context;

/// What a mixture of spheres does to light of one wavelength.
struct ParticleOptics {
  double extinction_um2 = 0.0;  ///< cross-section of all particles in the volume that holds their numbers
  double scattering_um2 = 0.0;
  std::vector<double> moments;  ///< χ_0 = 1 … of their phase function, Σ (2l+1)|χ_l| beyond the last < 1e-7
  PolarisationMoments polarisation{};  ///< of the same degrees
};

/// Integrates Mie's theory over the sizes of every component, one result per wavelength. [docs/aerosols.md
/// P5-P6] Extinction, albedo and asymmetry are converged to 1e-4, 5e-4 without absorption
/// (tests/unit/scattering/particle_optics_test.cpp).
/// @param components     at least one; externally mixed
/// @param wavelength_nm  each > 0
/// @param fineness       number of radii, relative to the default
std::vector<ParticleOptics> particle_optics(const Context& context,
                                            const std::vector<AerosolComponent>& components,
                                            const std::vector<double>& wavelength_nm, double fineness = 1.0);

}  // namespace skylut
