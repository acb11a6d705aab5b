#include "skylut/forms/compact_form.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "forms/compact/feature_encoder.hpp"
#include "forms/compact/tensor_compression.hpp"
#include "forms/compact/training_fields.hpp"
#include "forms/compact/training_spectrum.hpp"
#include "skylut/atmosphere/atmosphere_description.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/models/compact_sky.hpp"
#include "skylut/sky/exact_sky.hpp"
#include "support/compact_domain.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

using namespace compact;

SkyScene scene(double albedo) {
  AtmosphereDescription description;
  description.ground_albedo = std::to_string(albedo);
  SkyScene scene;
  scene.atmosphere = std::make_shared<const Atmosphere>(build_atmosphere(test::context, description));
  return scene;
}

/// Few nodes, all of which are asked for below.
const TrainingFields& fields() {
  static const TrainingFields made = [] {
    const SkyScene of = scene(0.2);
    const TrainingSpectrum spectrum(test::context, of, nullptr, {});
    const Nodes nodes{{0.0, 2.0, 10.0, 30.0}, {0.0, 0.005, 0.05, 0.2, 0.5}, {0.0, 40.0, 80.0, 93.0}};
    return training_fields(test::context, of, spectrum, nodes, {14, 12, 8}, 5, {});
  }();
  return made;
}

Tables tables_of(const TrainingFields& fields, double tolerance) {
  Tables tables;
  tables.nodes = fields.nodes;
  tables.planet_radius_km = fields.planet_radius_km;
  tables.zenith_counts = fields.zenith.counts();
  tables.channels = {"X", "Y", "Z"};
  tables.terms = fields.haze->terms();
  tables.haze_terms = fields.haze->functions();
  tables.haze_mean = fields.haze->mean();
  tables.rayleigh_0 = fields.rayleigh_0;
  tables.rayleigh_90 = fields.rayleigh_90;
  tables.spherical_albedo = fields.spherical_albedo;
  compress(fields, tolerance, tables);
  return tables;
}

TEST(CompactForm, IsTheSkyAtItsNodes) {
  // Lines of sight through all bands against the compact sky: what sixteen wavelengths, the azimuths' series,
  // splines in zenith angle and the haze's five functions leave.
  const CompactSkyModel model(test::compact_domain(), tables_of(fields(), 1e-3));
  for (const auto& [albedo, load] : {std::pair(0.2, 0.005), std::pair(0.7, 0.2)}) {
    SkyScene of = scene(albedo);
    of.turbidities = {{TurbidityKind::aod500, load}};
    of.suns = {{40.0, 0.0}, {80.0, 0.0}, {93.0, 0.0}};
    const auto solved = std::make_shared<const SolvedSky>(test::context, of, TransferOptions{});
    for (const double altitude_km : {0.0, 10.0})
      for (const Direction& sun : of.suns) {
        const ExactSky exact(solved, altitude_km, sun);
        const std::vector<Direction> views{{0.0, 0.0},   {30.0, 10.0},  {60.0, 120.0}, {75.0, 0.0},
                                           {85.0, 50.0}, {89.0, 180.0}, {42.0, 0.0},   {130.0, 40.0}};
        std::vector<Xyz> expected(views.size());
        exact.colour(views, expected);
        const auto sky = model.at({altitude_km, of.turbidities.front(), albedo, sun});
        for (std::size_t i = 0; i < views.size(); ++i) {
          const Yxy found = sky->colour(views[i]);
          const Yxy wanted = to_yxy(expected[i]);
          // Opposite a sun below the horizon the Earth's shadow has an edge that the series round off.
          const bool shadow = sun.zenith_deg > 90.0 && views[i].azimuth_deg == 180.0;
          const double bound = shadow ? 0.1 : sun.zenith_deg > 90.0 ? 3e-2 : 6e-3;
          EXPECT_NEAR(found.Y / wanted.Y, 1.0, bound) << altitude_km << ' ' << sun.zenith_deg << ' ' << i;
          EXPECT_NEAR(found.x, wanted.x, bound / 5.0) << altitude_km << ' ' << sun.zenith_deg << ' ' << i;
          EXPECT_NEAR(found.y, wanted.y, bound / 5.0);
        }
      }
  }
}

TEST(CompactForm, CompressionLeavesOutWhatItMay) {
  const Tables fine = tables_of(fields(), 1e-3);
  const Tables coarse = tables_of(fields(), 0.05);
  EXPECT_LT(coarse.rank, fine.rank / 2);
  EXPECT_GT(coarse.step, 5.0 * fine.step);
}

TEST(CompactForm, TheSameBytesWithAnyThreads) {
  SkyScene of = scene(0.2);
  of.wavelengths = WavelengthGrid(400.0, 700.0, 50.0);
  const TrainingSpectrum spectrum(test::context, of, nullptr, {});
  const auto features = [&](int threads) {
    const Nodes nodes{{0.0, 10.0}, {0.2}, {40.0, 80.0}};
    return training_fields(test::on_threads(threads), of, spectrum, nodes, {4, 4, 4}, 2, {}).features;
  };
  EXPECT_EQ(features(1), features(3));
}

TEST(CompactForm, BlackGroundIsNotInItsWeights) {
  const SkyScene black = [] {
    SkyScene of = scene(0.0);
    of.wavelengths = WavelengthGrid(400.0, 700.0, 50.0);
    return of;
  }();
  SkyScene grey = black;
  grey.atmosphere = scene(0.6).atmosphere;
  EXPECT_EQ(TrainingSpectrum(test::context, black, nullptr, {}).weights(),
            TrainingSpectrum(test::context, grey, nullptr, {}).weights());
}

TEST(FeatureEncoder, SeriesOfWhatDoesNotDependOnAzimuth) {
  const Layout layout(3, 2);
  const FeatureEncoder encoder(layout, 1.0);
  SkyRow row;
  row.molecules = Eigen::MatrixXd::Constant(9, 3, 4.0);
  row.haze = {Eigen::MatrixXd::Constant(9, 3, 2.0), Eigen::MatrixXd::Constant(9, 3, -1.0)};
  row.diffuse = Eigen::MatrixXd::Constant(9, 3, 3.0);
  row.ground = Eigen::MatrixXd::Constant(3, 3, 5.0);
  std::vector<float> features(layout.size());
  encoder.encode(row, 0.1, features);
  const double t = 4.0 + 2.0 + 3.0 + 0.2 * 5.0;
  EXPECT_NEAR(features[layout.at(0, layout.brightness())], std::log(t), 1e-6);
  EXPECT_NEAR(features[layout.at(0, layout.molecules(2))], 4.0 / t, 1e-6);
  EXPECT_NEAR(features[layout.at(0, layout.haze(0))], std::log(2.0 / (0.1 * t) + Layout::kFloor), 1e-6);
  EXPECT_NEAR(features[layout.at(0, layout.term(1, 1))], -1.0 / (2.0 + Layout::kFloor * 0.1 * t), 1e-6);
  EXPECT_NEAR(features[layout.at(0, layout.ground(1))], std::log(5.0 / t + 1e-6), 1e-6);
  for (std::size_t m = 1; m < 3; ++m)
    for (std::size_t field = 0; field < layout.fields_of_order(m); ++field)
      EXPECT_NEAR(features[layout.at(m, field)], 0.0, 1e-6);
}

TEST(CompactForm, RefusesWhatItCannotBeAskedFor) {
  CompactFormOptions options;
  options.error = 0.5;
  EXPECT_THROW(fit_compact_sky(test::context, scene(0.2), options, {}), InputError);
  options.error = 0.01;
  options.most_aod500 = 50.0;
  EXPECT_THROW(fit_compact_sky(test::context, scene(0.2), options, {}), InputError);
}

}  // namespace
}  // namespace skylut
