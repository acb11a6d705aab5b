#pragma once

#include <ImfHeader.h>

#include <string>
#include <vector>

#include "skylut/export/sky_picture.hpp"

/// What one OpenEXR file of a picture says and holds.
namespace skylut {

/// Channel names, in the order in which the pixels hold them.
std::vector<std::string> channel_names(SkyChannels channels, const WavelengthGrid& wavelengths);

/// Size and attributes; docs/user-guide.md lists them.
/// @param sun_disc  words for what is there of it
Imf::Header exr_header(SkyChannels channels, const Projection& projection, const SkyLight& sky,
                       const PictureOptions& options, const PictureLabels& labels,
                       const std::string& sun_disc);

}  // namespace skylut
