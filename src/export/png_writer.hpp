#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace skylut {

/// Latin-1 texts of a PNG file: keyword and value.
using PngTexts = std::vector<std::pair<std::string, std::string>>;

/// A PNG file of 8-bit sRGB.
/// @param pixels  [row][column][red, green, blue]
/// @throws WorkError  if the library fails
std::string png_of(int width, int height, std::span<const std::uint8_t> pixels, const PngTexts& texts);

}  // namespace skylut
