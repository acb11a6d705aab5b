#include "skylut/export/picture_sampler.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "skylut/core/quadrature.hpp"
#include "support/test_atmosphere.hpp"
#include "support/test_context.hpp"
#include "test_light.hpp"

namespace skylut {
namespace {

using test::cosine;
using test::FormulaLight;

struct Sampled {
  std::vector<double> luminance;  // [row][column]
  double illuminance = 0.0;       // on a horizontal plane, from above
  double flux = 0.0;              // ∫ L dω
  double samples_per_pixel = 0.0;
};

Sampled sample(const SkyLight& sky, const std::vector<std::unique_ptr<Projection>>& pictures) {
  Sampled result;
  double pixels = 0.0;
  double samples = 0.0;
  for (const auto& picture : pictures) {
    const PictureSampler sampler(sky, *picture);
    std::vector<Xyz> colour(static_cast<std::size_t>(picture->width()));
    for (int row = 0; row < picture->height(); ++row) {
      samples += static_cast<double>(sampler.sample_row(row, colour, {}));
      for (int column = 0; column < picture->width(); ++column) {
        const double luminance = colour[static_cast<std::size_t>(column)].Y;
        const double solid_angle = picture->solid_angle_sr(column, row);
        result.luminance.push_back(luminance);
        result.flux += luminance * solid_angle;
        if (const auto direction = picture->direction(column, row)) {
          ++pixels;
          result.illuminance += std::max(0.0, cosine(direction->zenith_deg)) * luminance * solid_angle;
        }
      }
    }
  }
  result.samples_per_pixel = samples / pixels;
  return result;
}

Sampled sample(const SkyLight& sky, const std::string& name, int size, std::optional<SkyPart> part = {}) {
  return sample(sky, make_projections({name, size, part}));
}

// A narrow aureole in a dark sky, half as bright 2° from the sun.
double aureole(double gamma_deg) { return 1e4 * std::exp2(-gamma_deg / 2.0); }

// ∫ aureole cos θ dω = 2π cos θ_sun ∫ aureole(γ) cos γ sin γ dγ: nothing of it reaches the horizon.
double aureole_illuminance(double sun_zenith_deg) {
  const Quadrature rule = gauss_legendre(200, 0.0, 44.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < rule.node.size(); ++i)
    sum += rule.weight[i] * aureole(rule.node[i]) * cosine(rule.node[i]) * cosine(90.0 - rule.node[i]);
  return 2.0 * kPi * cosine(sun_zenith_deg) * sum * kRadiansPerDegree;
}

// Every projection, size and averaging keeps a uniform sky uniform; ∫ L dω over the sphere is 4π L.
TEST(PictureSampler, AUniformSkyIsUniform) {
  const FormulaLight sky([](const Direction&) { return 3.0; });
  for (const std::string& name : projection_names()) {
    const auto pictures = make_projections({name, 16, SkyPart::sphere});
    const Sampled sampled = sample(sky, pictures);
    std::size_t i = 0;
    for (const auto& picture : pictures)
      for (int row = 0; row < picture->height(); ++row)
        for (int column = 0; column < picture->width(); ++column, ++i) {
          const bool has_direction = picture->direction(column, row).has_value();
          if (has_direction || picture->solid_angle_sr(column, row) == 0.0) {
            EXPECT_NEAR(sampled.luminance[i], has_direction ? 3.0 : 0.0, 1e-12)
                << name << " " << column << " " << row;
          }
        }
    EXPECT_NEAR(sampled.flux / (12.0 * kPi), 1.0, 1e-6) << name;
  }
}

// E = π L, to 0.1 %; the horizon lies between two rows of the latlong picture and across pixels of the
// others.
TEST(PictureSampler, IlluminanceOfASkyThatJumpsAtTheHorizon) {
  const FormulaLight sky = test::jump_light(1.0);
  for (const std::string& name : projection_names()) {
    const Sampled sampled =
        sample(sky, name == "cube" ? "cube" : name, name.starts_with("cube") ? 128 : 512, SkyPart::sphere);
    EXPECT_NEAR(sampled.illuminance / kPi, 1.0, 1e-3) << name;
    EXPECT_NEAR(sampled.flux / (2.0 * kPi), 1.0, 1e-3) << name;
  }
}

TEST(PictureSampler, IlluminanceOfANarrowAureole) {
  const FormulaLight sky([](const Direction& d) {
    return aureole(kDegreesPerRadian * angle_between(d, {45.0, 120.0}));
  });
  for (const std::string& name : projection_names())
    for (const int size : {128, 512}) {
      if (name.starts_with("cube") && size == 512) continue;
      const Sampled sampled = sample(sky, name, size);
      EXPECT_NEAR(sampled.illuminance / aureole_illuminance(45.0), 1.0, size < 512 ? 2e-3 : 1e-3)
          << name << " " << size;
    }
}

// An aureole that halves in 0.3°, in pixels of 1.4°: ∫ L dω is kept wherever in a pixel the sun stands. With
// k = ln 2 / 0.3°, ∫ e^(-kγ) 2π sin γ dγ = 2π/(1 + k²). Pieces of a fifth of the distance err by 0.3 %.
TEST(PictureSampler, AnAureoleMuchNarrowerThanAPixelIsNotMissed) {
  const double k = std::log(2.0) / (0.3 * kRadiansPerDegree);
  for (const double zenith_deg : {45.0, 45.5, 46.1}) {
    const Direction sun{zenith_deg, 120.0};
    const FormulaLight sky([&](const Direction& d) { return std::exp(-k * angle_between(d, sun)); }, sun);
    EXPECT_NEAR(sample(sky, "latlong", 128).flux * (1.0 + k * k) / (2.0 * kPi), 1.0, 6e-3) << zenith_deg;
  }
}

// A sky with L = 1 + cos θ above and 0.2 below: E = π (1 + 2/3).
TEST(PictureSampler, IlluminanceOfACosineSky) {
  const FormulaLight sky(
      [](const Direction& d) { return d.zenith_deg < 90.0 ? 1.0 + cosine(d.zenith_deg) : 0.2; });
  for (const char* name : {"fisheye", "fisheye-equisolid", "latlong"})
    EXPECT_NEAR(sample(sky, name, 512, SkyPart::hemisphere).illuminance / (kPi * 5.0 / 3.0), 1.0, 1e-3)
        << name;
}

// A row of pixels that the horizon cuts anywhere holds the part of each that lies above it.
TEST(PictureSampler, APixelHasTheMeanOfItsArea) {
  for (const double part : {0.2, 0.5, 0.77}) {
    constexpr int kRows = 60;  // of 3°
    const double horizon_deg = 90.0 + 3.0 * part;
    const Sampled sampled = sample(test::jump_light(1.0, horizon_deg), "latlong", kRows);
    const double top = cosine(90.0);
    const double expected = (top - cosine(horizon_deg)) / (top - cosine(93.0));
    // Pieces at the horizon are 0.02° high: half of one of 3°, 0.003.
    EXPECT_NEAR(sampled.luminance[30 * 120 + 17], expected, 0.0035) << part;
    EXPECT_NEAR(sampled.luminance[29 * 120 + 17], 1.0, 1e-12);
    EXPECT_EQ(sampled.luminance[31 * 120 + 17], 0.0);
  }
}

// In a small cube the horizon of an observer up high slants through the pixels: many shades, no stairs.
TEST(PictureSampler, ASlantingHorizonHasNoStairs) {
  const Sampled sampled = sample(test::jump_light(1.0, 95.6), "octahedral", 64);
  int between = 0;
  for (const double luminance : sampled.luminance) between += luminance > 0.05 && luminance < 0.95 ? 1 : 0;
  EXPECT_GT(between, 100);
}

// About one direction a pixel, measured 1.04, 1.30, 1.28 and 1.02.
TEST(PictureSampler, CostOfAPixel) {
  const FormulaLight sky = test::jump_light(1.0);
  EXPECT_LT(sample(sky, "latlong", 512).samples_per_pixel, 1.06);
  EXPECT_LT(sample(sky, "fisheye", 512).samples_per_pixel, 1.35);
  EXPECT_LT(sample(sky, "octahedral", 512).samples_per_pixel, 1.35);
  EXPECT_LT(sample(sky, "latlong", 1024).samples_per_pixel, 1.03);
}

// Pixels of 0.02° far from the horizon and the sun: one direction; crossed by the horizon: more.
TEST(PictureSampler, FewDirectionsForSmallPixels) {
  const auto picture = std::move(make_projections({"latlong", 8192, {}}).front());
  std::vector<Xyz> colour(16384);
  const FormulaLight level = test::jump_light(1.0);
  const PictureSampler sampler(level, *picture);
  EXPECT_EQ(sampler.sample_row(4095, colour, {}), 16384u * 2u);  // the edge of the row is the horizon
  EXPECT_EQ(sampler.sample_row(1000, colour, {}), 16384u);
}

// The mean spectrum of a pixel is made of the same directions as its colour.
TEST(PictureSampler, SpectraGoWithColours) {
  const FormulaLight sky = test::jump_light(2.0, 90.3);
  const auto picture = std::move(make_projections({"fisheye", 31, SkyPart::sphere}).front());
  const PictureSampler sampler(sky, *picture);
  std::vector<Xyz> colour(31);
  std::vector<float> radiance(31 * 3);
  for (int row = 0; row < 31; ++row) {
    sampler.sample_row(row, colour, radiance);
    for (std::size_t i = 0; i < 31; ++i) {
      EXPECT_NEAR(radiance[3 * i], colour[i].Y, 1e-5);
      EXPECT_NEAR(radiance[3 * i + 2], 1.2 * colour[i].Y, 1e-5);
    }
  }
}

// A sun 30' across in thin air, in the middle of a pixel or where the azimuth and zenith angle say.
SunDisc sun_at(const Direction& sun) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.1}};
  scene.suns = {sun};
  scene.wavelengths = WavelengthGrid{400.0, 600.0, 100.0};  // as FormulaLight
  return {test::context, scene};
}

// Its own sun and horizon are where no pixel is cut for them.
FormulaLight darkness() {
  return FormulaLight([](const Direction&) { return 0.0; }, {180.0, 0.0}, -180.0);
}

struct Lit {
  double normal = 0.0;      // ∫ L dω
  double horizontal = 0.0;  // ∫ L cos θ dω
  std::vector<double> irradiance;
};

Lit lit_by(const SkyLight& sky, const SunDisc& disc, const ProjectionChoice& choice) {
  Lit lit{0.0, 0.0, std::vector<double>(3)};
  for (const auto& picture : make_projections(choice)) {
    const PictureSampler sampler(sky, *picture, &disc);
    std::vector<Xyz> colour(static_cast<std::size_t>(picture->width()));
    std::vector<float> radiance(3 * colour.size());
    for (int row = 0; row < picture->height(); ++row) {
      sampler.sample_row(row, colour, radiance);
      for (int column = 0; column < picture->width(); ++column) {
        const auto i = static_cast<std::size_t>(column);
        if (colour[i].Y == 0.0) continue;
        const double solid_angle = picture->solid_angle_sr(column, row);
        lit.normal += colour[i].Y * solid_angle;
        for (std::size_t w = 0; w < 3; ++w)
          lit.irradiance[w] += solid_angle * static_cast<double>(radiance[3 * i + w]);
        if (const auto direction = picture->direction(column, row))
          lit.horizontal += std::max(0.0, cosine(direction->zenith_deg)) * colour[i].Y * solid_angle;
      }
    }
  }
  return lit;
}

// ∫ L dω is what the disc sends, whatever the projection, the size and the place of the disc, on seams and
// poles of a picture, too; in every wavelength.
TEST(PictureSampler, TheDiscsLightIsAllThere) {
  const FormulaLight dark = darkness();
  for (const Direction sun :
       {Direction{48.0, 200.0}, {0.1, 30.0}, {50.0, 45.0}, {80.0, 270.0}, {89.9, 10.0}}) {
    const SunDisc disc = sun_at(sun);
    for (const std::string& name : projection_names())
      for (const int size : {5, 64, 512}) {
        if (size == 512 && (sun.zenith_deg != 48.0 || name == "cube-cross")) continue;
        const Lit lit = lit_by(dark, disc, {name, size, {}});
        EXPECT_NEAR(lit.normal / disc.illuminance().Y, 1.0, 1e-9)
            << name << " " << size << " " << sun.zenith_deg;
        for (std::size_t w = 0; w < 3; ++w)
          EXPECT_NEAR(lit.irradiance[w] / disc.direct_normal()[w], 1.0, 1e-6) << name << " " << size;
      }
  }
}

// A pixel's cosine is that of its middle: where the sun stands in one, diffuse light and beam add up to what
// falls on a horizontal plane.
TEST(PictureSampler, AUniformSkyAndTheDiscLightAPlane) {
  constexpr double kLuminance = 4000.0;
  const FormulaLight sky([](const Direction& d) { return d.zenith_deg < 90.0 ? kLuminance : 0.0; });
  for (const std::string& name : projection_names())
    for (const int size : {64, 512}) {
      if (size == 512 && name == "cube-cross") continue;  // the cube's pixels
      const auto pictures = make_projections({name, size, {}});
      const Projection& picture = *pictures.at(pictures.size() > 1 ? 4 : 0);
      const int column = name == "cube-cross" ? size + size / 3 : picture.width() / 3;
      const int row = name == "cube-cross" ? size + size / 3 : picture.height() / 3;
      const SunDisc disc = sun_at(*picture.direction(column, row));
      const double expected = kPi * kLuminance + disc.illuminance().Y * cosine(disc.sun().zenith_deg);
      EXPECT_NEAR(lit_by(sky, disc, {name, size, {}}).horizontal / expected, 1.0, 5e-4)
          << name << " " << size << " sun " << disc.sun().zenith_deg;
    }
}

TEST(PictureSampler, ADiscBehindTheHorizonAddsNothing) {
  EXPECT_EQ(lit_by(darkness(), sun_at({91.0, 10.0}), {"latlong", 16, {}}).normal, 0.0);
}

}  // namespace
}  // namespace skylut
