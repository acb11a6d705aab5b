#pragma once

#include <string>

#include "skylut/export/sky_picture.hpp"

namespace skylut {

/// Pictures that were written, for reading on a screen: pixels, luminances, colours outside the RGB space,
/// and one line "wrote FILE" each.
std::string picture_report(const PictureSummary& summary, const std::string& rgb_space);

}  // namespace skylut
