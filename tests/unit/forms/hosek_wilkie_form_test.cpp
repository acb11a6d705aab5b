#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/forms/form.hpp"
#include "skylut/models/hosek_wilkie.hpp"
#include "skylut/models/hosek_wilkie_model.hpp"
#include "support/model_skies.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

/// Skies that the form holds exactly: brighter towards the zenith by √cosθ, and with the sun's height, the
/// load and the ground as their curves and blends are.
class SkyOfRoots final : public SkyModel {
 public:
  const ModelInfo& info() const override {
    static const ModelInfo info{.name = "roots",
                                .title = "",
                                .source = "",
                                .quantities = "Y, x, y",
                                .altitude_km = {0.0, 0.0, "km"},
                                .turbidity_kind = TurbidityKind::aod500,
                                .turbidity = {0.0, 1.0, ""},
                                .albedo = Range{0.0, 1.0, ""},
                                .sun_zenith_deg = {0.0, 90.0, "deg"},
                                .view_zenith_deg = {0.0, 90.0, "deg"}};
    return info;
  }

  std::unique_ptr<const Sky> at(const SkyConditions& conditions) const override {
    struct Answer final : Sky {
      double scale = 1.0;
      void colour(std::span<const Direction> views, std::span<Yxy> colours) const override {
        for (std::size_t i = 0; i < views.size(); ++i) {
          const double root = std::sqrt(std::fmax(0.0, std::cos(views[i].zenith_deg * kRadiansPerDegree)));
          colours[i] = {scale * (1.0 + 0.5 * root), 0.3, 0.32};
        }
      }
    };
    auto sky = std::make_unique<Answer>();
    sky->scale = 1000.0 * (0.2 + hosek_wilkie_curve_parameter(conditions.sun.zenith_deg)) *
                 (1.0 + conditions.turbidity.value) * (1.0 + 0.4 * conditions.albedo);
    return sky;
  }
};

TEST(HosekWilkieForm, FindsASkyThatItHolds) {
  const test::ModelSkies skies(std::make_shared<const SkyOfRoots>(),
                               {{0.0}, TurbidityKind::aod500, {0.1}, {45.0}});
  FormOptions options;
  options.albedos = {0.3};
  const ModelFile file = fit_form(test::context, form_named("hosek-wilkie"), skies, options);
  EXPECT_LT(file.error["held_out"]["rms_Y_rel"]["worst"].get<double>(), 2e-3);
  EXPECT_LT(file.error["held_out"]["rms_x"]["worst"].get<double>(), 5e-4);
  EXPECT_EQ(file.info.albedo->highest, 0.3);
}

}  // namespace
}  // namespace skylut
