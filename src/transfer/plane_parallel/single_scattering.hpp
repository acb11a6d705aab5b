#pragma once

#include <vector>

#include "scaled_medium.hpp"
#include "skylut/transfer/plane_parallel.hpp"
#include "view_list.hpp"

namespace skylut::plane_parallel {

/// Light scattered exactly once, with the exact phase functions, attenuated as in the scaled medium:
/// the TMS correction of Nakajima & Tanaka 1988, eqs. 57-58. Same layout as PlaneParallelResult::radiance.
std::vector<double> exact_single_scattering(const OpticalColumn& column, const ScaledMedium& medium,
                                            const PlaneParallelRequest& request, const ViewList& views);

/// Cosine of the angle by which the beam turns into a direction; arguments as in PlaneDirection.
double cos_scattering_angle(double cos_view, double cos_sun, double azimuth);

}  // namespace skylut::plane_parallel
