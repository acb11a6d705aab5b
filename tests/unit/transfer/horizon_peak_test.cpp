#include "spherical/horizon_peak.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "sky_cases.hpp"
#include "spherical/block_optics.hpp"
#include "spherical/horizon_light.hpp"
#include "spherical/sweep_tables.hpp"

namespace skylut::transfer {
namespace {

/// Haze with a broad part and a forward peak that delta-M cuts off.
OpticalColumn peaked_haze() {
  std::vector<double> moments;
  for (int l = 0; l <= 400; ++l) moments.push_back(0.75 * std::pow(0.55, l) + 0.25 * std::pow(0.95, l));
  OpticalColumn column =
      test::column_of({.rayleigh_depth = 0.1, .haze_depth = 0.3, .haze_scattering_albedo = 0.95});
  column.scatterers.back().phase = std::make_shared<const LegendrePhaseFunction>(std::move(moments));
  return column;
}

/// C of a radiance that is the same at all levels and under all suns.
class Deficit {
 public:
  /// @param radiance  by azimuthal order m and μ
  explicit Deficit(const std::function<double(int, double)>& radiance) {
    HorizonLight<float> light(tables_.view(), optics_.view());
    light.open(true);
    const std::vector<double>& cosine = grid_.angles.cos_polar();
    for (const Hemisphere hemisphere : {kDown, kUp}) {
      std::vector<float> order;
      for (const double alpha : cosine)
        for (int m = 0; m < grid_.angles.azimuthal_orders(); ++m)
          order.push_back(static_cast<float>(grid_.angles.azimuth_nodes() *
                                             radiance(m, hemisphere == kDown ? -alpha : alpha)));
      for (int level = 0; level < grid_.sublayers.levels(); ++level)
        for (std::size_t node = 0; node < common_.sun_nodes_deg.size(); ++node)
          light.keep(hemisphere, level, static_cast<int>(node), true, order.data());
    }
    deficit_ = std::make_unique<HorizonDeficit<float>>(tables_.view(), optics_.view(), light);
  }

  std::vector<float> at(double mu, double altitude_km) const {
    std::vector<float> order(static_cast<std::size_t>(grid_.angles.azimuthal_orders()));
    deficit_->add(grid_.horizon.at(mu, altitude_km), 3, 1.0f, order.data());
    return order;
  }
  double cosine_of_node(std::size_t j) const { return grid_.angles.cos_polar()[j]; }
  int max_l() const { return grid_.angles.resolution().max_l; }

 private:
  OpticalColumn column_ = peaked_haze();
  const OpticalColumn* columns_[1] = {&column_};
  CommonGrid common_{test::earth(), discretisation_of(Quality::standard)};
  Discretisation grid_{common_, discretisation_for(common_.merge, common_.discretisation, column_)};
  SweepTables tables_{grid_};
  BlockOptics optics_{grid_, columns_, 1, true};
  std::unique_ptr<HorizonDeficit<float>> deficit_;
};

// p_l = 1 up to the degree that delta-M keeps: what is no finer than that, it treats exactly. What is left is
// the interpolation between polar nodes.
TEST(HorizonPeak, SmoothRadianceLacksNothing) {
  const Deficit deficit([](int m, double mu) {
    const double sine = std::sqrt(1.0 - mu * mu);
    return m == 0   ? 1.0 + 0.5 * mu - 0.3 * mu * mu
           : m == 1 ? 0.4 * sine * (1.0 + mu)
           : m == 2 ? 0.2 * sine * sine
                    : 0.0;
  });
  for (const double mu : {-0.0003, 0.0003, -0.02, 0.04})
    for (const float order : deficit.at(mu, 0.0)) EXPECT_NEAR(order, 0.0, 1e-3) << mu;
}

// A bright sky over a black ground: by symmetry the peak at the horizon sees half of the sky; at other angles
// the step's Legendre series, ½ ∫₋₁⁰ P_l dμ = -P_{l-1}(0)/(2(l+1)) for odd l and 0 for even l > 0.
TEST(HorizonPeak, StepAtTheHorizon) {
  const Deficit deficit([](int m, double mu) { return m == 0 && mu < 0.0 ? 1.0 : 0.0; });
  EXPECT_NEAR(deficit.at(-1e-9, 0.0)[0], -0.5, 0.02);
  EXPECT_NEAR(deficit.at(1e-9, 0.0)[0], 0.5, 0.02);
  const std::shared_ptr<const PhaseFunction> phase = peaked_haze().scatterers.back().phase;
  for (const std::size_t node : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
    const double mu = -deficit.cosine_of_node(node);
    double scattered = 0.5;
    for (unsigned l = 1; l <= 400; l += 2) {
      const double p = static_cast<int>(l) <= deficit.max_l()
                           ? 1.0
                           : phase->moment(static_cast<int>(l)) / phase->moment(deficit.max_l() + 1);
      scattered -= (2.0 * l + 1.0) * p * std::legendre(l, mu) * std::legendre(l - 1, 0.0) / (2.0 * (l + 1.0));
    }
    // Of the 0.05 per degree and more that are summed beyond l = 128, 0.95^107 = 0.4 % of the peak is left
    // out.
    const double whole = node < 3 ? 1.0 : (0.14 + mu) / (0.14 - 0.05);
    EXPECT_NEAR(deficit.at(mu, 0.0)[0], std::min(1.0, whole) * (scattered - 1.0), 2e-3) << node;
    EXPECT_NEAR(deficit.at(-mu, 0.0)[0], -std::min(1.0, whole) * (scattered - 1.0), 2e-3) << node;
  }
}

// Only grazing light near the ground, without a step where it ends.
TEST(HorizonPeak, FadesOut) {
  const Deficit deficit([](int m, double mu) { return m == 0 && mu < 0.0 ? 1.0 : 0.0; });
  EXPECT_LT(deficit.at(-0.01, 1.9)[0], -0.2);
  EXPECT_NEAR(deficit.at(-0.01, 2.5)[0], 0.5 * deficit.at(-0.01, 1.9)[0], 1e-5);
  EXPECT_NEAR(deficit.at(-0.01, 2.9999)[0], 0.0, 1e-4);
  EXPECT_NEAR(deficit.at(-0.1399, 0.0)[0], 0.0, 1e-3);
  const CommonGrid common(test::earth(), discretisation_of(Quality::standard));
  const OpticalColumn column = peaked_haze();
  const Discretisation grid(common, discretisation_for(common.merge, common.discretisation, column));
  EXPECT_TRUE(grid.horizon.at(-0.01, 0.0).near);
  EXPECT_FALSE(grid.horizon.at(-0.01, 3.0).near);
  EXPECT_FALSE(grid.horizon.at(0.14, 0.0).near);
}

// Molecules scatter without a peak, and haze that is nearly isotropic has none either: nothing is done then.
TEST(HorizonPeak, NoneWithoutAPeak) {
  const LayerMerge merge(test::earth(), false);
  const DiscretisationOptions options = discretisation_of(Quality::standard);
  EXPECT_FALSE(discretisation_for(merge, options, test::column_of({.rayleigh_depth = 0.3})).cuts_peak);
  EXPECT_FALSE(
      discretisation_for(merge, options, test::column_of({.haze_depth = 0.3, .haze_asymmetry = 0.05}))
          .cuts_peak);
  EXPECT_TRUE(discretisation_for(merge, options, peaked_haze()).cuts_peak);
}

/// A direction and what our Monte Carlo finds there with 2,000,000 photons, seed 1.
struct Reference {
  RelativeView view;
  double radiance;
  double sigma;
};

// Without the correction the three directions closest to the horizon are 2.6 to 2.8 % too bright, the
// next 1.6 %.
TEST(HorizonPeak, AgreesWithMonteCarloAtTheHorizon) {
  const std::vector<Reference> references{{{89.9, 30}, 1.14772e-01, 8.5e-05},
                                          {{89.9, 90}, 4.09365e-02, 5.0e-05},
                                          {{89.9, 180}, 2.97315e-02, 3.7e-05},
                                          {{89.5, 60}, 6.66803e-02, 7.0e-05},
                                          {{85, 90}, 5.19213e-02, 5.1e-05}};
  SkyRequest request{{0.0}, {60.0}, {}};
  for (const Reference& reference : references) request.views.push_back(reference.view);
  const SkyRadiance sky = test::solve(test::earth(), peaked_haze(), request);
  for (std::size_t i = 0; i < references.size(); ++i)
    EXPECT_NEAR(static_cast<double>(sky.at(0, 0, 0, i)) / references[i].radiance, 1.0,
                std::max(3.0 * references[i].sigma / references[i].radiance, 0.007))
        << references[i].view.zenith_deg << " " << references[i].view.relative_azimuth_deg;
}

}  // namespace
}  // namespace skylut::transfer
