#include "skylut/optics/aerosol.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {
namespace {

TEST(Aerosol, ShapeIsTheIntegralOfItsDensity) {
  const AerosolShape shape;
  for (double aod500 : {0.001, 0.005, 0.1, 1.0}) {
    EXPECT_NEAR(shape.part_between(0.0, 100.0, 100.0, aod500), 1.0, 1e-14);
    for (const auto& [lower, upper] : {std::pair{0.0, 0.1}, {1.0, 4.0}, {15.0, 20.0}, {0.0, 30.0}}) {
      double integral = 0.0;
      const Quadrature rule = gauss_legendre(60, lower, upper);
      for (std::size_t i = 0; i < rule.node.size(); ++i)
        integral += rule.weight[i] * shape.density_per_km(rule.node[i], 100.0, aod500);
      EXPECT_NEAR(shape.part_between(lower, upper, 100.0, aod500), integral, 1e-12) << aod500 << " " << lower;
    }
  }
}

// The stratosphere keeps its own optical depth whatever the haze below it.
TEST(Aerosol, StratosphereDoesNotFollowTheHaze) {
  const AerosolShape shape;
  const double thin = 0.1 * shape.part_between(16.0, 30.0, 100.0, 0.1);
  const double thick = 1.0 * shape.part_between(16.0, 30.0, 100.0, 1.0);
  // e^(-16/2) of the haze is all that is added.
  EXPECT_NEAR(thick - thin, 0.9 * std::exp(-8.0), 1e-6);
  EXPECT_NEAR(thin, 0.005 * 0.7704, 4e-5);  // Φ(11/4) - Φ(-3/4) = 0.7704
}

TEST(Aerosol, AngstromLaw) {
  const AerosolOptics aerosol;
  EXPECT_DOUBLE_EQ(aerosol.relative_depth(500.0), 1.0);
  EXPECT_NEAR(std::log(aerosol.relative_depth(400.0) / aerosol.relative_depth(800.0)) / std::log(2.0), 1.3,
              1e-14);
}

TEST(Aerosol, RuralPropertiesByWavelength) {
  const AerosolOptics aerosol;
  EXPECT_NEAR(aerosol.single_scattering_albedo_at(550.0), 0.9462, 1e-12);
  EXPECT_NEAR(aerosol.asymmetry_at(550.0), 0.6630, 1e-12);
  EXPECT_NEAR(aerosol.asymmetry_at(443.55), 0.5 * (0.6865 + 0.6630), 1e-12);
  EXPECT_EQ(aerosol.asymmetry_at(250.0), 0.6928);
  EXPECT_EQ(aerosol.asymmetry_at(2000.0), 0.6314);
  EXPECT_NEAR(aerosol.phase_function(550.0)->moment(1), 0.6630, 1e-12);
}

TEST(Aerosol, OutOfRangeIsRefused) {
  const auto refused = [](const std::function<void(AerosolOptics&)>& change) {
    AerosolOptics aerosol;
    change(aerosol);
    EXPECT_THROW(aerosol.validate(), InputError);
  };
  EXPECT_NO_THROW(AerosolOptics{}.validate());
  refused([](auto& a) { a.angstrom_exponent = NAN; });
  refused([](auto& a) { a.single_scattering_albedo[1] = 1.1; });
  refused([](auto& a) { a.asymmetry[0] = 1.0; });
  refused([](auto& a) { a.wavelength_nm[1] = 200.0; });
  refused([](auto& a) { a.asymmetry.pop_back(); });
  refused([](auto& a) { a.shape.haze_scale_height_km = 0.0; });
  refused([](auto& a) { a.shape.stratospheric_aod500 = -0.1; });
}

}  // namespace
}  // namespace skylut
