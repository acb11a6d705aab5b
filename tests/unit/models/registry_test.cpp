#include "skylut/models/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

TEST(Registry, MakesEveryModelThatItNames) {
  const std::vector<std::string> names = sky_model_names();
  EXPECT_NE(std::find(names.begin(), names.end(), "preetham1999"), names.end());
  for (const std::string& name : names) {
    const ModelInfo& info = make_sky_model(name)->info();
    EXPECT_EQ(info.name, name);
    EXPECT_FALSE(info.title.empty());
    EXPECT_FALSE(info.source.empty());
    EXPECT_LE(info.turbidity.lowest, info.turbidity.highest);
  }
}

// In the middle of what its source vouches for, every model gives light.
TEST(Registry, EveryModelGivesLight) {
  for (const std::string& name : sky_model_names()) {
    const auto model = make_sky_model(name);
    const ModelInfo& info = model->info();
    const double turbidity = 0.5 * (info.turbidity.lowest + info.turbidity.highest);
    const auto sky = model->at({.altitude_km = info.altitude_km.lowest,
                                .turbidity = {info.turbidity_kind, turbidity},
                                .sun = {45.0, 90.0}});
    for (const Direction& view : directions_utm271()) EXPECT_GT(sky->colour(view).Y, 0.0) << name;
  }
}

TEST(Registry, NamesTheModelsThereAre) {
  try {
    make_sky_model("nishita");
    FAIL() << "there is no such model";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'nishita': must be one of preetham1999"), std::string::npos);
  }
}

}  // namespace
}  // namespace skylut
