#include "skylut/scattering/aerosol_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {
namespace {

std::vector<AerosolShape> shapes() {
  AerosolShape mixed;
  mixed.mixed_layer_km = 2.0;
  mixed.haze_scale_height_km = 1.0;
  AerosolShape table;
  table.altitude_km = {0.0, 2.0, 2.5, 3.0, 10.0};
  table.relative_extinction = {1.0, 0.8, 0.1, 0.0, 0.02};
  return {AerosolShape{}, mixed, table};
}

// Kinks of the shapes lie between the pieces.
double integral(const std::function<double(double)>& f, double lower, double upper) {
  double sum = 0.0;
  for (const double edge : {0.0, 2.0, 2.5, 3.0, 10.0, 40.0, 100.0}) {
    if (edge <= lower) continue;
    const Quadrature rule = gauss_legendre(60, lower, std::min(edge, upper));
    for (std::size_t i = 0; i < rule.node.size(); ++i) sum += rule.weight[i] * f(rule.node[i]);
    lower = std::min(edge, upper);
    if (edge >= upper) break;
  }
  return sum;
}

// Haze and stratospheric layer together at 500 nm: shares of a total optical depth.
double part_between(const AerosolShape& shape, double lower_km, double upper_km, double aod500) {
  const double stratospheric = shape.stratospheric_share(aod500);
  return stratospheric * shape.stratospheric_between(lower_km, upper_km, 100.0) +
         (1.0 - stratospheric) * shape.haze_between(lower_km, upper_km, 100.0);
}

double density_per_km(const AerosolShape& shape, double altitude_km, double aod500) {
  const double stratospheric = shape.stratospheric_share(aod500);
  return stratospheric * shape.stratospheric_density_per_km(altitude_km, 100.0) +
         (1.0 - stratospheric) * shape.haze_density_per_km(altitude_km, 100.0);
}

TEST(AerosolShape, PartIsTheIntegralOfItsDensity) {
  for (const AerosolShape& shape : shapes())
    for (const double aod500 : {0.001, 0.005, 0.1, 1.0}) {
      EXPECT_NEAR(part_between(shape, 0.0, 100.0, aod500), 1.0, 1e-14);
      for (const auto& [lower, upper] :
           {std::pair{0.0, 0.1}, {1.0, 4.0}, {2.2, 2.7}, {15.0, 20.0}, {0.0, 30.0}}) {
        const auto density = [&](double z) { return density_per_km(shape, z, aod500); };
        EXPECT_NEAR(part_between(shape, lower, upper, aod500), integral(density, lower, upper), 1e-10)
            << aod500 << " " << lower;
      }
    }
}

TEST(AerosolShape, ClosedForms) {
  const std::vector<AerosolShape> all = shapes();
  // Constant to 2 km, then H = 1 km: 2 + 1 in all.
  EXPECT_NEAR(all[1].haze_between(0.0, 2.0, 100.0), 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(all[1].haze_between(2.0, 3.0, 100.0), (1.0 - std::exp(-1.0)) / 3.0, 1e-12);
  // ∫ of an exponential through 1 and 0.8 over 2 km.
  const double first = 2.0 * 0.2 / std::log(1.25);
  EXPECT_NEAR(all[2].haze_between(0.0, 2.0, 100.0) / all[2].haze_between(3.0, 10.0, 100.0),
              first / (0.5 * 7.0 * 0.02), 1e-10);
  EXPECT_EQ(all[2].haze_between(10.0, 100.0, 100.0), 0.0);
}

// The stratosphere keeps its own optical depth whatever the haze below it.
TEST(AerosolShape, StratosphereDoesNotFollowTheHaze) {
  const AerosolShape shape;
  const double thin = 0.1 * part_between(shape, 16.0, 30.0, 0.1);
  const double thick = 1.0 * part_between(shape, 16.0, 30.0, 1.0);
  // e^(-16/2) of the haze is all that is added.
  EXPECT_NEAR(thick - thin, 0.9 * std::exp(-8.0), 1e-6);
  EXPECT_NEAR(thin, 0.005 * 0.7704, 4e-5);  // Φ(11/4) - Φ(-3/4) = 0.7704
}

TEST(AerosolShape, OutOfRangeIsRefused) {
  const auto refused = [](const std::function<void(AerosolShape&)>& change) {
    AerosolShape shape;
    change(shape);
    EXPECT_THROW(shape.validate(), InputError);
  };
  for (const AerosolShape& shape : shapes()) EXPECT_NO_THROW(shape.validate());
  refused([](auto& s) { s.haze_scale_height_km = 0.0; });
  refused([](auto& s) { s.mixed_layer_km = -1.0; });
  refused([](auto& s) { s.stratospheric_aod500 = -0.1; });
  refused([](auto& s) { s.altitude_km = {0.0, 1.0}; });
  refused([](auto& s) { s.altitude_km = {1.0, 2.0}, s.relative_extinction = {1.0, 0.5}; });
  refused([](auto& s) { s.altitude_km = {0.0, 2.0}, s.relative_extinction = {0.0, 0.0}; });
  refused([](auto& s) { s.altitude_km = {0.0, 2.0}, s.relative_extinction = {1.0, NAN}; });
}

}  // namespace
}  // namespace skylut
