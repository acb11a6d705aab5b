#include "skylut/colour/yxy.hpp"

#include "colour/matrix3.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

// Primaries of ITU-R BT.709, IEC 61966-2-1:1999 table 1.
constexpr Matrix3 kRgbToXyz = rgb_to_xyz(
    {xyz_of_chromaticity(0.64, 0.33), xyz_of_chromaticity(0.30, 0.60), xyz_of_chromaticity(0.15, 0.06)},
    xyz_of_chromaticity(kD65_x, kD65_y));
constexpr Matrix3 kXyzToRgb = inverse(kRgbToXyz);

}  // namespace

Yxy to_yxy(const Xyz& colour) {
  const double sum = colour.X + colour.Y + colour.Z;
  if (sum == 0.0) return {colour.Y, kD65_x, kD65_y};
  return {colour.Y, colour.X / sum, colour.Y / sum};
}

Xyz to_xyz(const Yxy& colour) {
  if (colour.Y == 0.0) return {};
  if (colour.y == 0.0)
    throw InputError("chromaticity y = 0 with luminance {}: y must be greater than 0 where there is light",
                     colour.Y);
  const double sum = colour.Y / colour.y;
  return {colour.x * sum, colour.Y, (1.0 - colour.x - colour.y) * sum};
}

LinearRgb to_linear_srgb(const Xyz& colour) {
  const auto [r, g, b] = multiply(kXyzToRgb, {colour.X, colour.Y, colour.Z});
  return {r, g, b};
}

Xyz to_xyz(const LinearRgb& colour) {
  const auto [X, Y, Z] = multiply(kRgbToXyz, {colour.r, colour.g, colour.b});
  return {X, Y, Z};
}

}  // namespace skylut
