#include "skylut/colour/rgb_space.hpp"

#include <algorithm>

#include "colour/matrix3.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"

namespace skylut {

namespace {

constexpr Chromaticity kD65{kD65_x, kD65_y};
// SMPTE ST 2065-1:2021 table 1; Academy TB-2018-001 says how it was derived.
constexpr Chromaticity kAcesWhite{0.32168, 0.33767};

// Bradford's cone responses (CIE 159:2004 §6; ICC.1:2022 annex E.2).
constexpr Matrix3 kBradford{
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

Row3 xyz_of(const Chromaticity& c) { return xyz_of_chromaticity(c.x, c.y); }

// Scales the cone responses so that one white becomes the other (ICC.1:2022 eq. E.5).
Matrix3 adaptation_between(const Chromaticity& from, const Chromaticity& to) {
  const Row3 source = multiply(kBradford, xyz_of(from));
  const Row3 target = multiply(kBradford, xyz_of(to));
  Matrix3 scale{};
  for (std::size_t i = 0; i < 3; ++i) scale[i][i] = target[i] / source[i];
  return product(inverse(kBradford), product(scale, kBradford));
}

}  // namespace

const std::vector<RgbSpace>& rgb_spaces() {
  static const std::vector<RgbSpace> spaces{
      {"rec709", "lin_rec709_scene", {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, kD65},
      {"rec2020", "lin_rec2020_scene", {0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, kD65},
      {"p3", "lin_p3d65_scene", {0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, kD65},
      {"acescg", "lin_ap1_scene", {0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, kAcesWhite},
      {"aces2065-1", "lin_ap0_scene", {0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, kAcesWhite},
  };
  return spaces;
}

const RgbSpace& rgb_space(const std::string& name) {
  std::vector<std::string> names;
  for (const RgbSpace& space : rgb_spaces()) {
    if (space.name == name) return space;
    names.push_back(space.name);
  }
  throw InputError("RGB space '{}': must be {}{}", name, listed(names), suggested(name, names));
}

RgbConversion::RgbConversion(const RgbSpace& space, WhiteAdaptation adaptation)
    : to_xyz_(rgb_to_xyz({xyz_of(space.red), xyz_of(space.green), xyz_of(space.blue)}, xyz_of(space.white))) {
  if (adaptation == WhiteAdaptation::bradford && space.white != kD65)
    to_xyz_ = product(adaptation_between(space.white, kD65), to_xyz_);
  to_rgb_ = inverse(to_xyz_);
}

LinearRgb RgbConversion::to_rgb(const Xyz& colour) const {
  const auto [r, g, b] = multiply(to_rgb_, {colour.X, colour.Y, colour.Z});
  return {r, g, b};
}

Xyz RgbConversion::to_xyz(const LinearRgb& colour) const {
  const auto [X, Y, Z] = multiply(to_xyz_, {colour.r, colour.g, colour.b});
  return {X, Y, Z};
}

LinearRgb RgbConversion::luminance_weights() const { return {to_xyz_[1][0], to_xyz_[1][1], to_xyz_[1][2]}; }

}  // namespace skylut
