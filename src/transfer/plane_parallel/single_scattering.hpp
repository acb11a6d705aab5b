#pragma once

#include <vector>

#include "scaled_medium.hpp"
#include "skylut/transfer/plane_parallel.hpp"
#include "view_list.hpp"

namespace skylut::plane_parallel {

/// Light scattered exactly once, with the exact phase functions, attenuated as in the scaled medium:
/// the TMS correction of Nakajima & Tanaka 1988, eqs. 57-58. Sets the radiance of the result and, if asked
/// for, its Q and U.
void set_exact_single_scattering(const OpticalColumn& column, const ScaledMedium& medium,
                                 const PlaneParallelRequest& request, const ViewList& views,
                                 PlaneParallelResult& result);

/// Cosine of the angle by which the beam turns into a direction; arguments as in PlaneDirection.
double cos_scattering_angle(double cos_view, double cos_sun, double azimuth);

/// cos 2χ and sin 2χ of the angle χ from the vertical plane of a direction to the plane in which the beam is
/// scattered into it: light with F12 in the latter has Q = F12 cos 2χ, U = F12 sin 2χ.
struct PlaneTurn {
  double cos_twice = 1.0;
  double sin_twice = 0.0;
};
PlaneTurn turn_to_vertical(double cos_view, double cos_sun, double azimuth);

}  // namespace skylut::plane_parallel
