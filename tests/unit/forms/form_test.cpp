#include "skylut/forms/form.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "skylut/core/errors.hpp"
#include "skylut/models/preetham1999.hpp"
#include "skylut/models/preetham_model.hpp"
#include "support/model_skies.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

TEST(Form, EveryFormCanBeReadBack) { EXPECT_EQ(form_names(), model_forms()); }

TEST(Form, AMisspeltNameIsAnswered) {
  try {
    form_named("hosek-wilky");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean hosek-wilkie?"), std::string::npos)
        << error.what();
  }
}

// Perez's formula holds Preetham's skies, at the nodes exactly; between two suns they are blends.
TEST(Form, PerezHoldsEachSkyAndBlendsBetween) {
  const test::ModelSkies skies(std::make_shared<const Preetham1999>(),
                               {{0.0}, TurbidityKind::preetham_t, {2.5}, {40.0, 44.0}});
  const ModelFile file = fit_form(test::context, form_named("perez"), skies, {});
  const auto model = make_model(file);
  const auto colour = [&](const SkyModel& of, double sun_deg) {
    return of.at({.turbidity = {TurbidityKind::preetham_t, 2.5}, .sun = {sun_deg, 90.0}})
        ->colour(Direction{60.0, 20.0});
  };
  const Preetham1999 known;
  EXPECT_NEAR(colour(*model, 40.0).Y / colour(known, 40.0).Y, 1.0, 1e-6);
  EXPECT_NEAR(colour(*model, 40.0).x, colour(known, 40.0).x, 1e-6);
  EXPECT_NEAR(colour(*model, 42.0).Y / colour(known, 42.0).Y, 1.0, 5e-3);
  EXPECT_LT(file.error["held_out"]["rms_Y_rel"]["worst"].get<double>(), 5e-3);
  EXPECT_THROW(colour(*model, 45.0), InputError);
}

TEST(Form, AModelFileIsItsModel) {
  const test::ModelSkies skies(std::make_shared<const Preetham1999>(),
                               {{0.0}, TurbidityKind::preetham_t, {2.5}, {40.0, 44.0}});
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "form_test_model.json";
  const ModelFile perez = form_named("perez").fit(test::context, skies, {});
  const ModelFile published{.form = "preetham",
                            .info = Preetham1999().info(),
                            .error = {},
                            .model = PreethamModel::json({{0.0, preetham1999_matrices()}})};
  for (const ModelFile& file : {perez, published}) {
    const std::string text = model_file_json(file, Provenance("skylut fit"));
    std::ofstream(path) << text;
    ASSERT_TRUE(is_model_file(path));
    const auto written = make_model(file);
    const auto read = read_model_file(path);
    const SkyConditions conditions{.turbidity = {TurbidityKind::preetham_t, 2.5}, .sun = {41.3, 77.0}};
    for (const Direction& view : {Direction{0.0, 0.0}, Direction{41.0, 80.0}, Direction{90.0, 300.0}})
      EXPECT_EQ(read->at(conditions)->colour(view), written->at(conditions)->colour(view)) << file.form;
    EXPECT_EQ(read->info().sun_zenith_deg.highest, file.info.sun_zenith_deg.highest);
  }
}

TEST(Form, BandsNeedSpectra) {
  const test::ModelSkies skies(std::make_shared<const Preetham1999>(),
                               {{0.0}, TurbidityKind::preetham_t, {2.5}, {40.0}});
  EXPECT_THROW(form_named("perez-spectral").fit(test::context, skies, {}), InputError);
}

}  // namespace
}  // namespace skylut
