#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sky_cases.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

const double kNan = std::nan("");

/// A small request that is right; every test spoils one thing.
struct Question {
  Shells shells{{0.0, 2.0, 10.0}, 6371.0};
  OpticalColumn column{{0.1, 0.1}, {{std::make_shared<const RayleighPhaseFunction>(), {0.1, 0.05}}}, 0.2};
  SkyRequest request{{1.0}, {30.0}, {{60.0, 90.0}}};
};

/// The refusal must name the wrong value and say what is right, in one line.
void expect_refused(const Question& question, const std::string& value, const std::string& rule) {
  try {
    test::solve(question.shells, question.column, question.request);
    ADD_FAILURE() << "not refused: " << value << ", " << rule;
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(value), std::string::npos) << message;
    EXPECT_NE(message.find(rule), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

template <class Spoil>
Question spoiled(const Spoil& spoil) {
  Question question;
  spoil(question);
  return question;
}

TEST(SkyRequestErrors, TheRequestItselfIsRight) {
  const Question question;
  EXPECT_NO_THROW(test::solve(question.shells, question.column, question.request));
}

TEST(SkyRequestErrors, Observers) {
  for (const auto& [altitude, text] :
       {std::pair{1.1e6, "1100000"}, {-0.1, "-0.1"}, {kNan, "nan"}, {INFINITY, "inf"}})
    expect_refused(spoiled([&](Question& q) {
                     q.request.observer_altitudes_km = {1.0, altitude};
                   }),
                   text, "0 to 1000000 km");
}

TEST(SkyRequestErrors, Suns) {
  for (const auto& [sun, text] : {std::pair{100.0, "100"}, {-1.0, "-1"}, {kNan, "nan"}})
    expect_refused(spoiled([&](Question& q) { q.request.sun_zeniths_deg = {30.0, sun}; }), text, "0 to 99");
}

// Most of the scattering in a peak of a degree: right overhead, refused at the horizon.
TEST(SkyRequestErrors, SharpPeaksAtTheHorizon) {
  Question question;
  question.column.scatterers = {{std::make_shared<const HenyeyGreensteinPhaseFunction>(0.95), {0.1, 0.05}}};
  EXPECT_NO_THROW(test::solve(question.shells, question.column, question.request));
  question.request.views = {{60.0, 90.0}, {89.9, 0.0}};
  expect_refused(question, "89.9", "34 %");
}

TEST(SkyRequestErrors, Views) {
  for (const auto& [zenith, text] : {std::pair{181.0, "181"}, {-5.0, "-5"}, {kNan, "nan"}})
    expect_refused(spoiled([&](Question& q) { q.request.views.push_back({zenith, 0.0}); }), text, "0-180");
  for (const auto& [azimuth, text] : {std::pair{270.0, "270"}, {-5.0, "-5"}, {kNan, "nan"}})
    expect_refused(spoiled([&](Question& q) { q.request.views.push_back({0.0, azimuth}); }), text, "0-180");
}

TEST(SkyRequestErrors, Levels) {
  expect_refused(spoiled([](Question& q) { q.shells.levels_km = {0.0, 10.0, 2.0}; }), "2 after 10", "ascend");
  expect_refused(spoiled([](Question& q) { q.shells.levels_km = {0.0, 2.0, 2.0}; }), "2 after 2", "ascend");
  expect_refused(spoiled([](Question& q) { q.shells.levels_km = {0.0, 2.0, kNan}; }), "nan", "ascend");
  expect_refused(spoiled([](Question& q) { q.shells.levels_km = {0.0, 2.0, INFINITY}; }), "inf", "ascend");
  expect_refused(spoiled([](Question& q) {
                   q.shells.levels_km = {1.0, 2.0, 3.0};
                 }),
                 "levels_km", "the first at 0");
  expect_refused(spoiled([](Question& q) { q.shells.levels_km = {0.0}; }), "levels_km", "at least two");
  expect_refused(spoiled([](Question& q) { q.shells.levels_km = {}; }), "levels_km", "at least two");
  expect_refused(spoiled([](Question& q) { q.shells.levels_km = {0.0, 1e300}; }), "1e+300", "0 to 10000 km");
}

TEST(SkyRequestErrors, Planets) {
  for (const auto& [radius, text] :
       {std::pair{999.0, "999"}, {-6371.0, "-6371"}, {kNan, "nan"}, {INFINITY, "inf"}})
    expect_refused(spoiled([&](Question& q) { q.shells.planet_radius_km = radius; }), text,
                   "1000 to 1000000000 km");
}

TEST(SkyRequestErrors, Layers) {
  expect_refused(spoiled([](Question& q) { q.column.extinction_depth.push_back(0.1); }), "3 layers",
                 "give 2");
  expect_refused(spoiled([](Question& q) { q.column.scatterers[0].scattering_depth.pop_back(); }), "1 layers",
                 "give 2");
  expect_refused(spoiled([](Question& q) { q.column.extinction_depth[1] = kNan; }), "nan", "layer 1");
  expect_refused(spoiled([](Question& q) { q.column.extinction_depth[1] = INFINITY; }), "inf", "layer 1");
  expect_refused(spoiled([](Question& q) { q.column.extinction_depth[0] = 0.05; }), "0.05",
                 "at least the scattering's, 0.1");
  expect_refused(spoiled([](Question& q) { q.column.scatterers[0].scattering_depth[0] = -0.05; }), "-0.05",
                 ">= 0");
  expect_refused(spoiled([](Question& q) { q.column.scatterers[0].scattering_depth[1] = kNan; }), "nan",
                 ">= 0");
}

/// A phase function that holds one wrong moment.
class Broken final : public PhaseFunction {
 public:
  Broken(int at, double moment) : at_(at), moment_(moment) {}
  double value(double) const override { return at_ < 0 ? moment_ : 1.0; }
  double moment(int l) const override { return l == at_ ? moment_ : l == 0 ? 1.0 : 0.0; }

 private:
  int at_;
  double moment_;
};

TEST(SkyRequestErrors, PhaseFunctions) {
  for (const int l : {0, 1, 17, 30})
    expect_refused(
        spoiled([&](Question& q) { q.column.scatterers[0].phase = std::make_shared<const Broken>(l, kNan); }),
        "nan", "within -1 to 1");
  expect_refused(
      spoiled([](Question& q) { q.column.scatterers[0].phase = std::make_shared<const Broken>(2, 1.5); }),
      "1.5", "within -1 to 1");
  expect_refused(spoiled([](Question& q) { q.column.scatterers[0].phase = nullptr; }), "scatterer",
                 "a phase function");
}

// What no check before the work can see does not come out as a radiance either.
TEST(SkyRequestErrors, NoNumberComesOutAsARadiance) {
  Question question;
  question.column.scatterers[0].phase = std::make_shared<const Broken>(-1, kNan);
  EXPECT_THROW(test::solve(question.shells, question.column, question.request), WorkError);
}

TEST(SkyRequestErrors, Options) {
  const Question question;
  const auto refuses = [&](const TransferOptions& options) {
    EXPECT_THROW(solve_sky_radiance(test::context, question.shells, std::span(&question.column, 1),
                                    question.request, options),
                 InputError);
  };
  TransferOptions options;
  options.discretisation.optical_step = 0.0;
  refuses(options);
  options = {};
  options.discretisation.sun_node_density = 5;
  refuses(options);
  options = {};
  options.discretisation.least_polar_nodes = 3;
  refuses(options);
  options = {};
  options.scattering_orders = -1;
  refuses(options);
  options = {};
  options.most_memory_bytes = kNan;
  refuses(options);
}

TEST(SkyRequestErrors, GroundAlbedo) {
  for (const auto& [albedo, text] : {std::pair{1.1, "1.1"}, {-0.1, "-0.1"}, {kNan, "nan"}})
    expect_refused(spoiled([&](Question& q) { q.column.ground_albedo = albedo; }), text, "0-1");
}

}  // namespace
}  // namespace skylut
