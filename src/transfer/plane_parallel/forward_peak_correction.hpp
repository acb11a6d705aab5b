#pragma once

#include <vector>

#include "scaled_medium.hpp"
#include "skylut/transfer/plane_parallel.hpp"

namespace skylut::plane_parallel {

/// Takes from the downward radiances the error that delta-M with exact single scattering (TMS) makes where
/// light is scattered more than once within the truncated forward peak: the IMS correction of Nakajima &
/// Tanaka 1988, eqs. 62-66, in the form of Stamnes et al. 2000 (DISORT report), eqs. 74-77.
///
/// With f ω and the peak's moments g_l (1 below the number of streams n, Σ ω χ_l / Σ ω f from there) averaged
/// over the air above the output depth τ, and μ0' = μ0/(1 - fω):
///   ΔI = (fω)²/(1-fω) / 4π · Σ (2l+1)(2 g_l - g_l²) P_l(cosΘ) · ∫₀^τ (t/μ0') e^{-t/μ0'} e^{-(τ-t)/μ} dt/μ
/// @param radiance  same layout as PlaneParallelResult::radiance
void correct_forward_peak(const OpticalColumn& column, const ScaledMedium& medium,
                          const PlaneParallelRequest& request, std::vector<double>& radiance);

/// ∫₀^τ t e^{-at} e^{-b(τ-t)} dt, also for a = b.
double twice_scattered_path(double a, double b, double depth);

}  // namespace skylut::plane_parallel
