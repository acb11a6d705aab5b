#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "skylut/cases/solve_case.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/json_reader.hpp"
#include "skylut/scattering/phase_function.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

using Json = nlohmann::ordered_json;

Json own_case(const std::string& name) {
  return read_json_file(SKYLUT_TEST_DATA "/solver_cases/" + name + ".json");
}

Json solved(const Json& document, const SolveOptions& options = {}) {
  return solve_case(test::context, document, "case.json", options);
}

/// I, Q and U within a share of I.
void expect_stokes(const Json& ours, const Json& theirs, double share, const std::string& name) {
  ASSERT_EQ(ours["results"].size(), theirs["results"].size());
  for (std::size_t i = 0; i < theirs["results"].size(); ++i) {
    const Json& result = theirs["results"][i];
    const double error = share * result["radiance"].get<double>();
    for (const char* key : {"radiance", "stokes_q", "stokes_u"}) {
      if (!result.contains(key)) continue;
      EXPECT_NEAR(ours["results"][i][key].get<double>(), result[key].get<double>(), error)
          << name << ", result " << i << ", " << key;
    }
  }
}

TEST(PolarisedCase, PublishedAndOwn) {
  expect_stokes(solved(own_case("pol_natraj2009_sza78_ground")), own_case("pol_natraj2009_sza78_ground"),
                1e-6, "Natraj");
  const Json haze = solved(own_case("pol_haze_table_sza40_alt00"));
  expect_stokes(haze, own_case("pol_haze_table_sza40_alt00"), 1e-6, "haze");
  EXPECT_EQ(haze["results"][0]["std_q"], 0.0);
  EXPECT_FALSE(haze.contains("not_used"));
}

TEST(PolarisedCase, SharedReferences) {
  const std::filesystem::path folder = std::filesystem::path(SKYLUT_SHARED_REFERENCE) / "vector";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no shared reference set";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const Json reference = read_json_file(entry.path().string());
    expect_stokes(solved(reference), reference, 1e-5, entry.path().filename().string());
  }
}

/// A case of one layer whose aerosol has Rayleigh's matrix in that form.
Json rayleigh_case(const char* key, Json matrix) {
  Json document = own_case("pol_haze_table_sza40_alt00");
  document["levels_km"] = {0.0, 1.0};
  document["layers"] = Json::array({{{"tau_rayleigh", 0.0},
                                     {"tau_aerosol", 0.4},
                                     {"ssa_aerosol", 1.0},
                                     {"g_aerosol", 0.0},
                                     {"tau_absorption", 0.0}}});
  document["layers"][0][key] = std::move(matrix);
  return document;
}

// The same air three ways.
TEST(PolarisedCase, RayleighAsTableAndAsMoments) {
  const RayleighPhaseFunction air(0.03);
  Json table{{"theta_deg", Json::array()}, {"f11", {}}, {"f12", {}}, {"f22", {}}, {"f33", {}}, {"f34", {}}};
  for (int degree = 0; degree <= 180; ++degree) {
    const ScatteringMatrix at = air.matrix(std::cos(degree * kRadiansPerDegree));
    table["theta_deg"].push_back(degree);
    table["f11"].push_back(at.f11);
    table["f12"].push_back(at.f12);
    table["f22"].push_back(at.f22);
    table["f33"].push_back(at.f33);
    table["f34"].push_back(0.0);
  }
  Json moments{{"alpha1", {}}, {"alpha2", {}}, {"alpha3", {}}, {"beta1", {}}};
  for (const MatrixMoments& moment : air.matrix_moments(2)) {
    moments["alpha1"].push_back(moment.alpha1);
    moments["alpha2"].push_back(moment.alpha2);
    moments["alpha3"].push_back(moment.alpha3);
    moments["beta1"].push_back(moment.beta1);
  }
  Json molecules = rayleigh_case("tau_rayleigh", 0.4);
  molecules["layers"][0]["tau_aerosol"] = 0.0;
  molecules["rayleigh_depolarisation"] = 0.03;
  const Json expected = solved(molecules);
  expect_stokes(solved(rayleigh_case("matrix_moments_aerosol", moments)), expected, 1e-12, "moments");
  const Json from_table = solved(rayleigh_case("phase_matrix_aerosol", table));
  expect_stokes(from_table, expected, 1e-6, "table");
  EXPECT_EQ(from_table["not_used"], Json({"layers[].phase_matrix_aerosol.f34"}));
}

TEST(PolarisedCase, TheOtherSideOfTheSunHasTheOtherU) {
  Json document = own_case("pol_natraj2009_sza78_ground");
  const Json one = solved(document);
  document["results"][1]["relative_azimuth_deg"] = 270.0;
  const Json other = solved(document);
  EXPECT_EQ(one["results"][1]["stokes_q"], other["results"][1]["stokes_q"]);
  EXPECT_EQ(one["results"][1]["stokes_u"].get<double>(), -other["results"][1]["stokes_u"].get<double>());
}

TEST(PolarisedCase, OutputsAtOpticalDepths) {
  Json document = own_case("disort_3a");
  const Json scalar = solved(document);
  document["polarised"] = true;
  const Json vector = solved(document);
  EXPECT_FALSE(scalar["outputs"].contains("stokes_q"));
  EXPECT_EQ(vector["outputs"]["stokes_q"].size(), vector["outputs"]["radiance"].size());
  EXPECT_EQ(vector["outputs"]["stokes_u"][0].size(), vector["outputs"]["radiance"][0].size());
}

TEST(PolarisedCase, RefusesWrongMatrices) {
  const auto expect_refused = [](const char* what, const auto& change,
                                 const std::vector<std::string>& words) {
    Json document = own_case("pol_haze_table_sza40_alt00");
    change(document, document["layers"][0]["phase_matrix_aerosol"]);
    try {
      solved(document);
      ADD_FAILURE() << what << " was not refused";
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_NE(message.find("case.json"), std::string::npos) << message;
      for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << message;
    }
  };
  expect_refused("text", [](Json& c, Json&) { c["polarised"] = "yes"; },
                 {"polarised", "yes", "true or false"});
  expect_refused("first angle", [](Json&, Json& m) { m["theta_deg"][0] = 1.0; },
                 {"layers[0]", "1", "begin at 0"});
  expect_refused("order", [](Json&, Json& m) { m["theta_deg"][3] = 4.0; }, {"angle 4", "greater than 4"});
  expect_refused("negative", [](Json&, Json& m) { m["f11"][9] = -0.1; },
                 {"f11", "-0.1", "18 degrees", "greater than 0"});
  expect_refused("too polarised", [](Json&, Json& m) { m["f12"][45] = -9.0; },
                 {"f12", "-9", "90 degrees", "f11"});
  expect_refused("length", [](Json&, Json& m) { m["f33"].erase(0); }, {"f33", "90 values", "91"});
  expect_refused("missing", [](Json&, Json& m) { m.erase("f12"); }, {"f12", "missing"});
  expect_refused("unknown", [](Json&, Json& m) { m["f21"] = Json::array({0.0}); }, {"f21", "unknown"});
  expect_refused("normalisation",
                 [](Json&, Json& m) {
                   for (Json& value : m["f11"]) value = 2.0 * value.get<double>();
                 },
                 {"integral of f11", "2", "must be 1"});
  expect_refused("two forms",
                 [](Json& c, Json&) { c["layers"][0]["phase_moments_aerosol"] = Json::array({1.0}); },
                 {"layers[0]", "phase_moments_aerosol", "phase_matrix_aerosol"});
  expect_refused(
      "moments",
      [](Json& c, Json&) {
        c["layers"][0].erase("phase_matrix_aerosol");
        c["layers"][0]["matrix_moments_aerosol"] =
            Json{{"alpha1", {1.0, 0.5}}, {"alpha2", {0.0, 0.0}}, {"alpha3", {0.0, 0.0}}, {"beta1", {0.0}}};
      },
      {"beta1", "1 moments", "2"});
}

}  // namespace
}  // namespace skylut
