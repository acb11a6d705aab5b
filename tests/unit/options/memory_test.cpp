#include "cli/memory.hpp"

#include <gtest/gtest.h>

#include "skylut/core/errors.hpp"

namespace skylut::cli {
namespace {

std::string refusal(const RequestSize& size) {
  try {
    require_memory(size);
  } catch (const InputError& error) {
    return error.what();
  }
  return "fits";
}

TEST(Memory, AMapNeedsAsMuchAsWasMeasured) {
  // Peaks of maps of 2 million directions, 81 wavelengths, less the 20 MB of the program: 790 B a direction.
  const double per_direction = needed_bytes({2.0 * 1024 * 1024, 81}) / (2.0 * 1024 * 1024);
  EXPECT_GT(per_direction, 700.0);
  EXPECT_LT(per_direction, 1100.0);
}

TEST(Memory, FineWavelengthsNeedAsMuchAsWasMeasured) {
  // Peaks for one direction, less the 25 MB of the program: 470 MB at 0.5 nm and 984 MB at 0.25 nm over
  // 300-1000 nm; 1050 MB for 200 loads at 21 wavelengths (271 directions).
  EXPECT_NEAR(needed_bytes({1, 1401}), 470e6, 0.3 * 470e6);
  EXPECT_NEAR(needed_bytes({1, 2801}), 984e6, 0.3 * 984e6);
  EXPECT_NEAR(needed_bytes({271, 21, 200}), 1050e6, 0.4 * 1050e6);
}

TEST(Memory, GrowsWithEveryList) {
  const RequestSize one{271, 81, 1, 1, 1};
  for (const auto& list : {&RequestSize::directions, &RequestSize::wavelengths, &RequestSize::turbidities,
                           &RequestSize::altitudes, &RequestSize::suns}) {
    RequestSize more = one;
    more.*list *= 2.0;
    EXPECT_GT(needed_bytes(more), needed_bytes(one));
  }
}

TEST(Memory, TheDefaultTableFits) { EXPECT_EQ(refusal({271, 81, 3, 5, 5}), "fits"); }

TEST(Memory, NamesTheListAndWhatFits) {
  const std::string text = refusal({271, 81, 1e9, 5, 5});
  EXPECT_TRUE(text.starts_with("--turbidities: 1000000000 values: needs about ")) << text;
  EXPECT_NE(text.find(" fit"), std::string::npos) << text;
}

}  // namespace
}  // namespace skylut::cli
