#include "particle_optics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "angular_sum.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/quadrature.hpp"
#include "skylut/scattering/aerosol_optics.hpp"
#include "skylut/scattering/legendre_scattering_matrix.hpp"
#include "skylut/scattering/mie_sphere.hpp"
#include "skylut/scattering/tabulated_phase_function.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

// Two spheres of very different size: moments against direct quadrature of their phase functions.
TEST(AngularSum, MomentsOfTwoSpheres) {
  const std::vector<MieSphere> spheres{MieSphere(2.0, {1.5, 0.01}), MieSphere(60.0, 1.33)};
  const std::vector<double> weights{500.0, 1.0};
  AngularSum sum;
  AngularSum::Rules rules;
  std::vector<double> light{0.0, 0.0};
  for (std::size_t s = 0; s < 2; ++s) {
    sum.add(spheres[s], weights[s]);
    AngularSum::prepare(rules, AngularSum::class_of(MieSphere::terms(spheres[s].size_parameter())));
    light[s] = weights[s] * spheres[s].q_sca() * std::pow(spheres[s].size_parameter(), 2);
  }
  std::vector<double> moments;
  for (const MatrixMoments& moment : sum.moments(rules)) moments.push_back(moment.alpha1);
  const Quadrature rule = gauss_legendre(400, -1.0, 1.0);
  for (const int l : {1, 2, 7, 30, 100}) {
    double direct = 0.0;
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const double mu = rule.node[i];
      double before = 0.0;
      double legendre = 1.0;
      for (int k = 1; k <= l; ++k) {
        const double next = ((2.0 * k - 1.0) * mu * legendre - (k - 1.0) * before) / k;
        before = legendre;
        legendre = next;
      }
      for (std::size_t s = 0; s < 2; ++s)
        direct += 0.5 * rule.weight[i] * legendre * light[s] * spheres[s].phase_function(mu);
    }
    EXPECT_NEAR(moments[static_cast<std::size_t>(l)] / moments[0], direct / (light[0] + light[1]), 1e-11)
        << l;
  }
  EXPECT_NEAR(moments[1] / moments[0],
              (light[0] * spheres[0].asymmetry() + light[1] * spheres[1].asymmetry()) / (light[0] + light[1]),
              1e-11);
}

/// The matrix of one sphere by its moments.
LegendreScatteringMatrix matrix_of(const MieSphere& sphere) {
  AngularSum sum;
  AngularSum::Rules rules;
  sum.add(sphere, 1.0);
  AngularSum::prepare(rules, AngularSum::class_of(MieSphere::terms(sphere.size_parameter())));
  std::vector<MatrixMoments> moments = sum.moments(rules);
  const double all = moments[0].alpha1;
  for (MatrixMoments& moment : moments)
    moment = {moment.alpha1 / all, moment.alpha2 / all, moment.alpha3 / all, moment.beta1 / all};
  return LegendreScatteringMatrix(std::move(moments));
}

// The matrix's series against the amplitudes that it is made of: Bohren & Huffman 1983, eq. 4.77.
TEST(AngularSum, MatrixOfASphereIsThatOfItsAmplitudes) {
  for (const auto& [size, index] : {std::pair{0.8, std::complex(1.5, 0.0)},
                                    {3.0, std::complex(1.33, 1e-3)},
                                    {25.0, std::complex(1.55, 0.02)}}) {
    const MieSphere sphere(size, index);
    const LegendreScatteringMatrix matrix = matrix_of(sphere);
    const double scale = 2.0 / (size * size * sphere.q_sca());
    for (double mu : {1.0, 0.93, 0.5, 0.01, -0.3, -0.88, -1.0}) {
      const MieSphere::Amplitudes at = sphere.amplitudes(mu);
      const ScatteringMatrix found = matrix.matrix(mu);
      const double f11 = scale * (std::norm(at.s1) + std::norm(at.s2));
      const double error = 1e-9 * matrix.value(1.0);
      EXPECT_NEAR(found.f11, f11, error) << size << " " << mu;
      EXPECT_NEAR(found.f22, f11, error) << size << " " << mu;
      EXPECT_NEAR(found.f12, scale * (std::norm(at.s2) - std::norm(at.s1)), error) << size << " " << mu;
      EXPECT_NEAR(found.f33, 2.0 * scale * (at.s1 * std::conj(at.s2)).real(), error) << size << " " << mu;
    }
    EXPECT_NEAR(matrix.matrix(1.0).f33, matrix.value(1.0), 1e-9 * matrix.value(1.0));
    EXPECT_NEAR(matrix.matrix(-1.0).f33, -matrix.value(-1.0), 1e-9 * matrix.value(1.0));
  }
}

// A small sphere is a dipole, but for terms of the order x² = 1e-4.
TEST(AngularSum, SmallSphereIsRayleighs) {
  const std::vector<MatrixMoments> found = matrix_of(MieSphere(0.01, 1.5)).matrix_moments(4);
  const std::vector<MatrixMoments> dipole = RayleighPhaseFunction(0.0).matrix_moments(4);
  for (std::size_t l = 0; l < 5; ++l) {
    EXPECT_NEAR(found[l].alpha1, dipole[l].alpha1, 1e-4) << l;
    EXPECT_NEAR(found[l].alpha2, dipole[l].alpha2, 1e-4) << l;
    EXPECT_NEAR(found[l].alpha3, dipole[l].alpha3, 1e-4) << l;
    EXPECT_NEAR(found[l].beta1, dipole[l].beta1, 1e-4) << l;
  }
}

AerosolComponent lognormal(double number, double mode_um, double sigma_g, double r_max_um, double n,
                           double k) {
  AerosolComponent component;
  component.number_per_cm3 = number;
  component.size.mode_radius_um = mode_um;
  component.size.sigma_g = sigma_g;
  component.size.r_max_um = r_max_um;
  component.wavelength_nm = {500.0};
  component.n = {n};
  component.k = {k};
  return component;
}

// Eight times the radii change extinction, albedo and asymmetry by less than 1e-4; particles that absorb
// nothing keep sharp resonances, for them 5e-4.
TEST(ParticleOptics, ConvergedOverSizes) {
  struct Mixture {
    std::vector<AerosolComponent> components;
    double tolerance;
  };
  const std::vector<Mixture> mixtures{
      {{lognormal(0.999875, 0.02846, 2.2387, 20, 1.501, 0.0056),
        lognormal(1.25e-4, 0.4571, 2.5119, 20, 1.501, 0.0056)},
       1e-4},
      {{lognormal(269.5, 0.07, 1.95, 20, 1.53, 0.0055), lognormal(30.5, 0.39, 2.0, 20, 1.53, 0.0055),
        lognormal(0.142, 1.9, 2.15, 60, 1.53, 0.0055)},
       1e-4},
      {{lognormal(20, 0.416, 2.03, 40, 1.36, 4e-9)}, 5e-4}};
  for (const auto& [components, tolerance] : mixtures) {
    const ParticleOptics coarse = particle_optics(test::context, components, {550.0}).front();
    const ParticleOptics fine = particle_optics(test::context, components, {550.0}, 8.0).front();
    EXPECT_NEAR(coarse.extinction_um2 / fine.extinction_um2, 1.0, tolerance);
    EXPECT_NEAR(coarse.scattering_um2 / coarse.extinction_um2, fine.scattering_um2 / fine.extinction_um2,
                tolerance);
    EXPECT_NEAR(coarse.moments[1], fine.moments[1], tolerance);
  }
}

// Narrow distribution: the optics of its one sphere. Broad moments' sums: p(0) from the moments is that of
// the optical theorem's amplitude for a single size.
TEST(ParticleOptics, NarrowDistributionIsOneSphere) {
  AerosolComponent component = lognormal(1.0, 0.3, 1.01, 0.32, 1.5, 0.02);
  component.size.r_min_um = 0.28;
  const ParticleOptics optics = particle_optics(test::context, {component}, {500.0}).front();
  const MieSphere sphere(2.0 * kPi * 0.3 / 0.5, {1.5, 0.02});
  // A spread of 1 % in radius: second order, some 1e-3.
  EXPECT_NEAR(optics.extinction_um2 / (kPi * 0.09 * sphere.q_ext()), 1.0, 2e-3);
  EXPECT_NEAR(optics.moments[1], sphere.asymmetry(), 2e-3);
}

// Halfway between the wavelengths at which an aerosol is computed, the mixture of the neighbours is within 1
// % of Mie's theory there.
TEST(ParticleOptics, BetweenWavelengths) {
  for (const char* name : {"rural", "continental-average"}) {
    const AerosolOptics aerosol = load_aerosol(test::context, name);
    for (const double nm : {425.0, 575.0, 850.0}) {
      const ParticleOptics there =
          particle_optics(test::context, load_aerosol_description(test::context, name).components,
                          {500.0, nm})
              .back();
      const TabulatedPhaseFunction exact(there.moments);
      const auto mixed = aerosol.phase_function(nm);
      for (double angle_deg = 0.0; angle_deg <= 180.0; angle_deg += 0.5) {
        const double mu = std::cos(angle_deg * kRadiansPerDegree);
        EXPECT_NEAR(mixed->value(mu) / exact.value(mu), 1.0, 0.01) << name << " " << nm << " " << angle_deg;
      }
      EXPECT_NEAR(aerosol.single_scattering_albedo_at(nm), there.scattering_um2 / there.extinction_um2,
                  0.001);
    }
  }
}

// The table against the series it is made of, everywhere and in the aureole.
TEST(TabulatedPhaseFunction, LooksUpTheSeries) {
  const std::vector<AerosolComponent> dust{lognormal(269.5, 0.07, 1.95, 20, 1.53, 0.0055),
                                           lognormal(30.5, 0.39, 2.0, 20, 1.53, 0.0055),
                                           lognormal(0.142, 1.9, 2.15, 60, 1.53, 0.0055)};
  const ParticleOptics optics = particle_optics(test::context, dust, {400.0}).front();
  const TabulatedPhaseFunction table(optics.moments, optics.polarisation);
  const LegendrePhaseFunction series(optics.moments);
  const LegendreScatteringMatrix matrix(table.matrix_moments(static_cast<int>(optics.moments.size()) - 1));
  double worst = 0.0;
  for (double angle_deg = 0.0; angle_deg <= 180.0; angle_deg += angle_deg < 5.0 ? 0.0137 : 0.137) {
    const double mu = std::cos(angle_deg * kRadiansPerDegree);
    worst = std::max(worst, std::abs(table.value(mu) / series.value(mu) - 1.0));
  }
  EXPECT_LT(worst, 1e-3);
  for (double angle_deg : {0.0, 0.4, 3.0, 20.0, 77.0, 130.0, 171.0, 180.0}) {
    const double mu = std::cos(angle_deg * kRadiansPerDegree);
    const ScatteringMatrix looked_up = table.matrix(mu);
    const ScatteringMatrix exact = matrix.matrix(mu);
    EXPECT_EQ(looked_up.f11, table.value(mu));
    EXPECT_NEAR(looked_up.f12, exact.f12, 1e-3 * exact.f11) << angle_deg;
    EXPECT_NEAR(looked_up.f22, exact.f22, 1e-3 * exact.f11) << angle_deg;
    EXPECT_NEAR(looked_up.f33, exact.f33, 1e-3 * exact.f11) << angle_deg;
  }
  EXPECT_NEAR(table.value(1.0) / series.value(1.0), 1.0, 1e-12);
  EXPECT_NEAR(table.value(-1.0) / series.value(-1.0), 1.0, 1e-6);

  // Normalised as the moments are. Panels towards forward.
  double energy = 0.0;
  double forward = 0.0;
  double lower = 0.0;
  for (const double upper : {0.05, 0.2, 1.0, 3.0, 10.0, 30.0, 90.0, 180.0}) {
    const Quadrature rule = gauss_legendre(60, lower * kRadiansPerDegree, upper * kRadiansPerDegree);
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const double mu = std::cos(rule.node[i]);
      const double light = 0.5 * rule.weight[i] * std::sin(rule.node[i]) * table.value(mu);
      energy += light;
      forward += mu * light;
    }
    lower = upper;
  }
  EXPECT_NEAR(energy, 1.0, 1e-4);
  EXPECT_NEAR(forward, table.moment(1), 1e-4);
}

int threads_of_this_process() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("Threads:")) return std::stoi(line.substr(8));
  return 0;
}

// One thread means this one: no worker is started, and the numbers are the same.
TEST(ParticleOptics, ObeysTheNumberOfThreads) {
  const std::vector<AerosolComponent> components{lognormal(1.0, 0.1, 1.8, 2.0, 1.5, 0.01)};
  const std::vector<double> wavelengths_nm{400.0, 500.0, 600.0, 700.0};
  Context context = test::context;
  context.threads = 1;
  const int before = threads_of_this_process();
  const std::vector<ParticleOptics> alone = particle_optics(context, components, wavelengths_nm);
  EXPECT_EQ(threads_of_this_process(), before);
  context.threads = 3;
  const std::vector<ParticleOptics> together = particle_optics(context, components, wavelengths_nm);
  EXPECT_GT(threads_of_this_process(), before);
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_EQ(alone[i].moments, together[i].moments);
}

// Clear spheres much smaller than the wavelength scatter a little more steeply than λ⁻⁴ where n > √2, by the
// next term of Rayleigh's series. Exponents of an independent Mie sum over 800 radii; between our own
// wavelengths extinction is interpolated.
TEST(ParticleOptics, ClearAitkenParticlesAreSteeperThanRayleigh) {
  AerosolDescription aitken;
  aitken.name = "aitken";
  aitken.components.push_back(lognormal(3000.0, 0.02, 1.2, 0.1, 1.53, 0.0));
  aitken.components[0].size.r_min_um = 0.0005;
  const AerosolOptics optics = aerosol_optics(test::context, aitken);
  EXPECT_NO_THROW(optics.validate());
  EXPECT_NEAR(optics.angstrom_exponent_between(300.0, 350.0), 4.0102, 2e-3);
  EXPECT_NEAR(optics.angstrom_exponent_between(350.0, 500.0), 4.0149, 2e-3);
  EXPECT_NEAR(optics.angstrom_exponent_between(440.0, 870.0), 4.0103, 2e-3);
  EXPECT_NEAR(optics.angstrom_exponent_between(500.0, 800.0), 4.0099, 2e-3);
}

}  // namespace
}  // namespace skylut
