#include "skylut/scattering/aerosol_optics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

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
