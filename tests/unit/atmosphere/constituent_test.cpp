// The list that an atmosphere is made of takes more than the air's own constituents.

#include "skylut/atmosphere/constituent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "skylut/core/errors.hpp"
#include "support/test_atmosphere.hpp"

namespace skylut {
namespace {

// A grey slab between two altitudes that no level of the air has.
class Slab final : public Constituent {
 public:
  Slab(double base_km, double top_km, double depth) : base_km_(base_km), top_km_(top_km), depth_(depth) {}
  std::string name() const override { return "slab"; }
  std::vector<double> boundaries_km() const override { return {base_km_, top_km_}; }
  void set_levels(const std::vector<double>& levels_km) override { levels_km_ = levels_km; }
  std::vector<ExtinctionTerm> extinction(const Band&, double, BandTerms) const override {
    return {{1.0, depths()}};
  }
  double depth_above(const Band&, double, double altitude_km) const override {
    return depth_ * std::clamp((top_km_ - altitude_km) / (top_km_ - base_km_), 0.0, 1.0);
  }
  std::vector<Scatterer> scatterers(double, double) const override {
    return {{std::make_shared<HenyeyGreensteinPhaseFunction>(0.85), depths()}};
  }
  nlohmann::ordered_json describe() const override { return {{"name", name()}, {"depth", depth_}}; }

 private:
  std::vector<double> depths() const {
    std::vector<double> depths;
    for (std::size_t i = 0; i + 1 < levels_km_.size(); ++i) {
      const bool inside = levels_km_[i] >= base_km_ - 1e-9 && levels_km_[i + 1] <= top_km_ + 1e-9;
      depths.push_back(inside ? depth_ * (levels_km_[i + 1] - levels_km_[i]) / (top_km_ - base_km_) : 0.0);
    }
    return depths;
  }
  double base_km_;
  double top_km_;
  double depth_;
  std::vector<double> levels_km_;
};

Atmosphere with(double base_km, double top_km) {
  std::vector<std::unique_ptr<Constituent>> more;
  more.push_back(std::make_unique<Slab>(base_km, top_km, 3.0));
  return {test::context, load_profile(test::context, "ussa1976"), {}, std::move(more)};
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(Constituent, BringsItsBoundariesDepthsAndScatterers) {
  const Atmosphere clear(test::context, load_profile(test::context, "ussa1976"), {});
  const Atmosphere cloudy = with(1.23, 1.61);
  const std::vector<double>& levels = cloudy.shells().levels_km;
  EXPECT_EQ(levels.size(), clear.shells().levels_km.size() + 2);
  EXPECT_TRUE(std::is_sorted(levels.begin(), levels.end()));
  EXPECT_TRUE(std::binary_search(levels.begin(), levels.end(), 1.23));
  const OpticalColumn column = cloudy.column(550.0, 0.1);
  EXPECT_NEAR(sum(column.extinction_depth), sum(clear.column(550.0, 0.1).extinction_depth) + 3.0, 1e-9);
  ASSERT_EQ(column.scatterers.size(), clear.column(550.0, 0.1).scatterers.size() + 1);
  EXPECT_NEAR(sum(column.scatterers.back().scattering_depth), 3.0, 1e-12);
  EXPECT_EQ(cloudy.optical_depths({}, 0.1, 1.61).back().depth, 0.0);
  EXPECT_NEAR(cloudy.optical_depths({}, 0.1, 1.42).back().depth, 1.5, 1e-9);
  EXPECT_EQ(cloudy.describe()["slab"]["depth"], 3.0);
}

TEST(Constituent, ABoundaryOnALevelAddsNone) {
  EXPECT_EQ(with(1.0, 2.0).shells().levels_km,
            Atmosphere(test::context, load_profile(test::context, "ussa1976"), {}).shells().levels_km);
}

TEST(Constituent, NamesAreUniqueAndBoundariesInside) {
  EXPECT_THROW(with(1.0, 200.0), InputError);
  std::vector<std::unique_ptr<Constituent>> twice;
  twice.push_back(std::make_unique<Slab>(1.0, 2.0, 1.0));
  twice.push_back(std::make_unique<Slab>(3.0, 4.0, 1.0));
  EXPECT_THROW(Atmosphere(test::context, load_profile(test::context, "ussa1976"), {}, std::move(twice)),
               InputError);
}

}  // namespace
}  // namespace skylut
