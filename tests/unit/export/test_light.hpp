#pragma once

#include <functional>

#include "skylut/core/constants.hpp"
#include "skylut/sky/sky_light.hpp"

namespace skylut::test {

/// A sky given by a formula for its luminance; the same at every wavelength, and of D65's colour.
class FormulaLight final : public SkyLight {
 public:
  explicit FormulaLight(std::function<double(const Direction&)> luminance, Direction sun = {45.0, 120.0},
                        double horizon_zenith_deg = 90.0)
      : luminance_(std::move(luminance)), sun_(sun), horizon_zenith_deg_(horizon_zenith_deg) {}

  const WavelengthGrid& wavelengths() const override { return wavelengths_; }
  Direction sun() const override { return sun_; }
  double horizon_zenith_deg() const override { return horizon_zenith_deg_; }

  void radiance(std::span<const Direction> directions, std::span<float> radiance) const override {
    const std::size_t count = wavelengths_.size();
    for (std::size_t i = 0; i < directions.size(); ++i)
      for (std::size_t w = 0; w < count; ++w)
        radiance[i * count + w] = static_cast<float>(luminance_(directions[i]) * (1.0 + 0.1 * double(w)));
  }
  void colour(std::span<const Direction> directions, std::span<Xyz> colour) const override {
    for (std::size_t i = 0; i < directions.size(); ++i)
      colour[i] = to_xyz(Yxy{luminance_(directions[i]), kD65_x, kD65_y});
  }

 private:
  std::function<double(const Direction&)> luminance_;
  Direction sun_;
  double horizon_zenith_deg_;
  WavelengthGrid wavelengths_{400.0, 600.0, 100.0};
};

inline double cosine(double degrees) { return std::cos(degrees * kRadiansPerDegree); }

/// Light of that much above the horizon, of nothing below it.
inline FormulaLight jump_light(double above, double horizon_zenith_deg = 90.0) {
  return FormulaLight([=](const Direction& d) { return d.zenith_deg < horizon_zenith_deg ? above : 0.0; },
                      {45.0, 120.0}, horizon_zenith_deg);
}

}  // namespace skylut::test
