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
  EXPECT_EQ(set.unique_sun_zeniths_deg(), (std::vector<double>{0.0, 45.0, 90.0}));
  EXPECT_EQ(set.unique_views().size(), 1u + 9u * 15u + 9u);
  for (std::size_t sun = 0; sun < suns.size(); ++sun) {
    EXPECT_EQ(set.unique_sun_zeniths_deg()[set.sun_index(sun)], suns[sun].zenith_deg);
    for (std::size_t view = 0; view < views.size(); ++view)
      EXPECT_EQ(set.unique_views()[set.view_index(view, sun)], relative_view(views[view], suns[sun]));
  }
}

}  // namespace
}  // namespace skylut
