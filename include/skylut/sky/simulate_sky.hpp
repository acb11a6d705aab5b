#pragma once

#include <vector>

#include "skylut/sky/sky_map.hpp"
#include "skylut/sky/sky_scene.hpp"
#include "skylut/transfer/sky_radiance.hpp"

/// The whole way from an atmosphere to skies: start reading here.
namespace skylut {

struct Context;

/// Simulates the scene: one map per altitude, turbidity and sun, in that order, the sun varying fastest.
///
/// A map does not depend on what else is in the scene, nor on the number of threads: always the same bytes.
/// Maps of mirror-symmetric suns hold mirror-symmetric values, equal to the last bit.
///
/// @throws InputError  for values outside the ranges above (never clamped)
/// @throws WorkError   if the transfer does not converge
std::vector<SkyMap> simulate_sky(const Context& context, const SkyScene& scene,
                                 const TransferOptions& options);

}  // namespace skylut
