#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/models/model_file.hpp"
#include "skylut/models/perez_rows_model.hpp"
#include "skylut/models/preetham1999.hpp"
#include "skylut/models/preetham_model.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

ModelInfo info_of(const Range& altitude_km, const Range& turbidity, const Range& sun_deg) {
  ModelInfo info;
  info.title = "test";
  info.quantities = "Y, x, y";
  info.altitude_km = altitude_km;
  info.turbidity = turbidity;
  info.sun_zenith_deg = sun_deg;
  info.view_zenith_deg = {0.0, 90.0, "deg"};
  return info;
}

PerezRow row_at(double altitude_km, double sun_deg, double Y) {
  const PerezCoefficients k{-1.0, -0.3, 4.0, -2.0, 0.2};
  return {altitude_km,
          0.1,
          sun_deg,
          {k, {0.1, -0.4, 0.2, -1.0, 0.1}, {0.1, -0.4, 0.2, -1.0, 0.1}},
          {Y, 0.3, 0.31}};
}

std::string text_of(const nlohmann::ordered_json& model, const ModelInfo& info, const std::string& form) {
  return model_file_json({.form = form, .info = info, .error = {}, .model = model}, Provenance("skylut fit"));
}

std::string refusal_of(const std::string& text) {
  const fs::path path = fs::path(testing::TempDir()) / "fitted_models_test.json";
  std::ofstream(path) << text;
  try {
    read_model_file(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PreethamMatrices, AreThePublishedNumbersToTheLastBit) {
  for (const double T : {1.0, 2.0, 3.7, 6.0}) {
    const PerezYxy k = preetham1999_coefficients(T);
    EXPECT_EQ(k.Y, (PerezCoefficients{0.1787 * T - 1.4630, -0.3554 * T + 0.4275, -0.0227 * T + 5.3251,
                                      0.1206 * T - 2.5771, -0.0670 * T + 0.3703}));
    EXPECT_EQ(k.y.D, -0.0441 * T - 1.6537);
    const double sun = 1.1;
    const double chi = (4.0 / 9.0 - T / 120.0) * (kPi - 2.0 * sun);
    EXPECT_EQ(preetham1999_zenith_kcd_m2(T, sun).Y,
              (4.0453 * T - 4.9710) * std::tan(chi) - 0.2155 * T + 2.4192);
  }
}

TEST(PreethamModel, WithThePublishedMatricesIsPreetham1999) {
  const PreethamModel model(Preetham1999().info(), {{0.0, preetham1999_matrices()}});
  const SkyConditions conditions{.turbidity = {TurbidityKind::preetham_t, 3.3}, .sun = {52.0, 40.0}};
  for (const Direction& view : {Direction{0.0, 0.0}, Direction{50.0, 44.0}, Direction{90.0, 200.0}}) {
    const Yxy here = model.at(conditions)->colour(view);
    const Yxy there = Preetham1999().at(conditions)->colour(view);
    EXPECT_NEAR(here.Y / there.Y, 1.0, 1e-13);
    EXPECT_NEAR(here.x, there.x, 1e-14);
    EXPECT_NEAR(here.y, there.y, 1e-14);
  }
}

TEST(PerezRows, BlendLogarithmsBetweenNodes) {
  const PerezRowsModel model(info_of({0.0, 4.0, "km"}, {0.1, 0.1, ""}, {30.0, 50.0, "deg"}), {},
                             {row_at(0.0, 30.0, 4000.0), row_at(4.0, 30.0, 1000.0), row_at(0.0, 50.0, 3000.0),
                              row_at(4.0, 50.0, 500.0)});
  ASSERT_TRUE(model.fills_a_grid());
  const auto zenith = [&](double altitude_km, double sun_deg) {
    return model.at({altitude_km, {TurbidityKind::aod500, 0.1}, 0.2, {sun_deg, 10.0}})->colour(Direction{}).Y;
  };
  EXPECT_NEAR(zenith(0.0, 30.0), 4000.0, 1e-9);
  EXPECT_NEAR(zenith(2.0, 30.0), 2000.0, 1e-9);
  // Each neighbour's formula is taken at the angle to the sun that is asked for.
  const PerezCoefficients k{-1.0, -0.3, 4.0, -2.0, 0.2};
  const auto at = [&](double Y, double node_deg) {
    return Y * perez(k, 0.0, 40.0 * kRadiansPerDegree) / perez(k, 0.0, node_deg * kRadiansPerDegree);
  };
  EXPECT_NEAR(zenith(0.0, 40.0), std::sqrt(at(4000.0, 30.0) * at(3000.0, 50.0)), 1e-9);
  EXPECT_THROW(zenith(4.5, 40.0), InputError);
}

TEST(PerezRows, WithoutAGridHaveOnlyTheirOwnConditions) {
  const PerezRowsModel model(info_of({0.0, 4.0, "km"}, {0.1, 0.1, ""}, {30.0, 50.0, "deg"}), {},
                             {row_at(0.0, 30.0, 4000.0), row_at(4.0, 50.0, 500.0)});
  EXPECT_FALSE(model.fills_a_grid());
  EXPECT_NO_THROW(model.at({4.0, {TurbidityKind::aod500, 0.1}, 0.2, {50.0, 0.0}}));
  EXPECT_THROW(model.at({4.0, {TurbidityKind::aod500, 0.1}, 0.2, {30.0, 0.0}}), InputError);
}

TEST(PerezRows, OfBandsHaveSpectraAndTheColoursOfTheirWeights) {
  SkyChannels channels{.kind = SkyChannels::Kind::bands,
                       .wavelengths = WavelengthGrid(400.0, 500.0, 50.0),
                       .colour_weights = {{1.0, 0.0, 4.0}, {0.0, 2.0, 1.0}, {2.0, 3.0, 0.0}}};
  const PerezRowsModel model(info_of({0.0, 0.0, "km"}, {0.1, 0.1, ""}, {30.0, 30.0, "deg"}), channels,
                             {row_at(0.0, 30.0, 0.2)});
  const auto sky = model.at({0.0, {TurbidityKind::aod500, 0.1}, 0.2, {30.0, 0.0}});
  ASSERT_NE(sky->wavelengths(), nullptr);
  std::array<float, 3> spectrum{};
  const std::array zenith{Direction{}};
  sky->radiance(zenith, spectrum);
  EXPECT_NEAR(spectrum[0], 0.2, 1e-7);
  EXPECT_NEAR(spectrum[2], 0.31, 1e-7);
  EXPECT_NEAR(sky->colour(Direction{}).Y, 2.0 * 0.3 + 3.0 * 0.31, 1e-9);
}

TEST(ModelFiles, AreRefusedInOneLineThatSaysWhatWouldBeRight) {
  const ModelInfo info = info_of({0.0, 0.0, "km"}, {0.1, 0.1, ""}, {30.0, 30.0, "deg"});
  const nlohmann::ordered_json good = PerezRowsModel::json({}, {row_at(0.0, 30.0, 4000.0)});
  EXPECT_EQ(refusal_of(text_of(good, info, "perez")), "");
  nlohmann::ordered_json bad = good;
  bad["rows"][0]["ABCDE"][1][1] = 0.1;
  EXPECT_NE(refusal_of(text_of(bad, info, "perez")).find("must have B < 0"), std::string::npos);
  bad = good;
  bad["rows"].push_back(bad["rows"][0]);
  EXPECT_NE(refusal_of(text_of(bad, info, "perez")).find("rows 1 and 2 have the same"), std::string::npos);
  bad = good;
  bad["channels"]["kind"] = "RGB";
  EXPECT_NE(refusal_of(text_of(bad, info, "perez")).find("must be Yxy, XYZ or bands"), std::string::npos);
  EXPECT_NE(refusal_of(text_of(good, info, "prez")).find("form 'prez': must be one of perez"),
            std::string::npos);
  EXPECT_NE(refusal_of("{\"format\": \"skylut table\"}").find("must be a model file"), std::string::npos);
}

}  // namespace
}  // namespace skylut
