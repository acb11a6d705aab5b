#pragma once

#include <vector>

#include "scaled_medium.hpp"
#include "skylut/transfer/plane_parallel.hpp"

namespace skylut::plane_parallel {

/// Light scattered exactly once, with the exact phase functions, attenuated as in the scaled medium:
/// the TMS correction of Nakajima & Tanaka 1988, eqs. 57-58. Same layout as PlaneParallelResult::radiance.
std::vector<double> exact_single_scattering(const OpticalColumn& column, const ScaledMedium& medium,
                                            const PlaneParallelRequest& request);

}  // namespace skylut::plane_parallel
