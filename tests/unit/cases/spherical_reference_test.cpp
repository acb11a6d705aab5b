#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "skylut/cases/solve_case.hpp"
#include "skylut/core/json_reader.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

using Json = nlohmann::ordered_json;

/// What the solver must reach at default quality: any direction within max(3σ of the reference, `direction`),
/// RMS with the reference's noise removed below `rms`.
struct Bar {
  double largest_sun_deg;
  double direction;
  double rms;
};
constexpr Bar kBars[] = {{85.0, 0.007, 0.003}, {90.0, 0.01, 0.004}, {92.0, 0.02, 0.008}, {94.0, 0.04, 0.02}};

const Bar& bar_of(double sun_zenith_deg) {
  for (const Bar& bar : kBars)
    if (sun_zenith_deg <= bar.largest_sun_deg) return bar;
  throw std::out_of_range("no bar for this sun");
}

/// Errors of one group of suns against a Monte Carlo reference.
struct Group {
  int directions = 0;
  int beyond = 0;              ///< of max(3σ, bar)
  double squares = 0.0;        ///< of relative errors
  double noise_squares = 0.0;  ///< of the reference's relative σ
  double noise_fourths = 0.0;
};

void compare(const Json& reference, const std::string& name, std::map<double, Group>& groups) {
  const Json ours = solve_case(test::context, reference, name, {});
  const Bar& bar = bar_of(reference["sun_zenith_deg"].get<double>());
  Group& group = groups[bar.largest_sun_deg];
  for (std::size_t i = 0; i < reference["results"].size(); ++i) {
    const Json& view = reference["results"][i];
    const double expected = view["radiance"].get<double>();
    const double noise = view["std"].get<double>() / expected;
    const double error = ours["results"][i]["radiance"].get<double>() / expected - 1.0;
    ++group.directions;
    group.squares += error * error;
    group.noise_squares += noise * noise;
    group.noise_fourths += std::pow(noise, 4);
    if (std::abs(error) > std::max(3.0 * noise, bar.direction)) {
      ++group.beyond;
      std::printf("%s, view %g %g: %+.2f %%, σ %.2f %%\n", name.c_str(),
                  view["view_zenith_deg"].get<double>(), view["relative_azimuth_deg"].get<double>(),
                  100.0 * error, 100.0 * noise);
    }
    // Beyond 4σ is no chance: one in 16,000.
    EXPECT_LT(std::abs(error), std::max(4.0 * noise, bar.direction))
        << name << ", view " << view["view_zenith_deg"] << " " << view["relative_azimuth_deg"];
  }
}

void judge(const std::map<double, Group>& groups) {
  for (const auto& [sun, group] : groups) {
    const double n = group.directions;
    const double rms2 = (group.squares - group.noise_squares) / n;
    std::printf("suns to %g deg: %d directions, %d beyond, RMS %+.2f %%\n", sun, group.directions,
                group.beyond, 100.0 * std::copysign(std::sqrt(std::abs(rms2)), rms2));
    // Of Gaussian errors 0.3 % lie beyond 3σ: one of a hundred directions may.
    EXPECT_LE(group.beyond, 1 + group.directions / 100) << sun;
    // The mean of n squared Gaussian errors varies by √(2 Σσ⁴)/n; three of that.
    const double chance = 3.0 * std::sqrt(2.0 * group.noise_fourths) / n;
    EXPECT_LT(rms2, std::pow(bar_of(sun).rms, 2) + chance) << sun;
  }
}

TEST(SphericalReference, OwnCases) {
  std::map<double, Group> groups;
  for (const char* name : {"sph_B_sza60_alt00", "sph_C_sza85_alt00", "sph_A_alb03_sza88_alt30",
                           "sph_B_sza92_alt12", "sph_D_sza94_alt20"})
    compare(read_json_file(std::string(SKYLUT_TEST_DATA "/solver_cases/") + name + ".json"), name, groups);
  judge(groups);
}

TEST(SphericalReference, SharedCases) {
  // Round-number media with Henyey-Greenstein haze, and real hazes (Mie) seen down to the horizon.
  std::vector<std::filesystem::path> paths;
  for (const char* const set : {"solver", "solver_mie"}) {
    const std::filesystem::path folder = std::filesystem::path(SKYLUT_SHARED_REFERENCE) / set;
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("sph_") || name.starts_with("mie_")) paths.push_back(entry.path());
    }
  }
  if (paths.empty()) GTEST_SKIP() << "no shared reference set";
  std::sort(paths.begin(), paths.end());
  std::map<double, Group> groups;
  for (const auto& path : paths) compare(read_json_file(path), path.stem().string(), groups);
  judge(groups);
}

/// I, Q and U of a polarised case, each within max(3σ, 1 % of I), but for one of a hundred: beyond 4σ is no
/// chance.
void compare_stokes(const Json& reference, const std::string& name) {
  const Json ours = solve_case(test::context, reference, name, {});
  for (std::size_t i = 0; i < reference["results"].size(); ++i) {
    const Json& view = reference["results"][i];
    for (const auto& [value, deviation] :
         {std::pair{"radiance", "std"}, std::pair{"stokes_q", "std_q"}, std::pair{"stokes_u", "std_u"}})
      EXPECT_NEAR(ours["results"][i][value].get<double>(), view[value].get<double>(),
                  std::max(4.0 * view[deviation].get<double>(), 0.01 * view["radiance"].get<double>()))
          << name << ", " << value << " of " << view["view_zenith_deg"] << " "
          << view["relative_azimuth_deg"];
  }
}

// MYSTIC with a million photons a direction.
TEST(SphericalReference, PolarisedCases) {
  std::vector<std::filesystem::path> paths;
  for (const char* const set : {"solver", "vector_spherical"}) {
    const std::filesystem::path folder = std::filesystem::path(SKYLUT_SHARED_REFERENCE) / set;
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().filename().string().starts_with("pol_")) paths.push_back(entry.path());
  }
  if (paths.empty()) GTEST_SKIP() << "no shared reference set";
  for (const auto& path : paths) compare_stokes(read_json_file(path), path.stem().string());
}

}  // namespace
}  // namespace skylut
