#pragma once

#include <span>

#include "skylut/transfer/sky_radiance.hpp"

namespace skylut::transfer {

/// @throws InputError naming the first level or radius that is out of range
void check_shells(const Shells& shells);

/// @throws InputError naming the first value of the shells, columns or request that is out of range
void check_request(const Shells& shells, std::span<const OpticalColumn> columns, const SkyRequest& request);

}  // namespace skylut::transfer
