#include "skylut/sky/sky_irradiance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut {
namespace {

// Of radiance 1 W m⁻² sr⁻¹ nm⁻¹ and 2 cd/m² towards the zenith, times a power of cos θ.
class CosineSky final : public SkyLight {
 public:
  CosineSky(int power, const Direction& sun) : power_(power), sun_(sun) {}
  const WavelengthGrid& wavelengths() const override { return wavelengths_; }
  Direction sun() const override { return sun_; }
  double horizon_zenith_deg() const override { return 90.0; }
  void radiance(std::span<const Direction> directions, std::span<float> radiance) const override {
    for (std::size_t i = 0; i < directions.size(); ++i)
      for (std::size_t w = 0; w < 2; ++w) radiance[2 * i + w] = static_cast<float>(value(directions[i]));
  }
  void colour(std::span<const Direction> directions, std::span<Xyz> colour) const override {
    std::transform(directions.begin(), directions.end(), colour.begin(), [this](const Direction& direction) {
      return Xyz{0.0, 2.0 * value(direction), 4.0 * value(direction)};
    });
  }

 private:
  double value(const Direction& direction) const {
    return std::pow(std::max(0.0, std::cos(direction.zenith_deg * kRadiansPerDegree)), power_);
  }
  int power_;
  Direction sun_;
  WavelengthGrid wavelengths_{500.0, 600.0, 100.0};
};

// ∫ cos^(n+1) θ dΩ = 2π/(n + 2).
TEST(SkyIrradiance, OfPowersOfTheCosine) {
  for (const int power : {0, 1, 3})
    for (const double sun_deg : {0.0, 30.0, 90.0, 95.0}) {
      const CosineSky sky(power, {sun_deg, 250.0});
      const double expected = 2.0 * kPi / (power + 2.0);
      for (const double value : diffuse_horizontal(sky)) EXPECT_NEAR(value / expected, 1.0, 1e-5);
      const Xyz lux = diffuse_horizontal_illuminance(sky);
      EXPECT_NEAR(lux.X, 0.0, 1e-12);
      EXPECT_NEAR(lux.Y / (2.0 * expected), 1.0, 1e-5);
      EXPECT_NEAR(lux.Z / (4.0 * expected), 1.0, 1e-5);
    }
}

}  // namespace
}  // namespace skylut
