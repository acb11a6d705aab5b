#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "skylut/core/provenance.hpp"
#include "skylut/export/projection.hpp"
#include "skylut/export/sky_channels.hpp"
#include "skylut/sky/sky_map.hpp"

namespace skylut {

/// Writes one OpenEXR file: 32-bit floats, ZIP compression, attributes that say altitude, turbidity,
/// sun, units, orientation, version and how the map was made (docs/user-guide.md lists them). Negative R, G
/// or B of colours outside Rec. 709 are kept.
/// @param map  its directions are those of the projection, row by row
/// @throws InputError  if the numbers of directions and pixels differ
/// @throws WorkError   if the file cannot be written
void write_sky_exr(const std::filesystem::path& path, const SkyMap& map, const Projection& projection,
                   SkyChannels channels, const Provenance& provenance);

/// Number of directions whose colour lies outside Rec. 709: at least one of R, G, B is negative.
std::size_t count_outside_rec709(const SkyMap& map);

}  // namespace skylut
