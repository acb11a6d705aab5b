#include "skylut/export/frames_csv.hpp"

#include <gtest/gtest.h>

#include "skylut/core/errors.hpp"
#include "support/test_atmosphere.hpp"
#include "support/test_context.hpp"
#include "test_light.hpp"

namespace skylut {
namespace {

TEST(FrameFile, SortsAsItsNumbersDo) {
  EXPECT_EQ(frame_file("sky.exr", 1, 12), "sky_0001.exr");
  EXPECT_EQ(frame_file("out/sky.exr", 9999, 9999), "out/sky_9999.exr");
  EXPECT_EQ(frame_file("out.d/a.b.csv", 42, 100000), "out.d/a.b_000042.csv");
  EXPECT_EQ(frame_file("sky", 7, 10000), "sky_00007");
}

TEST(FramesCsv, OneRowPerFrame) {
  const std::vector<FrameRow> rows{
      {{1, parse_time("2024-06-21T04:00Z"), {85.5, 60.25}, 1.0162}, 1e4, 784.6, 5000.5, "sky_0001.exr"},
      {{2, std::nullopt, {95.0, 300.0}, 1.0}, 0.0, 0.0, 3.5, "sky_0002.exr"}};
  const std::string text = frames_csv(rows, Provenance("skylut map …"));
  EXPECT_TRUE(
      text.starts_with("index,time,sun_zenith_deg,sun_azimuth_deg,sun_distance_au,direct_normal_lux,"
                       "direct_horizontal_lux,diffuse_horizontal_lux,file\n# command: skylut map …\n"));
  EXPECT_TRUE(
      text.ends_with("\n1,2024-06-21T04:00:00Z,85.5,60.25,1.0162,10000,784.6,5000.5,sky_0001.exr\n"
                     "2,,95,300,1,0,0,3.5,sky_0002.exr\n"))
      << text;
}

// The beam on a plane is that of the disc times the cosine; from below the plane there is none.
TEST(FrameRow, HoldsTheDiscsAndTheSkysLight) {
  const test::FormulaLight sky([](const Direction& d) { return d.zenith_deg < 90.0 ? 1000.0 : 0.0; });
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {3.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.1}};
  for (const double zenith_deg : {60.0, 90.5}) {
    scene.suns = {{zenith_deg, 10.0}};
    const SunDisc disc(test::context, scene);
    const FrameRow row = frame_row({7, std::nullopt, scene.suns[0], 1.0}, sky, disc, "sky_0007.exr");
    EXPECT_EQ(row.frame.index, 7u);
    EXPECT_EQ(row.file, "sky_0007.exr");
    EXPECT_GT(row.direct_normal_lux, 10.0);
    EXPECT_DOUBLE_EQ(row.direct_normal_lux, disc.illuminance().Y);
    EXPECT_NEAR(row.direct_horizontal_lux, zenith_deg < 90.0 ? 0.5 * row.direct_normal_lux : 0.0,
                1e-9 * row.direct_normal_lux);
    EXPECT_NEAR(row.diffuse_horizontal_lux / (kPi * 1000.0), 1.0, 1e-4);
  }
}

TEST(FramesCsv, RefusesNamesThatWouldBreakTheRow) {
  const std::vector<FrameRow> rows{{{}, 0.0, 0.0, 0.0, "a,b.exr"}};
  EXPECT_THROW(frames_csv(rows, Provenance()), InputError);
}

}  // namespace
}  // namespace skylut
