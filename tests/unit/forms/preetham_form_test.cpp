#include <gtest/gtest.h>

#include "skylut/core/errors.hpp"
#include "skylut/forms/form.hpp"
#include "skylut/models/preetham1999.hpp"
#include "skylut/models/preetham_model.hpp"
#include "support/model_skies.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

const test::ModelSkies kSkies(std::make_shared<const Preetham1999>(),
                              {{0.0}, TurbidityKind::preetham_t, {2.0, 6.0}, {45.0}});

// One fit for all tests: it takes seconds.
const ModelFile& fitted() {
  static const ModelFile file = fit_form(test::context, form_named("preetham"), kSkies, {});
  return file;
}

void expect_near(const PreethamMatrices::Perez& found, const PreethamMatrices::Perez& known) {
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_NEAR(found[i].slope, known[i].slope, 1e-4) << i;
    EXPECT_NEAR(found[i].offset, known[i].offset, 5e-4) << i;
  }
}

// His own skies give his own matrices back.
TEST(PreethamForm, RegeneratesThePublishedMatricesFromThePublishedSkies) {
  const ModelFile& file = fitted();
  const auto model = make_model(file);
  const PreethamMatrices& found = dynamic_cast<const PreethamModel&>(*model).levels().front().matrices;
  const PreethamMatrices& known = preetham1999_matrices();
  expect_near(found.Y, known.Y);
  expect_near(found.x, known.x);
  expect_near(found.y, known.y);
  EXPECT_NEAR(found.zenith_Y.chi_offset, known.zenith_Y.chi_offset, 1e-6);
  EXPECT_NEAR(found.zenith_Y.chi_divisor, known.zenith_Y.chi_divisor, 0.01);
  EXPECT_NEAR(found.zenith_Y.tangent.slope, known.zenith_Y.tangent.slope, 1e-4);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(found.zenith_x[row][i], known.zenith_x[row][i], 1e-8);
      EXPECT_NEAR(found.zenith_y[row][i], known.zenith_y[row][i], 1e-8);
    }
  EXPECT_LT(file.error["held_out"]["rms_Y_rel"]["worst"].get<double>(), 1e-4);
  EXPECT_LT(file.error["held_out"]["rms_x"]["worst"].get<double>(), 1e-5);
  EXPECT_LT(file.error["beside_published"]["by_turbidity"][0]["published"]["rms_Y_rel"].get<double>(), 1e-12);
}

TEST(PreethamForm, StatesWhereItHolds) {
  const ModelFile& file = fitted();
  EXPECT_EQ(file.info.turbidity_kind, TurbidityKind::preetham_t);
  const auto model = make_model(file);
  EXPECT_THROW(model->at({.turbidity = {TurbidityKind::preetham_t, 6.5}, .sun = {30.0, 0.0}}), InputError);
  EXPECT_THROW(model->at({.turbidity = {TurbidityKind::aod500, 3.0}, .sun = {30.0, 0.0}}), InputError);
  EXPECT_THROW(model->at({.turbidity = {TurbidityKind::preetham_t, 3.0}, .sun = {86.0, 0.0}}), InputError);
  EXPECT_THROW(
      model->at({.altitude_km = 1.0, .turbidity = {TurbidityKind::preetham_t, 3.0}, .sun = {30.0, 0.0}}),
      InputError);
}

}  // namespace
}  // namespace skylut
