#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sky_cases.hpp"
#include "skylut/core/errors.hpp"

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
  return solve_sky_radiance(test::on_threads(threads), test::earth(), columns(), kRequest,
                            test::unpolarised());
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

// Columns with none, one, two and three scatterers in one block: the absorber first, in the
// middle and last. The sun's aureole is among the views, where the forward peaks are worked out lane by lane.
TEST(Independence, ColumnsOfOtherScatterers) {
  const auto two = std::make_shared<const HenyeyGreensteinPhaseFunction>(0.8);
  std::vector<OpticalColumn> mixed(4);
  for (OpticalColumn& column : mixed) {
    column.extinction_depth = test::exponential_depths(0.1, 8.0);
    column.ground_albedo = 0.3;
  }
  const std::vector<double> share = test::exponential_depths(0.03, 8.0);
  mixed[1].scatterers = {{std::make_shared<const RayleighPhaseFunction>(), share}};
  mixed[2].scatterers = {{std::make_shared<const RayleighPhaseFunction>(), share}, {two, share}};
  mixed[3].scatterers = {{two, share},
                         {std::make_shared<const RayleighPhaseFunction>(), share},
                         {std::make_shared<const HenyeyGreensteinPhaseFunction>(0.5), share}};
  const SkyRequest request{{0.0, 3.0}, {20.0, 85.0}, {{0.0, 0.0}, {21.0, 0.0}, {84.0, 1.0}, {95.0, 90.0}}};
  std::vector<SkyRadiance> alone;
  for (const OpticalColumn& column : mixed) alone.push_back(test::solve(test::earth(), column, request));
  std::vector<std::size_t> order{0, 1, 2, 3};
  for (int turn = 0; turn < 4; ++turn) {
    std::rotate(order.begin(), order.begin() + 1, order.end());
    std::vector<OpticalColumn> columns;
    for (const std::size_t at : order) columns.push_back(mixed[at]);
    const SkyRadiance sky = test::solve(test::earth(), columns, request);
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t o = 0; o < 2; ++o)
        for (std::size_t s = 0; s < 2; ++s)
          for (std::size_t v = 0; v < 4; ++v)
            EXPECT_EQ(sky.at(c, o, s, v), alone[order[c]].at(0, o, s, v)) << c << o << s << v;
  }
}

TEST(Independence, ProgressIsReportedToTheEnd) {
  std::size_t last = 0;
  std::size_t whole = 0;
  Context context = test::context;
  context.progress = [&](std::string_view stage, std::size_t done, std::size_t all) {
    EXPECT_EQ(stage, "solving the radiative transfer");
    EXPECT_GT(done, last);
    last = done;
    whole = all;
  };
  solve_sky_radiance(context, test::earth(), std::span(columns()).first(3), kRequest, {});
  EXPECT_EQ(last, whole);
  EXPECT_GT(whole, 0u);
}

TEST(Independence, StopsWhenAsked) {
  for (const std::size_t stop_at : {0u, 1u, 2u}) {
    std::stop_source stop;
    Context context = test::on_threads(1);
    context.cancel = stop.get_token();
    std::size_t steps = 0;
    context.progress = [&](std::string_view, std::size_t, std::size_t) {
      if (++steps == stop_at) stop.request_stop();
    };
    if (stop_at == 0) stop.request_stop();
    EXPECT_THROW(solve_sky_radiance(context, test::earth(), columns(), kRequest, {}), Cancelled) << stop_at;
    EXPECT_EQ(steps, stop_at);
  }
}

TEST(Independence, ReportsHowItWasSolved) {
  const SkyRadiance portable = solve_sky_radiance(test::with_simd(Simd::portable), test::earth(),
                                                  std::span(columns()).first(3), kRequest, {});
  EXPECT_EQ(portable.report().kernel, "portable");
  EXPECT_EQ(portable.report().lanes, 4);
  EXPECT_GE(portable.report().blocks, 1u);
  EXPECT_GT(portable.report().iterations_most, 3);
  EXPECT_LT(portable.report().iterations_most, 30);
  EXPECT_GT(portable.report().error_left, 0.0);
  EXPECT_LE(portable.report().error_left, 1.001e-3);
  EXPECT_GT(portable.report().cpu_s, 0.0);
}

}  // namespace
}  // namespace skylut
