#include "skylut/sky/view_set.hpp"

#include <gtest/gtest.h>

namespace skylut {
namespace {

TEST(RelativeView, HasNoAzimuthWhereItHasNoMeaning) {
  EXPECT_EQ(relative_view({0.0, 77.0}, {45.0, 90.0}), (RelativeView{0.0, 0.0}));
  EXPECT_EQ(relative_view({180.0, 77.0}, {45.0, 90.0}), (RelativeView{180.0, 0.0}));
  EXPECT_EQ(relative_view({60.0, 77.0}, {0.0, 90.0}), (RelativeView{60.0, 0.0}));
  EXPECT_EQ(relative_view({60.0, 80.0}, {45.0, 90.0}), (RelativeView{60.0, 10.0}));
  EXPECT_EQ(relative_view({60.0, 10.0}, {45.0, 350.0}), (RelativeView{60.0, 20.0}));
}

// The UTM directions, 12° apart, stand symmetrically to a sun in the east or west: 15 different relative
// azimuths (6°, 18° … 174°, two of 90° apart) on 9 rings, and the zenith. A sun at the zenith sees rings.
TEST(ViewSet, MirrorImagesAreComputedOnce) {
  const std::vector<Direction> suns{{90.0, 90.0}, {45.0, 90.0}, {0.0, 0.0}, {45.0, 270.0}, {90.0, 270.0}};
  const std::vector<Direction> views = directions_utm271();
  const ViewSet set(views, suns);
  EXPECT_EQ(set.size(), 10u + 2u * (1u + 9u * 15u));
  const std::vector<Sight> sights = set.sights(std::vector{0.0, 12.0});
  ASSERT_EQ(sights.size(), 2 * set.size());
  for (std::size_t sun = 0; sun < suns.size(); ++sun)
    for (std::size_t view = 0; view < views.size(); ++view)
      for (const std::size_t altitude : {0u, 1u}) {
        const Sight& sight = sights[altitude * set.size() + set.index(view, sun)];
        EXPECT_EQ(sight.observer_altitude_km, 12.0 * static_cast<double>(altitude));
        EXPECT_EQ(sight.sun_zenith_deg, suns[sun].zenith_deg);
        EXPECT_EQ(sight.view, relative_view(views[view], suns[sun]));
      }
}

// Suns of different zenith angle and azimuth do not ask for each other's views: the number grows with the
// suns, not with their square.
TEST(ViewSet, ViewsAreSeenUnderTheirOwnSun) {
  const std::vector<Direction> views = directions_utm271();
  const std::vector<Direction> suns{{30.0, 11.0}, {50.0, 47.0}, {70.0, 93.0}};
  EXPECT_LE(ViewSet(views, suns).size(), 3 * views.size());
}

}  // namespace
}  // namespace skylut
