#include "skylut/forms/map_skies.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

class MapSkiesTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void write(const std::string& name, const std::string& sun, const std::string& kind = "aod500") const {
    std::ofstream(folder_ / name) << "zenith_deg,azimuth_deg,Y_cd_m2,x,y,L_400,L_500\n# altitude_km=2\n"
                                     "# turbidity=0.3\n# turbidity_kind="
                                  << kind << "\n"
                                  << sun
                                  << "0,0,1000,0.3,0.31,0.01,0.02\n60,10,2000,0.32,0.33,0.03,0.04\n"
                                     "120,10,500,0.3,0.3,0.01,0.01\n";
  }
  std::string refusal() const {
    try {
      const MapSkies skies(folder_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  fs::path folder_ = fs::path(testing::TempDir()) / "map_skies_test";
};

constexpr const char* kSun = "# sun_zenith_deg=40\n# sun_azimuth_deg=90\n";

TEST_F(MapSkiesTest, HoldWhatTheFilesSay) {
  write("b.csv", kSun);
  write("a.csv", "# sun_zenith_deg=50\n# sun_azimuth_deg=0\n");
  write("c.csv", "# sun_zenith_deg=40\n# sun_azimuth_deg=270\n");  // mirror image of b
  const MapSkies skies(folder_);
  EXPECT_EQ(skies.axes().altitudes_km, (std::vector{2.0}));
  EXPECT_EQ(skies.axes().sun_zeniths_deg, (std::vector{40.0, 50.0}));
  EXPECT_EQ(skies.wavelengths()->size(), 2u);
  const std::vector<TrainingSky> given = skies.given(test::context, fitting_views);
  ASSERT_EQ(given.size(), 2u);
  EXPECT_EQ(given[0].conditions.sun.zenith_deg, 50.0);
  ASSERT_EQ(given[0].colours.size(), 2u);  // the view below the horizon is none of the dome's
  EXPECT_EQ(given[1].colours[1], (Yxy{2000.0, 0.32, 0.33}));
  EXPECT_EQ(given[1].radiance, (std::vector{0.01f, 0.02f, 0.03f, 0.04f}));
  EXPECT_NEAR(given[1].dome.solid_angle[0] + given[1].dome.solid_angle[1], 2.0 * kPi, 1e-9);
}

TEST_F(MapSkiesTest, RefuseWhatTheyCannotUse) {
  EXPECT_NE(refusal().find("must have table.json or .csv files"), std::string::npos) << refusal();
  write("a.csv", "# sun_zenith_deg=40\n");
  EXPECT_NE(refusal().find("does not say its sun_azimuth_deg"), std::string::npos) << refusal();
  write("a.csv", kSun);
  EXPECT_EQ(refusal(), "");
  write("b.csv", "# sun_zenith_deg=41\n# sun_azimuth_deg=90\n", "angstrom-beta");
  EXPECT_NE(refusal().find("turbidity_kind=angstrom-beta: must be that of"), std::string::npos) << refusal();
  write("b.csv", "# sun_zenith_deg=100\n# sun_azimuth_deg=90\n");
  EXPECT_NE(refusal().find("sun_zenith_deg=100: must lie within 0 to 99"), std::string::npos) << refusal();
}

TEST_F(MapSkiesTest, SimulateNothing) {
  write("a.csv", kSun);
  const MapSkies skies(folder_);
  EXPECT_THROW(skies.simulated(test::context, std::vector<SoughtSky>(1), fitting_views), InputError);
}

}  // namespace
}  // namespace skylut
