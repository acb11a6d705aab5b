#include "skylut/core/wavelength_grid.hpp"

#include <gtest/gtest.h>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

TEST(WavelengthGrid, VisibleHas81Wavelengths) {
  const WavelengthGrid grid = WavelengthGrid::visible();
  EXPECT_EQ(grid.size(), 81u);
  EXPECT_EQ(grid[80], 780.0);
}

TEST(WavelengthGrid, ParsesWhatItPrints) {
  const WavelengthGrid grid = WavelengthGrid::parse("400:700:2.5");
  EXPECT_EQ(grid.size(), 121u);
  EXPECT_EQ(grid.values_nm().back(), 700.0);
}

TEST(WavelengthGrid, RefusesWhatCannotBeMeant) {
  for (const char* text : {"", "400", "400:700", "400:700:0", "400:700:-5", "700:400:5", "400:703:5",
                           "200:700:5", "400:2000:5", "400:700:5:1", "400:700:nan", "a:b:c"})
    EXPECT_THROW(WavelengthGrid::parse(text), InputError) << text;
}

}  // namespace
}  // namespace skylut
