#include "skylut/export/model_light.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "skylut/core/errors.hpp"
#include "skylut/export/picture_sampler.hpp"
#include "skylut/models/preetham1999.hpp"

namespace skylut {
namespace {

constexpr Direction kSun{60.0, 120.0};

std::shared_ptr<const Sky> preetham_sky() {
  return Preetham1999().at({.altitude_km = 0.0, .turbidity = {TurbidityKind::preetham_t, 3.0}, .sun = kSun});
}

TEST(ModelLight, IsTheModelsColourAndBlackWhereItHasNone) {
  const auto sky = preetham_sky();
  const ModelLight light(sky, Preetham1999().info().view_zenith_deg, kSun, 0.0);
  const std::vector<Direction> views{{30.0, 10.0}, {95.0, 10.0}, {90.0, 200.0}, {180.0, 0.0}, {0.0, 0.0}};
  std::vector<Xyz> colours(views.size());
  light.colour(views, colours);
  for (const std::size_t seen : {0u, 2u, 4u}) EXPECT_EQ(colours[seen], to_xyz(sky->colour(views[seen])));
  for (const std::size_t below : {1u, 3u}) EXPECT_EQ(colours[below], Xyz{});
  EXPECT_EQ(light.horizon_zenith_deg(), 90.0);
  EXPECT_EQ(light.sun(), kSun);
}

// A small pixel far from sun and horizon is the model in the direction of its middle.
TEST(ModelLight, APictureIsTheModelAtItsPixels) {
  const auto sky = preetham_sky();
  const ModelLight light(sky, Preetham1999().info().view_zenith_deg, kSun, 0.0);
  const auto projections = make_projections({"latlong", 256, SkyPart::sphere});
  const PictureSampler sampler(light, *projections.front());
  std::vector<Xyz> row(512);
  sampler.sample_row(40, row, {});
  for (const int column : {0, 100, 400}) {
    const Direction middle = projections.front()->direction(column, 40).value();
    EXPECT_NEAR(row[static_cast<std::size_t>(column)].Y, sky->colour(middle).Y, 1e-9 * sky->colour(middle).Y);
  }
  sampler.sample_row(200, row, {});
  EXPECT_EQ(row[7], Xyz{});
}

// cos of the dip is 6371/(6371 + 12): 3.51 deg. Only a model that looks down so far has this horizon.
TEST(ModelLight, TheHorizonIsTheGeometricOneOrWhereTheModelEnds) {
  EXPECT_NEAR(ModelLight(preetham_sky(), {0.0, 180.0, "deg"}, kSun, 12.0).horizon_zenith_deg(), 93.51, 0.01);
  EXPECT_EQ(ModelLight(preetham_sky(), {0.0, 90.0, "deg"}, kSun, 12.0).horizon_zenith_deg(), 90.0);
}

TEST(ModelLight, HasNoSpectraOfAModelWithoutThem) {
  const ModelLight light(preetham_sky(), {0.0, 90.0, "deg"}, kSun, 0.0);
  std::vector<float> radiance(light.wavelengths().size());
  const Direction zenith{};
  EXPECT_THROW(light.radiance({&zenith, 1}, radiance), InputError);
}

}  // namespace
}  // namespace skylut
