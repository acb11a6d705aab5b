#include "skylut/cases/solve_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "skylut/core/errors.hpp"
#include "skylut/core/json_reader.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

using Json = nlohmann::ordered_json;

Json own_case(const std::string& name) {
  return read_json_file(SKYLUT_TEST_DATA "/solver_cases/" + name + ".json");
}

std::vector<std::string> shared_cases(const std::string& folder, const std::string& prefix) {
  std::vector<std::string> found;
  const std::filesystem::path path = std::filesystem::path(SKYLUT_SHARED_REFERENCE) / folder;
  if (!std::filesystem::is_directory(path)) return found;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (entry.path().filename().string().starts_with(prefix)) found.push_back(entry.path().string());
  return found;
}

void flatten(const Json& value, std::vector<double>& numbers) {
  if (value.is_array())
    for (const Json& element : value) flatten(element, numbers);
  else
    numbers.push_back(value.get<double>());
}

/// Largest relative difference over values above 1e-6 of the largest.
double largest_difference(const Json& ours, const Json& theirs) {
  std::vector<double> a;
  std::vector<double> b;
  flatten(ours, a);
  flatten(theirs, b);
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (double value : b) largest = std::max(largest, std::abs(value));
  double difference = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (b[i] > 1e-6 * largest) difference = std::max(difference, std::abs(a[i] / b[i] - 1.0));
  return difference;
}

// The references converge to about 1e-5 (64 streams; six to eight digits printed).
constexpr double kReferenceError = 2e-5;

void expect_optical_depth_case(const Json& reference, const std::string& name) {
  const Json ours = solve_case(test::context, reference, name, {});
  EXPECT_LT(largest_difference(ours["outputs"]["radiance"], reference["outputs"]["radiance"]),
            kReferenceError)
      << name;
  for (const char* flux : {"flux_direct", "flux_down_diffuse", "flux_up"})
    EXPECT_LT(largest_difference(ours["outputs"][flux], reference["outputs"][flux]), kReferenceError) << name;
}

void expect_plane_case(const Json& reference, const std::string& name) {
  const Json ours = solve_case(test::context, reference, name, {});
  for (std::size_t i = 0; i < reference["results"].size(); ++i) {
    const double expected = reference["results"][i]["radiance"].get<double>();
    EXPECT_NEAR(ours["results"][i]["radiance"].get<double>(), expected, kReferenceError * expected + 1e-9)
        << name;
    EXPECT_EQ(ours["results"][i]["std"].get<double>(), 0.0);
  }
  for (const char* flux : {"direct_down", "diffuse_down", "diffuse_up"})
    EXPECT_NEAR(ours["fluxes"][flux].get<double>(), reference["fluxes"][flux].get<double>(), 1e-6) << name;
}

TEST(SolveCase, OpticalDepthCases) {
  for (const char* name : {"disort_3a", "disort_atm_rayleigh_aerosol_550nm_sza60"})
    expect_optical_depth_case(own_case(name), name);
}

TEST(SolveCase, PlaneLayers) {
  for (const char* name : {"pp_E_multilayer_sza45_ground", "pp_C_homogeneous_sza45_toa"})
    expect_plane_case(own_case(name), name);
}

// χ² of ours against the other Monte Carlo's over all directions of the case.
TEST(SolveCase, MonteCarloAgreesWithTheReferenceMonteCarlo) {
  SolveOptions options;
  options.method = SolveMethod::monte_carlo;
  options.photons = 40'000;
  double sum = 0.0;
  double count = 0.0;
  for (const char* name : {"sph_B_sza60_alt00", "sph_A_alb03_sza88_alt30"}) {
    const Json reference = own_case(name);
    const Json ours = solve_case(test::context, reference, name, options);
    for (std::size_t i = 0; i < reference["results"].size(); ++i) {
      const Json& a = ours["results"][i];
      const Json& b = reference["results"][i];
      const double error = std::hypot(a["std"].get<double>(), b["std"].get<double>());
      sum += std::pow((a["radiance"].get<double>() - b["radiance"].get<double>()) / error, 2);
      count += 1.0;
    }
  }
  // χ² of n directions has the mean n and the standard deviation √(2n); four of them.
  EXPECT_LT(sum, count + 4.0 * std::sqrt(2.0 * count));
}

// I, Q and U of another vector Monte Carlo, in Rayleigh air: χ² over all directions; no direction off by 1 %
// of I and 3 σ.
TEST(SolveCase, PolarisedMonteCarloAgreesWithTheReference) {
  auto cases = shared_cases("vector_spherical", "pol_");
  const auto more = shared_cases("solver", "pol_");
  cases.insert(cases.end(), more.begin(), more.end());
  if (cases.empty()) GTEST_SKIP() << "no shared reference set";
  SolveOptions options;
  options.method = SolveMethod::monte_carlo;
  options.photons = 40'000;
  double sum = 0.0;
  double count = 0.0;
  for (const std::string& path : cases) {
    const Json reference = read_json_file(path);
    const Json ours = solve_case(test::context, reference, path, options);
    for (std::size_t i = 0; i < reference["results"].size(); ++i) {
      const Json& a = ours["results"][i];
      const Json& b = reference["results"][i];
      for (const auto& [value, deviation] :
           {std::pair{"radiance", "std"}, std::pair{"stokes_q", "std_q"}, std::pair{"stokes_u", "std_u"}}) {
        const double error = std::hypot(a[deviation].get<double>(), b[deviation].get<double>());
        const double difference = a[value].get<double>() - b[value].get<double>();
        EXPECT_LE(std::abs(difference), std::max(4.0 * error, 0.01 * b["radiance"].get<double>()))
            << path << i;
        sum += std::pow(difference / error, 2);
        count += 1.0;
      }
    }
  }
  EXPECT_LT(sum, count + 4.0 * std::sqrt(2.0 * count));
}

// The other side of the sun is a mirror image: U changes its sign.
TEST(SolveCase, StokesUIsOddInAzimuth) {
  SolveOptions options;
  options.method = SolveMethod::monte_carlo;
  options.photons = 500;
  Json one = own_case("sph_B_sza60_alt00");
  one["polarised"] = true;
  one["results"] = {{{"view_zenith_deg", 40.0}, {"relative_azimuth_deg", 70.0}},
                    {{"view_zenith_deg", 40.0}, {"relative_azimuth_deg", 290.0}}};
  const Json ours = solve_case(test::context, one, "case", options)["results"];
  EXPECT_NE(ours[0]["stokes_u"].get<double>(), 0.0);
  EXPECT_EQ(ours[0]["stokes_u"].get<double>(), -ours[1]["stokes_u"].get<double>());
  EXPECT_EQ(ours[0]["stokes_q"], ours[1]["stokes_q"]);
  EXPECT_EQ(ours[0]["std_u"], ours[1]["std_u"]);
}

TEST(SolveCase, SharedPlaneReferences) {
  const auto plane = shared_cases("solver", "pp_");
  const auto depth = shared_cases("disort", "disort_");
  if (plane.empty() && depth.empty()) GTEST_SKIP() << "no shared reference set";
  for (const std::string& path : plane) expect_plane_case(read_json_file(path), path);
  for (const std::string& path : depth) expect_optical_depth_case(read_json_file(path), path);
}

TEST(SolveCase, KeepsKeysAndTheirOrder) {
  const Json reference = own_case("pp_C_homogeneous_sza45_toa");
  const Json ours = solve_case(test::context, reference, "case", {});
  auto theirs = reference.items().begin();
  for (const auto& [key, value] : ours.items()) {
    EXPECT_EQ(key, theirs.key());
    ++theirs;
  }
  EXPECT_EQ(ours["layers"], reference["layers"]);
  EXPECT_TRUE(ours["reference"].get<std::string>().starts_with("skylut"));
}

/// A case with one thing changed must be refused in one line that holds all of `words`.
struct Refusal {
  const char* what;
  void (*change)(Json&);
  std::vector<std::string> words;
};

template <typename Error>
void expect_refused(const std::string& name, const Refusal& refusal, const SolveOptions& options = {}) {
  Json changed = own_case(name);
  refusal.change(changed);
  try {
    solve_case(test::context, changed, "case.json", options);
    ADD_FAILURE() << refusal.what << " was not refused";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("case.json"), std::string::npos) << message;
    for (const std::string& word : refusal.words) EXPECT_NE(message.find(word), std::string::npos) << message;
  }
}

TEST(SolveCase, RefusesWrongSkies) {
  const std::vector<Refusal> refusals = {
      {"geometry", [](Json& c) { c["geometry"] = "cylinder"; }, {"geometry", "cylinder", "spherical"}},
      {"no albedo", [](Json& c) { c.erase("albedo"); }, {"albedo", "missing"}},
      {"albedo", [](Json& c) { c["albedo"] = 1.2; }, {"albedo", "1.2", "0-1"}},
      {"levels", [](Json& c) { c["levels_km"][2] = 0.5; }, {"levels_km[2]", "0.5", "above"}},
      {"first level", [](Json& c) { c["levels_km"][0] = 0.1; }, {"levels_km", "0"}},
      {"too few layers", [](Json& c) { c["layers"].erase(0); }, {"layers", "37", "39"}},
      {"depth",
       [](Json& c) { c["layers"][3]["tau_rayleigh"] = -0.1; },
       {"layers[3]", "tau_rayleigh", "-0.1"}},
      {"depth null", [](Json& c) { c["layers"][3]["tau_aerosol"] = nullptr; }, {"layers[3]", "null"}},
      {"depth text", [](Json& c) { c["layers"][0]["tau_aerosol"] = "much"; }, {"layers[0]", "much"}},
      {"ssa", [](Json& c) { c["layers"][0]["ssa_aerosol"] = 1.01; }, {"ssa_aerosol", "1.01", "0-1"}},
      {"g", [](Json& c) { c["layers"][0]["g_aerosol"] = 1.0; }, {"g_aerosol", "1"}},
      {"unknown key", [](Json& c) { c["layers"][0]["tau_cloud"] = 1.0; }, {"tau_cloud", "unknown"}},
      {"missing key", [](Json& c) { c["layers"][0].erase("g_aerosol"); }, {"g_aerosol", "missing"}},
      {"view", [](Json& c) { c["results"][1]["view_zenith_deg"] = 181; }, {"results[1]", "181", "0-180"}},
      {"observer high",
       [](Json& c) { c["observer_altitude_km"] = 101; },
       {"observer_altitude_km", "101", "0-100"}},
      {"observer low", [](Json& c) { c["observer_altitude_km"] = -1; }, {"observer_altitude_km", "-1"}},
      {"sun", [](Json& c) { c["sun_zenith_deg"] = 100; }, {"sun_zenith_deg", "100", "99"}},
      {"radius", [](Json& c) { c["planet_radius_km"] = nullptr; }, {"planet_radius_km", "null"}},
      {"small planet",
       [](Json& c) { c["planet_radius_km"] = 999.0; },
       {"planet_radius_km: 999.0 must be a number within 1000-1000000000 km"}},
      {"results", [](Json& c) { c.erase("results"); }, {"results", "outputs"}},
      {"no layers", [](Json& c) { c["layers"] = Json::array(); }, {"layers", "at least one"}},
      {"both phases",
       [](Json& c) {
         c["layers"][0] = Json{{"tau", 1}, {"ssa", 1}, {"g_hg", 0}, {"phase_moments", {1}}};
       },
       {"layers[0]", "phase_moments", "g_hg"}},
      {"moments",
       [](Json& c) {
         c["layers"][0] = Json{{"tau", 1}, {"ssa", 1}, {"phase_moments", {0.9}}};
       },
       {"phase_moments", "first"}},
  };
  for (const Refusal& refusal : refusals) expect_refused<InputError>("sph_B_sza60_alt00", refusal);
}

TEST(SolveCase, RefusesWrongPlaneCases) {
  const std::vector<Refusal> skies = {
      {"sun at the horizon", [](Json& c) { c["sun_zenith_deg"] = 90; }, {"sun_zenith_deg", "90", "below 90"}},
      {"horizontal view",
       [](Json& c) { c["results"][0]["view_zenith_deg"] = 90; },
       {"view_zenith_deg", "90"}}};
  for (const Refusal& refusal : skies) expect_refused<InputError>("pp_C_homogeneous_sza45_toa", refusal);
  const std::vector<Refusal> depths = {
      {"umu", [](Json& c) { c["outputs"]["umu"][0] = 0.0; }, {"umu[0]", "0"}},
      {"tau", [](Json& c) { c["outputs"]["taus"][1] = 1.5; }, {"taus[1]", "1.5"}},
      {"mu0", [](Json& c) { c["beam"]["mu0"] = 0.0; }, {"mu0", "0"}},
      {"flux", [](Json& c) { c["beam"]["flux"] = -1.0; }, {"flux", "-1"}},
      {"order", [](Json& c) { c["layer_order"] = "bottom to top"; }, {"layer_order", "top to bottom"}},
      {"geometry", [](Json& c) { c["geometry"] = "spherical"; }, {"geometry", "spherical", "plane-parallel"}},
      {"top light", [](Json& c) { c.erase("isotropic_top"); }, {"isotropic_top", "missing"}}};
  for (const Refusal& refusal : depths) expect_refused<InputError>("disort_3a", refusal);
}

TEST(SolveCase, SaysWhatItCannotDo) {
  SolveOptions monte_carlo;
  monte_carlo.method = SolveMethod::monte_carlo;
  expect_refused<WorkError>(
      "disort_3a", {"plane Monte Carlo", [](Json&) {}, {"Monte Carlo", "plane-parallel"}}, monte_carlo);
  SolveOptions first_order;
  first_order.orders = 1;
  expect_refused<WorkError>("disort_3a", {"orders", [](Json&) {}, {"orders"}}, first_order);
}

TEST(SolveCase, ReadsJsonStrictly) {
  EXPECT_THROW(read_json_file("/nonexistent.json"), InputError);
  EXPECT_THROW(read_json_file(SKYLUT_TEST_DATA), InputError);
  EXPECT_THROW(read_json_file(SKYLUT_TEST_DATA "/garcia_siewert_1985_moments.csv"), InputError);
}

}  // namespace
}  // namespace skylut
