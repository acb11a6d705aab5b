#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "skylut/core/constants.hpp"
#include "skylut/scattering/aerosol_optics.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

// Hess, Koepke and Schult 1998, table 4: 550 nm, 80 % humidity; Ångström exponents 350-500 and 500-800 nm.
TEST(AerosolPresets, OpacTable4) {
  struct Published {
    std::string name;
    double albedo;
    double asymmetry;
    double exponent_350_500;
    double exponent_500_800;
  };
  const std::vector<Published> table{{"continental-clean", 0.972, 0.709, 1.10, 1.42},
                                     {"continental-average", 0.925, 0.703, 1.11, 1.42},
                                     {"continental-polluted", 0.892, 0.698, 1.13, 1.45},
                                     {"urban", 0.817, 0.689, 1.14, 1.43},
                                     {"desert", 0.888, 0.729, 0.20, 0.17},
                                     {"maritime-clean", 0.997, 0.772, 0.12, 0.08},
                                     {"maritime-polluted", 0.975, 0.756, 0.41, 0.35}};
  for (const Published& published : table) {
    const AerosolOptics optics = load_aerosol(test::context, published.name);
    // Rounded in print, computed with another step of radius.
    EXPECT_NEAR(optics.single_scattering_albedo_at(550.0), published.albedo, 0.001) << published.name;
    EXPECT_NEAR(optics.asymmetry_at(550.0), published.asymmetry, 0.002) << published.name;
    EXPECT_NEAR(optics.angstrom_exponent_between(350.0, 500.0), published.exponent_350_500, 0.01)
        << published.name;
    EXPECT_NEAR(optics.angstrom_exponent_between(500.0, 800.0), published.exponent_500_800, 0.01)
        << published.name;
  }
}

// Shettle and Fenn 1979, rural at 70 % humidity: extinction relative to 550 nm, albedo, asymmetry.
TEST(AerosolPresets, RuralIsShettleAndFenns) {
  const AerosolOptics rural = load_aerosol(test::context, "rural");
  const std::vector<std::array<double, 4>> published{{300.0, 1.74165, 0.9379, 0.6928},
                                                     {337.1, 1.59981, 0.9521, 0.6865},
                                                     {550.0, 1.0, 0.9462, 0.6630},
                                                     {694.3, 0.75316, 0.9378, 0.6498}};
  for (const auto& [nm, extinction, albedo, asymmetry] : published) {
    // At 337.1 nm the albedo bends (k falls from 0.008 to 0.005); ours is linear between 300 and 350 nm.
    EXPECT_NEAR(rural.relative_depth(nm) / rural.relative_depth(550.0) / extinction, 1.0, 0.002) << nm;
    EXPECT_NEAR(rural.single_scattering_albedo_at(nm), albedo, nm == 337.1 ? 0.004 : 0.001) << nm;
    EXPECT_NEAR(rural.asymmetry_at(nm), asymmetry, 0.0015) << nm;
  }
}

// Preetham, Shirley and Smits 1999, table 1: η is ∫ (i1 + i2) x^-4 dx / …, and K its integral: p = 2 η / K.
// Table 2 gives K, by which their extinction goes as K / λ².
TEST(AerosolPresets, PreethamsTablesComeBack) {
  const AerosolOptics haze = load_aerosol(test::context, "preetham");
  const std::array<double, 4> nm{400.0, 450.0, 550.0, 650.0};
  const std::array<double, 4> k{0.656, 0.666, 0.678, 0.685};
  const std::vector<std::array<double, 5>> eta{
      {1.0, 4.192, 4.193, 4.177, 4.147},           {4.0, 3.311, 3.319, 3.329, 3.335},
      {10.0, 2.518, 2.527, 2.536, 2.542},          {30.0, 1.122, 1.129, 1.138, 1.142},
      {60.0, 0.3324, 0.3373, 0.3433, 0.3467},      {90.0, 0.1239, 0.1275, 0.1320, 0.1346},
      {120.0, 0.08242, 0.08652, 0.09179, 0.09488}, {150.0, 0.09701, 0.1024, 0.1095, 0.1137}};
  for (std::size_t i = 0; i < nm.size(); ++i) {
    const auto phase = haze.phase_function(nm[i]);
    // K has three digits.
    for (const std::array<double, 5>& row : eta)
      EXPECT_NEAR(phase->value(std::cos(row[0] * kRadiansPerDegree)) / (2.0 * row[i + 1] / k[i]), 1.0, 0.006)
          << nm[i] << " " << row[0];
    EXPECT_NEAR(haze.relative_depth(nm[i]) / haze.relative_depth(550.0),
                k[i] / k[2] * std::pow(550.0 / nm[i], 2), 0.003)
        << nm[i];
  }
}

// Forwards light keeps its polarisation, backwards U changes its sign, and nothing polarises by more than
// all.
void expect_matrix_of_spheres(const PhaseFunction& phase, const std::string& name) {
  EXPECT_NEAR(phase.matrix(1.0).f33, phase.value(1.0), 1e-6 * phase.value(1.0)) << name;
  EXPECT_NEAR(phase.matrix(-1.0).f33, -phase.value(-1.0), 1e-3 * phase.value(-1.0)) << name;
  for (double angle_deg = 0.0; angle_deg <= 180.0; angle_deg += 2.5) {
    const ScatteringMatrix at = phase.matrix(std::cos(angle_deg * kRadiansPerDegree));
    EXPECT_EQ(at.f22, at.f11);
    EXPECT_LE(std::hypot(at.f12, at.f33), at.f11 * (1.0 + 1e-3)) << name << " " << angle_deg;
  }
}

TEST(AerosolPresets, MomentsAndPhaseFunctionsAgree) {
  for (const std::string& name : aerosol_names(test::context)) {
    const AerosolOptics optics = load_aerosol(test::context, name);
    for (const double nm : {300.0, 425.0, 550.0, 780.0, 1000.0}) {
      const auto phase = optics.phase_function(nm);
      EXPECT_NEAR(phase->moment(0), 1.0, 1e-12) << name;
      EXPECT_NEAR(phase->moment(1), optics.asymmetry_at(nm), 1e-12) << name;
      for (double angle_deg = 0.0; angle_deg <= 180.0; angle_deg += 2.5)
        EXPECT_GT(phase->value(std::cos(angle_deg * kRadiansPerDegree)), 0.0) << name << " " << angle_deg;
      if (!optics.phase.empty()) expect_matrix_of_spheres(*phase, name);
    }
    EXPECT_DOUBLE_EQ(optics.relative_depth(500.0), 1.0) << name;
  }
}

// Between two wavelengths F12 is mixed in the same shares as F11.
TEST(AerosolPresets, MatricesMixAsPhaseFunctionsDo) {
  const AerosolOptics rural = load_aerosol(test::context, "rural");
  const auto lower = rural.phase_function(500.0);
  const auto upper = rural.phase_function(550.0);
  const auto between = rural.phase_function(525.0);
  const double share = (between->moment(1) - lower->moment(1)) / (upper->moment(1) - lower->moment(1));
  const auto mixed = [&](double a, double b) { return (1.0 - share) * a + share * b; };
  for (double mu : {0.9, 0.0, -0.9}) {
    EXPECT_NEAR(between->matrix(mu).f12, mixed(lower->matrix(mu).f12, upper->matrix(mu).f12), 1e-9);
    EXPECT_NEAR(between->matrix(mu).f33, mixed(lower->matrix(mu).f33, upper->matrix(mu).f33), 1e-9);
  }
  EXPECT_NEAR(between->matrix_moments(5)[5].beta1,
              mixed(lower->matrix_moments(5)[5].beta1, upper->matrix_moments(5)[5].beta1), 1e-9);
}

// The stratospheric layer has its own optics, and turbidity is the column of both.
TEST(AerosolPresets, TotalColumnHoldsTheStratosphere) {
  const AerosolOptics rural = load_aerosol(test::context, "rural");
  ASSERT_TRUE(rural.stratosphere);
  EXPECT_EQ(rural.stratosphere->name, "stratospheric-background");
  EXPECT_NEAR(rural.depth(500.0, 0.1), 0.1, 1e-15);
  EXPECT_NEAR(rural.depth(700.0, 0.1),
              0.095 * rural.relative_depth(700.0) + 0.005 * rural.stratosphere->relative_depth(700.0), 1e-15);
  for (const double aod500 : {0.0, 0.002, 0.005, 0.1, 1.0})
    EXPECT_NEAR(rural.aod500_of_depth(700.0, rural.depth(700.0, aod500)), aod500, 1e-14);
}

}  // namespace
}  // namespace skylut
