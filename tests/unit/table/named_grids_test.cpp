#include "skylut/table/named_grids.hpp"

#include <gtest/gtest.h>

#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

TEST(NamedGrids, AreFoundByName) {
  EXPECT_EQ(named_grid("utm2005").altitudes_km.size() * named_grid("utm2005").turbidities.size() *
                named_grid("utm2005").suns.size(),
            75u);
  EXPECT_EQ(named_grid("preetham").turbidity_kind, TurbidityKind::preetham_t);
  EXPECT_EQ(named_grid("preetham").suns.size(), 12u);
  EXPECT_THROW(named_grid("dense"), InputError);
}

// What is interpolated has its nodes in order, within what can be simulated, over the whole of 0-30 km, loads
// 0-1 and suns to the end of civil twilight.
TEST(NamedGrids, TheRuntimeGridSpansItsDomain) {
  const NamedGrid& grid = named_grid("runtime");
  EXPECT_TRUE(grid.for_between);
  for (const std::vector<double>& axis : {grid.altitudes_km, grid.turbidities})
    for (std::size_t i = 1; i < axis.size(); ++i) EXPECT_LT(axis[i - 1], axis[i]);
  for (std::size_t i = 1; i < grid.suns.size(); ++i)
    EXPECT_LT(grid.suns[i - 1].zenith_deg, grid.suns[i].zenith_deg);
  EXPECT_EQ(grid.altitudes_km.front(), domain::kObserver_km.lowest);
  EXPECT_EQ(grid.altitudes_km.back(), domain::kObserver_km.highest);
  EXPECT_EQ(grid.turbidities.front(), 0.0);
  EXPECT_EQ(grid.turbidities.back(), 1.0);
  EXPECT_LE(grid.suns.front().zenith_deg, 5.0);  // from where a table reaches the zenith
  EXPECT_EQ(grid.suns.back().zenith_deg, 96.0);
}

}  // namespace
}  // namespace skylut
