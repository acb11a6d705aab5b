#include "skylut/colour/yxy.hpp"

#include <array>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

using Row = std::array<double, 3>;
using Matrix = std::array<Row, 3>;

constexpr Matrix inverse(const Matrix& m) {
  const auto minor = [&m](int r, int c) {
    const auto at = [&m](int i, int j) {
      return m[static_cast<std::size_t>(i % 3)][static_cast<std::size_t>(j % 3)];
    };
    return at(r + 1, c + 1) * at(r + 2, c + 2) - at(r + 1, c + 2) * at(r + 2, c + 1);
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix result{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      result[static_cast<std::size_t>(c)][static_cast<std::size_t>(r)] = minor(r, c) / determinant;
  return result;
}

constexpr Row multiply(const Matrix& m, const Row& v) {
  Row result{};
  for (std::size_t r = 0; r < 3; ++r) result[r] = m[r][0] * v[0] + m[r][1] * v[1] + m[r][2] * v[2];
  return result;
}

// Columns: XYZ of the primaries, scaled so that r = g = b = 1 is the white with Y = 1.
constexpr Matrix rgb_to_xyz_matrix() {
  // Primaries of ITU-R BT.709, IEC 61966-2-1:1999 table 1.
  constexpr std::array<std::array<double, 2>, 3> kPrimaries{{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}};
  Matrix primaries{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [x, y] = kPrimaries[i];
    primaries[0][i] = x / y;
    primaries[1][i] = 1.0;
    primaries[2][i] = (1.0 - x - y) / y;
  }
  const Row white{kD65_x / kD65_y, 1.0, (1.0 - kD65_x - kD65_y) / kD65_y};
  const Row scale = multiply(inverse(primaries), white);
  for (Row& row : primaries)
    for (std::size_t i = 0; i < 3; ++i) row[i] *= scale[i];
  return primaries;
}

constexpr Matrix kRgbToXyz = rgb_to_xyz_matrix();
constexpr Matrix kXyzToRgb = inverse(kRgbToXyz);

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
