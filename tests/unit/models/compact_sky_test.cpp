#include "skylut/models/compact_sky.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "models/compact/fast_math.hpp"
#include "models/compact/packed_numbers.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/json_reader.hpp"
#include "skylut/models/compact/cubic_spline.hpp"
#include "skylut/models/compact/tables.hpp"
#include "support/compact_domain.hpp"

namespace skylut {
namespace {

using namespace compact;

TEST(CubicSpline, ReproducesCubicsFromTheirBlossoms) {
  // A cubic's coefficient of a B-spline is its blossom at the three inner knots: for x³ their product.
  const std::vector<double> nodes{0.0, 1.0, 2.5, 3.0, 5.0, 7.0};
  const std::vector<double> knots{0.0, 0.0, 0.0, 0.0, 2.5, 3.0, 7.0, 7.0, 7.0, 7.0};
  const CubicSpline spline(nodes);
  ASSERT_EQ(spline.size(), 6U);
  for (const double x : {0.0, 0.3, 1.0, 2.5, 2.9, 4.2, 6.999, 7.0}) {
    const SplineTaps taps = spline.taps(x);
    double cube = 0.0;
    double one = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t i = taps.first + k;
      cube += taps.weight[k] * knots[i + 1] * knots[i + 2] * knots[i + 3];
      one += taps.weight[k];
    }
    EXPECT_NEAR(cube, x * x * x, 1e-11) << x;
    EXPECT_NEAR(one, 1.0, 1e-14) << x;
  }
}

TEST(CubicSpline, HoldsItsEndsBeyondThem) {
  const CubicSpline spline({0.0, 1.0, 2.0, 3.0, 4.0});
  EXPECT_EQ(spline.taps(9.0).first, spline.taps(4.0).first);
  EXPECT_DOUBLE_EQ(spline.taps(9.0).weight[3], 1.0);
  EXPECT_DOUBLE_EQ(spline.taps(-1.0).weight[0], 1.0);
}

TEST(FastExp, IsTheExponential) {
  for (float x = -60.0f; x < 60.0f; x += 0.0371f)
    EXPECT_NEAR(fast_exp(x) / std::exp(static_cast<double>(x)), 1.0, 5e-7) << x;
  EXPECT_TRUE(std::isfinite(fast_exp(1e9f)));
  EXPECT_GT(fast_exp(-1e9f), 0.0f);
}

TEST(FastAcos, IsTheArcCosine) {
  for (double angle = 0.0017; angle < kPi; angle += 0.00137) {
    const float cosine = static_cast<float>(std::cos(angle));
    EXPECT_NEAR(fast_acos(cosine), std::acos(static_cast<double>(cosine)), 1e-6) << angle;
  }
  EXPECT_EQ(fast_acos(1.0f), 0.0f);
  EXPECT_EQ(fast_acos(1.0000001f), 0.0f);
  EXPECT_NEAR(fast_acos(-1.0f), kPi, 1e-6);
}

TEST(PackedNumbers, ComeBackWithinHalfAStep) {
  std::vector<float> values;
  for (int i = 0; i < 1000; ++i) values.push_back(static_cast<float>(std::sin(0.37 * i) * (i % 7)));
  for (const double step : {0.1, 1e-3, 1e-9, 0.0}) {
    const nlohmann::ordered_json packed = pack_numbers(values, step);
    const std::vector<float> back = unpack_numbers(JsonReader(packed, "file"), values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(back[i], values[i], packed.contains("step") ? 0.5001 * step : 0.0) << i;
    EXPECT_EQ(packed.contains("step"), step > 1e-6);
  }
}

TEST(PackedNumbers, TakeAsManyBitsAsABlockNeeds) {
  // 16 numbers up to ±3 steps: 3 bits each, 5 for the block; 16 zeros: 5 bits. 58 bits are 8 bytes.
  std::vector<float> values;
  for (int i = 0; i < 16; ++i) values.push_back(static_cast<float>(i % 7 - 3));
  values.insert(values.end(), 16, 0.0f);
  EXPECT_EQ(pack_numbers(values, 1.0)["base64"].get<std::string>().size(), 12U);
}

TEST(PackedNumbers, RefuseWhatIsNotThere) {
  nlohmann::ordered_json packed = pack_numbers(std::vector<float>{1.0f, 2.0f}, 0.1);
  EXPECT_THROW(unpack_numbers(JsonReader(packed, "file"), 3), InputError);
  packed["base64"] = "?!";
  EXPECT_THROW(unpack_numbers(JsonReader(packed, "file"), 2), InputError);
  packed = pack_numbers(std::vector<float>{std::nanf("")}, 0.0);
  EXPECT_THROW(unpack_numbers(JsonReader(packed, "file"), 1), InputError);
}

TEST(ZenithGrid, NodesAreWholeNumbersOfTheirPanel) {
  const ZenithGrid grid({6, 7, 5}, 6371.0);
  for (const double altitude_km : {0.5, 12.0, 30.0}) {
    double before = 181.0;
    for (std::size_t node = 0; node < 6; ++node) {  // from the horizontal up to the zenith
      const double zenith_deg = grid.node_zenith_deg(node, altitude_km);
      EXPECT_LT(zenith_deg, before);
      before = zenith_deg;
    }
    EXPECT_NEAR(before, 0.0, 1e-12);
    before = 0.0;
    for (std::size_t node = 6; node < grid.size(); ++node) {  // down to the horizon, and on to the nadir
      const double zenith_deg = grid.node_zenith_deg(node, altitude_km);
      EXPECT_GE(zenith_deg, before);
      before = zenith_deg;
    }
    EXPECT_NEAR(before, 180.0, 1e-9);
    const double horizon_deg = 180.0 - std::asin(6371.0 / (6371.0 + altitude_km)) * kDegreesPerRadian;
    EXPECT_NEAR(grid.node_zenith_deg(12, altitude_km), horizon_deg, 1e-9);
    EXPECT_NEAR(grid.node_zenith_deg(13, altitude_km), horizon_deg, 1e-9);
    // At an end the panel's end coefficient stands alone.
    EXPECT_NEAR(grid.taps(90.0, altitude_km).weight[0], 1.0, 1e-9);
    EXPECT_EQ(grid.taps(90.0, altitude_km).first, 0U);
    const SplineTaps horizon = grid.taps(horizon_deg - 1e-9, altitude_km);
    EXPECT_EQ(horizon.first, 6U + 3U);
    EXPECT_NEAR(horizon.weight[3], 1.0, 1e-5);
  }
}

/// A table of nothing but its mean: the same everywhere.
Tables plain_tables() {
  Tables tables;
  tables.nodes = {{0.0, 1.0, 10.0, 30.0}, {0.0, 0.01, 0.1, 0.5, 1.0}, {0.0, 45.0, 90.0, 96.0}};
  tables.planet_radius_km = 6371.0;
  tables.zenith_counts = {4, 4, 4};
  tables.channels = {"X", "Y", "Z"};
  tables.terms = 1;
  for (int i = 0; i < 1024; ++i) tables.haze_terms.push_back(2.0f);
  tables.haze_mean = 2.0;
  tables.rayleigh_0 = {1.5, 1.5, 1.5};
  tables.rayleigh_90 = {0.75, 0.75, 0.75};
  tables.spherical_albedo.assign(30, 0.2f);
  const auto ones = [](std::size_t rows) { return Basis{rows, 1, std::vector<float>(rows, 1.0f)}; };
  tables.load = ones(5);
  tables.altitude = ones(4);
  tables.sun = ones(4);
  tables.zenith = ones(12);
  tables.rank = 1;
  tables.condition_core = {0.0f};
  const Layout layout = tables.layout();
  tables.feature_core.assign(layout.size(), 0.0f);
  tables.step = 1e-3;
  std::vector<float> row(layout.size(), 0.0f);
  row[layout.at(0, layout.brightness())] = std::log(1000.0f);
  for (std::size_t c = 0; c < 3; ++c) {
    row[layout.at(0, layout.molecules(c))] = 0.4f;
    row[layout.at(0, layout.haze(c))] = std::log(static_cast<float>(0.3 / 0.5 + Layout::kFloor));
    row[layout.at(0, layout.ground(c))] = std::log(0.5f);
  }
  for (int node = 0; node < 12; ++node) tables.mean.insert(tables.mean.end(), row.begin(), row.end());
  return tables;
}

TEST(CompactSky, AddsUpItsParts) {
  // t = 1000, R = 400, a = 0.3/0.5 · l · t = 300 at l = 0.5, G = 500, and so D = 1000 - 400 - 300 - 100 =
  // 200; haze and diffuse light are isotropic, w = A (1 - S)/(1 - A S).
  const CompactSkyModel model(test::compact_domain(), plain_tables());
  SkyConditions conditions;
  conditions.turbidity = {TurbidityKind::aod500, 0.5};
  conditions.sun = {0.0, 0.0};
  for (const double albedo : {0.0, 0.2, 1.0}) {
    conditions.albedo = albedo;
    const double w = albedo * 0.8 / (1.0 - 0.2 * albedo);
    const auto sky = model.at(conditions);
    EXPECT_NEAR(sky->colour({0.0, 0.0}).Y, 1.5 * 400.0 + 300.0 + 200.0 + w * 500.0, 0.01);
    EXPECT_NEAR(sky->colour({90.0, 77.0}).Y, 0.75 * 400.0 + 300.0 + 200.0 + w * 500.0, 0.01);
  }
}

TEST(CompactSky, IsNeverNegative) {
  Tables tables = plain_tables();
  const Layout layout = tables.layout();
  for (std::size_t node = 0; node < 12; ++node)
    tables.mean[node * layout.size() + layout.at(0, layout.molecules(1))] = -50.0f;
  const CompactSkyModel model(test::compact_domain(), tables);
  SkyConditions conditions;
  conditions.turbidity = {TurbidityKind::aod500, 0.5};
  EXPECT_GT(model.at(conditions)->colour({10.0, 0.0}).Y, 0.0);
}

TEST(CompactSky, RefusesWhatLiesOutside) {
  const CompactSkyModel model(test::compact_domain(), plain_tables());
  SkyConditions conditions;
  conditions.turbidity = {TurbidityKind::aod500, 1.5};
  EXPECT_THROW(model.at(conditions), InputError);
  conditions.turbidity = {TurbidityKind::preetham_t, 2.0};
  EXPECT_THROW(model.at(conditions), InputError);
  conditions.turbidity = {TurbidityKind::aod500, 0.5};
  conditions.altitude_km = 31.0;
  EXPECT_THROW(model.at(conditions), InputError);
  conditions.altitude_km = 0.0;
  EXPECT_THROW(model.at(conditions)->colour({181.0, 0.0}), InputError);
}

TEST(CompactSky, ReadsBackWhatItWrites) {
  const Tables tables = plain_tables();
  const nlohmann::ordered_json json = tables_json(tables);
  const auto read = CompactSkyModel::read(test::compact_domain(), JsonReader(json, "file"));
  const CompactSkyModel model(test::compact_domain(), tables);
  SkyConditions conditions;
  conditions.turbidity = {TurbidityKind::aod500, 0.3};
  conditions.sun = {50.0, 10.0};
  EXPECT_NEAR(read->at(conditions)->colour({30.0, 40.0}).Y, model.at(conditions)->colour({30.0, 40.0}).Y,
              0.1);
  nlohmann::ordered_json broken = json;
  broken["rank"] = 2;
  EXPECT_THROW(CompactSkyModel::read(test::compact_domain(), JsonReader(broken, "file")), InputError);
  broken = json;
  broken["altitudes_km"] = {0.0, 2.0, 1.0, 30.0};
  EXPECT_THROW(CompactSkyModel::read(test::compact_domain(), JsonReader(broken, "file")), InputError);
}

}  // namespace
}  // namespace skylut
