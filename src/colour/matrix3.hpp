#pragma once

#include <array>
#include <cstddef>

/// Products and inverses of 3 × 3 matrices, at compile time too.
namespace skylut {

using Row3 = std::array<double, 3>;
using Matrix3 = std::array<Row3, 3>;

constexpr Matrix3 inverse(const Matrix3& m) {
  const auto minor = [&m](int r, int c) {
    const auto at = [&m](int i, int j) {
      return m[static_cast<std::size_t>(i % 3)][static_cast<std::size_t>(j % 3)];
    };
    return at(r + 1, c + 1) * at(r + 2, c + 2) - at(r + 1, c + 2) * at(r + 2, c + 1);
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix3 result{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      result[static_cast<std::size_t>(c)][static_cast<std::size_t>(r)] = minor(r, c) / determinant;
  return result;
}

constexpr Row3 multiply(const Matrix3& m, const Row3& v) {
  Row3 result{};
  for (std::size_t r = 0; r < 3; ++r) result[r] = m[r][0] * v[0] + m[r][1] * v[1] + m[r][2] * v[2];
  return result;
}

constexpr Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 result{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      result[r][c] = a[r][0] * b[0][c] + a[r][1] * b[1][c] + a[r][2] * b[2][c];
  return result;
}

/// XYZ, with Y = 1, of light of that chromaticity.
constexpr Row3 xyz_of_chromaticity(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

/// Columns: XYZ of the primaries, scaled so that r = g = b = 1 is the white with Y = 1 (SMPTE RP 177:1993).
/// @param primaries  XYZ of red, green and blue with Y = 1
constexpr Matrix3 rgb_to_xyz(const Matrix3& primaries, const Row3& white) {
  Matrix3 columns{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) columns[r][c] = primaries[c][r];
  const Row3 scale = multiply(inverse(columns), white);
  for (Row3& row : columns)
    for (std::size_t c = 0; c < 3; ++c) row[c] *= scale[c];
  return columns;
}

}  // namespace skylut
