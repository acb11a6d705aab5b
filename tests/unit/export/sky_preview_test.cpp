#include "skylut/export/sky_preview.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "export/tone.hpp"
#include "skylut/core/errors.hpp"
#include "support/test_context.hpp"
#include "test_light.hpp"

namespace skylut {
namespace {

using test::FormulaLight;

// Pixels as libpng's simplified reader gives them.
struct Decoded {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

Decoded decoded(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, png.data(), png.size()), 0);
  image.format = PNG_FORMAT_RGB;
  Decoded result{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  result.pixels.resize(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, result.pixels.data(), 0, nullptr), 0);
  return result;
}

PreviewOptions of_size(int size, const std::string& projection = "latlong") {
  PreviewOptions options;
  options.projection.name = projection;
  options.projection.size = size;
  return options;
}

// IEC 61966-2-1: 0.5 linear is 188 of 255, and the two pieces meet.
TEST(Tone, SrgbEncoding) {
  EXPECT_EQ(srgb_encoded(0.0), 0.0);
  EXPECT_NEAR(srgb_encoded(1.0), 1.0, 1e-15);
  EXPECT_EQ(std::lround(255.0 * srgb_encoded(0.5)), 188);
  EXPECT_NEAR(srgb_encoded(0.0031308), srgb_encoded(0.0031308 + 1e-9), 1e-7);
}

// Equation 4 by hand: grey 0.18 with a far white is 0.18/1.18; the white is 1; the curve rises.
TEST(Tone, CurveOfReinhard) {
  const ToneCurve curve(100.0, 1e9);
  EXPECT_NEAR(curve(100.0), 0.18 / 1.18, 1e-9);
  const ToneCurve near(100.0, 1000.0);
  EXPECT_NEAR(near(1000.0), 1.0, 1e-12);
  EXPECT_NEAR(near(999.999), 1.0, 1e-5);
  for (double luminance = 10.0; luminance < 1000.0; luminance += 10.0)
    EXPECT_GT(near(luminance + 10.0), near(luminance));
  EXPECT_EQ(near(0.0), 0.0);
}

// Monochromatic light of 500 nm is far outside Rec. 709: luminance is kept, every channel is shown, and on
// the line to white; colours inside are not touched.
TEST(Tone, ColoursOutsideKeepTheirLuminance) {
  const ToneCurve curve(100.0, 1000.0);
  const Xyz green = to_xyz(Yxy{200.0, 0.0082, 0.5384});
  const DisplayedColour shown = displayed(green, curve);
  EXPECT_GT(shown.change, 0.1);
  EXPECT_NEAR(std::min({shown.rgb.r, shown.rgb.g, shown.rgb.b}), 0.0, 1e-15);
  EXPECT_NEAR(to_xyz(shown.rgb).Y, curve(200.0), 1e-14);
  const double scale = curve(200.0) / 200.0;
  const LinearRgb whole = to_linear_srgb(Xyz{scale * green.X, scale * green.Y, scale * green.Z});
  EXPECT_NEAR((shown.rgb.g - curve(200.0)) / (whole.g - curve(200.0)),
              (shown.rgb.b - curve(200.0)) / (whole.b - curve(200.0)), 1e-12);

  const Xyz pale = to_xyz(Yxy{200.0, 0.29, 0.31});
  EXPECT_EQ(displayed(pale, curve).change, 0.0);
  EXPECT_NEAR(to_yxy(to_xyz(displayed(pale, curve).rgb)).x, 0.29, 1e-12);
  // A saturated blue at nearly the luminance of white must give way.
  const DisplayedColour bright = displayed(to_xyz(Yxy{950.0, 0.20, 0.20}), curve);
  EXPECT_NEAR(bright.rgb.b, 1.0, 1e-12);
  EXPECT_NEAR(to_xyz(bright.rgb).Y, curve(950.0), 1e-12);
}

// Half the sky 100 cd/m², half 10⁴: the mean of the logarithm is 10³ cd/m², and the picture is right side up.
TEST(Preview, ExposureIsTheMeanOfTheLogarithm) {
  const FormulaLight sky([](const Direction& d) { return d.zenith_deg < 90.0 ? 100.0 : 1e4; });
  const Preview preview = make_preview(test::context, sky, of_size(32), Provenance("skylut map"));
  EXPECT_NEAR(preview.middle_grey_cd_m2, 1000.0, 1e-6);
  EXPECT_NEAR(preview.white_cd_m2, 1e4, 1e-6);
  EXPECT_EQ(preview.desaturated, 0u);
  const Decoded picture = decoded(preview.png);
  EXPECT_EQ(picture.width, 64);
  EXPECT_EQ(picture.height, 32);
  const double top = 0.018 * (1.0 + 0.018 / (1.8 * 1.8)) / 1.018;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    EXPECT_EQ(picture.pixels[channel], std::lround(255.0 * srgb_encoded(top)));
    EXPECT_EQ(picture.pixels[picture.pixels.size() - 3 + channel], 255);
  }
}

TEST(Preview, StatesExposureAndCurveInTheFile) {
  const FormulaLight sky([](const Direction&) { return 500.0; });
  PreviewOptions options = of_size(16, "cube");
  options.middle_grey_cd_m2 = 250.0;
  const Preview preview = make_preview(test::context, sky, options, Provenance("skylut map -x"));
  EXPECT_EQ(preview.width, 64);
  EXPECT_EQ(preview.middle_grey_cd_m2, 250.0);
  EXPECT_NE(preview.description.find("250 cd/m2 is middle grey"), std::string::npos);
  for (const std::string& text :
       {preview.description, std::string("skylut map -x"), std::string("cube-cross")})
    EXPECT_NE(preview.png.find(text), std::string::npos) << text;
  EXPECT_NE(preview.png.find("sRGB"), std::string::npos);
  // Outside the cross: black.
  EXPECT_EQ(decoded(preview.png).pixels[0], 0);
}

TEST(Preview, ThreadsChangeNoByte) {
  const FormulaLight sky([](const Direction& d) { return 100.0 + d.zenith_deg; });
  EXPECT_EQ(make_preview(test::on_threads(1), sky, of_size(24, "fisheye"), Provenance()).png,
            make_preview(test::on_threads(3), sky, of_size(24, "fisheye"), Provenance()).png);
}

TEST(Preview, ADarkSkyIsBlack) {
  const FormulaLight sky([](const Direction&) { return 0.0; });
  const Decoded picture = decoded(make_preview(test::context, sky, of_size(4), Provenance()).png);
  for (const std::uint8_t value : picture.pixels) EXPECT_EQ(value, 0);
}

TEST(Preview, WrongRequestsAreRefused) {
  const FormulaLight sky([](const Direction&) { return 1.0; });
  PreviewOptions options = of_size(4);
  for (const double grey : {0.0, -1.0, std::nan("")}) {
    options.middle_grey_cd_m2 = grey;
    EXPECT_THROW(make_preview(test::context, sky, options, Provenance()), InputError) << grey;
  }
  EXPECT_THROW(make_preview(test::context, sky, of_size(1), Provenance()), InputError);
}

}  // namespace
}  // namespace skylut
