#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sky_cases.hpp"

namespace skylut {
namespace {

const SkyRequest kRequest = {
    {0.0, 12.0}, {20.0, 85.0, 91.0}, {{0.0, 0.0}, {70.0, 45.0}, {90.0, 180.0}, {95.0, 90.0}}};

/// More columns than the widest register has lanes, of different splittings and angular resolutions.
std::vector<OpticalColumn> many_columns() {
  std::vector<OpticalColumn> columns;
  for (int i = 0; i < 21; ++i)
    columns.push_back(test::column_of({.rayleigh_depth = 0.02 * (i + 1),
                                       .haze_depth = i % 3 == 0 ? 0.0 : 0.05 * i,
                                       .haze_scattering_albedo = 0.9,
                                       .haze_asymmetry = i % 2 == 0 ? 0.7 : 0.8,
                                       .ground_albedo = 0.04 * i}));
  return columns;
}

const std::vector<OpticalColumn>& columns() {
  static const std::vector<OpticalColumn> made = many_columns();
  return made;
}

SkyRadiance on_threads(int threads) {
  TransferOptions options;
  options.threads = threads;
  return solve_sky_radiance(test::earth(), columns(), kRequest, options);
}

/// All columns on one thread: what every other way of asking must repeat.
const SkyRadiance& together() {
  static const SkyRadiance sky = on_threads(1);
  return sky;
}

void expect_same(const SkyRadiance& sky, std::size_t column, std::size_t as_column) {
  for (std::size_t o = 0; o < 2; ++o)
    for (std::size_t s = 0; s < 3; ++s)
      for (std::size_t v = 0; v < 4; ++v)
        EXPECT_EQ(sky.at(column, o, s, v), together().at(as_column, o, s, v)) << as_column << o << s << v;
}

TEST(Independence, Threads) {
  for (const int threads : {2, 5}) {
    const SkyRadiance sky = on_threads(threads);
    for (std::size_t c = 0; c < columns().size(); ++c) expect_same(sky, c, c);
  }
}

TEST(Independence, ColumnsAlone) {
  for (const std::size_t c : {0u, 1u, 7u, 20u})
    expect_same(test::solve(test::earth(), columns()[c], kRequest), 0, c);
}

TEST(Independence, AnotherOrder) {
  std::vector<OpticalColumn> reversed(columns().rbegin(), columns().rend());
  const SkyRadiance sky = test::solve(test::earth(), reversed, kRequest);
  for (std::size_t c = 0; c < columns().size(); ++c) expect_same(sky, columns().size() - 1 - c, c);
}

// 2 … 17 columns of one splitting: lanes left over, and blocks of different fill.
TEST(Independence, LanesFilled) {
  for (const std::size_t count : {2u, 5u, 17u}) {
    std::vector<OpticalColumn> some(count, columns()[4]);
    some.back() = columns()[1];
    const SkyRadiance sky = test::solve(test::earth(), some, kRequest);
    for (std::size_t c = 0; c + 1 < count; ++c) expect_same(sky, c, 4);
    expect_same(sky, count - 1, 1);
  }
}

// One observer, sun and view asked for alone; the same among others, in another order, and twice.
TEST(Independence, OtherQuestions) {
  const std::vector<OpticalColumn> few = {columns()[2], columns()[4]};
  const std::size_t original[] = {2, 4};
  for (std::size_t o = 0; o < 2; ++o)
    for (std::size_t s = 0; s < 3; ++s)
      for (std::size_t v = 0; v < 4; ++v) {
        const SkyRadiance sky = test::solve(
            test::earth(), few,
            {{kRequest.observer_altitudes_km[o]}, {kRequest.sun_zeniths_deg[s]}, {kRequest.views[v]}});
        for (std::size_t c = 0; c < 2; ++c)
          EXPECT_EQ(sky.at(c, 0, 0, 0), together().at(original[c], o, s, v)) << o << s << v;
      }
  SkyRequest more{{30.0, 12.0, 12.0, 3.0, 0.0}, {91.0, 0.0, 85.0, 96.0, 20.0, 85.0}, {}};
  for (std::size_t v = 4; v-- > 0;) {
    more.views.push_back(kRequest.views[v]);
    more.views.push_back({kRequest.views[v].zenith_deg, 10.0});
  }
  const SkyRadiance sky = test::solve(test::earth(), few, more);
  const std::size_t observer_at[] = {4, 2};
  const std::size_t sun_at[] = {4, 5, 0};
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t o = 0; o < 2; ++o)
      for (std::size_t s = 0; s < 3; ++s)
        for (std::size_t v = 0; v < 4; ++v)
          EXPECT_EQ(sky.at(c, observer_at[o], sun_at[s], 2 * (3 - v)), together().at(original[c], o, s, v))
              << c << o << s << v;
}

TEST(Independence, ProgressIsReportedToTheEnd) {
  std::size_t last = 0;
  std::size_t whole = 0;
  TransferOptions options;
  options.progress = [&](std::size_t done, std::size_t all) {
    EXPECT_GT(done, last);
    last = done;
    whole = all;
  };
  solve_sky_radiance(test::earth(), std::span(columns()).first(3), kRequest, options);
  EXPECT_EQ(last, whole);
  EXPECT_GT(whole, 0u);
}

}  // namespace
}  // namespace skylut
