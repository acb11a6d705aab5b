#pragma once

#include <Eigen/Core>

#include "adding.hpp"

namespace skylut::plane_parallel {

/// Fourier component m of the radiance at every boundary in the directions of view, from the formal
/// solution I = I(boundary) e^{-Δτ/μ} + ∫ J e^{-t/μ} dt/μ with the J of the discrete ordinates: exact
/// between the ordinates too (Stamnes 1982). Light scattered exactly once is left out (see
/// single_scattering.hpp); light that comes from the ground or the top is in.
/// @param cos_views  polarised: three times, for I, Q and U
/// @return  boundaries × views; polarised, U of the views down has its sign changed (layer_modes.hpp)
Eigen::MatrixXd radiance_at_views(const ScaledMedium& medium, const std::vector<LayerModes>& modes,
                                  const Ordinates& ordinates, const Illumination& light,
                                  const BoundaryFields& fields, const Eigen::VectorXd& cos_views);

/// ∫₀ᵀ e^{-at} e^{-(T-t)/μ} dt/μ, also where a = 1/μ; T, a >= 0, μ in (0, 1].
double attenuated_towards_end(double a, double mu, double depth);

/// ∫₀ᵀ e^{-at} e^{-t/μ} dt/μ.
double attenuated_towards_start(double a, double mu, double depth);

}  // namespace skylut::plane_parallel
