#pragma once

#include <span>

#include "skylut/transfer/sky_radiance.hpp"

namespace skylut::transfer {

/// @throws InputError naming the first level or radius that is out of range
void check_shells(const Shells& shells);

/// @throws InputError  also for an observer outside the layers, or a zenith angle outside 0-180
void check_place(const Shells& shells, double altitude_km, double sun_zenith_deg);

/// @param layers  of the shells
/// @throws InputError naming the first value of the column that is out of range or no number
void check_column(const OpticalColumn& column, std::size_t layers);

/// @param top_km  highest level
/// @throws InputError naming the first value of the sight that is out of range
void check_sight(const Sight& sight, double top_km);

/// @throws InputError naming the first value of the shells, columns, request or options that is out of range
void check_request(const Shells& shells, std::span<const OpticalColumn> columns,
                   std::span<const Sight> sights, const TransferOptions& options);

}  // namespace skylut::transfer
