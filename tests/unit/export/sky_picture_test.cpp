#include "skylut/export/sky_picture.hpp"

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>

#include "skylut/core/errors.hpp"
#include "skylut/core/version.hpp"
#include "support/test_atmosphere.hpp"
#include "support/test_context.hpp"
#include "test_light.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

// Bluish light, brighter to the east.
class ColouredLight final : public SkyLight {
 public:
  const WavelengthGrid& wavelengths() const override { return wavelengths_; }
  Direction sun() const override { return {45.0, 90.0}; }
  double horizon_zenith_deg() const override { return 90.0; }
  static double luminance(const Direction& d) {
    return 1000.0 + 500.0 * std::sin(d.azimuth_deg * kRadiansPerDegree) * test::cosine(90.0 - d.zenith_deg);
  }
  void radiance(std::span<const Direction> directions, std::span<float> radiance) const override {
    for (std::size_t i = 0; i < directions.size(); ++i)
      for (std::size_t w = 0; w < 3; ++w)
        radiance[3 * i + w] = static_cast<float>(luminance(directions[i]) * 1e-3 * double(w + 1));
  }
  void colour(std::span<const Direction> directions, std::span<Xyz> colour) const override {
    for (std::size_t i = 0; i < directions.size(); ++i)
      colour[i] = to_xyz(Yxy{luminance(directions[i]), 0.26, 0.27});
  }

 private:
  WavelengthGrid wavelengths_{400.0, 600.0, 100.0};
};

class SkyPicture : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  PictureSummary write(const PictureOptions& options, const std::string& name = "sky.exr",
                       const Context& context = test::context) {
    return write_pictures(context, folder_ / name, sky_, options, labels_);
  }
  static PictureOptions of(std::vector<SkyChannels> channels, const std::string& projection = "latlong",
                           int size = 40) {
    PictureOptions options;
    options.channels = std::move(channels);
    options.projection.name = projection;
    options.projection.size = size;
    return options;
  }

  Names files() const {
    Names names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }
  std::vector<float> channel(const std::string& name, const std::string& channel_name) const {
    Imf::InputFile file((folder_ / name).c_str());
    const auto window = file.header().dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x + 1);
    std::vector<float> pixels(width * static_cast<std::size_t>(window.max.y + 1));
    Imf::FrameBuffer frame;
    frame.insert(channel_name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), sizeof(float),
                                          width * sizeof(float)));
    file.setFrameBuffer(frame);
    file.readPixels(0, window.max.y);
    return pixels;
  }
  Imf::Header header(const std::string& name) const {
    return Imf::InputFile((folder_ / name).c_str()).header();
  }
  static std::string text(const Imf::Header& header, const char* name) {
    return header.typedAttribute<Imf::StringAttribute>(name).value();
  }
  std::string bytes(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("skylut_sky_picture_test." + std::to_string(::getpid()));
  const ColouredLight sky_;
  const PictureLabels labels_{6.0, {TurbidityKind::aod500, 0.25}, Provenance("skylut map")};
};

// Rows far apart, in different strips of the file, are where they belong.
TEST_F(SkyPicture, EveryPixelIsTheLightOfItsDirection) {
  const PictureSummary summary = write(of({SkyChannels::luminance}, "latlong", 150));
  EXPECT_EQ(files(), Names{"sky.exr"});
  const auto luminance = channel("sky.exr", "Y");
  const auto picture = std::move(make_projections({"latlong", 150, {}}).front());
  for (const int row : {0, 15, 16, 47, 64, 100, 149})
    for (const int column : {0, 77, 299}) {
      const double expected = ColouredLight::luminance(*picture->direction(column, row));
      // Means over 1.2° against their middles: (1.2°)²/24 of the variation.
      EXPECT_NEAR(luminance[static_cast<std::size_t>(row * 300 + column)] / expected, 1.0, 1e-4);
    }
  EXPECT_EQ(summary.pixels, 150u * 300u);
  EXPECT_GE(summary.directions, summary.pixels);
  EXPECT_NEAR(summary.brightest_cd_m2, 1500.0, 0.5);
  EXPECT_NEAR(summary.darkest_cd_m2, 500.0, 0.5);
}

TEST_F(SkyPicture, SeveralKindsHaveFilesOfTheirOwnAndAgree) {
  write(of({SkyChannels::rgb, SkyChannels::xyz, SkyChannels::luminance, SkyChannels::spectral}));
  EXPECT_EQ(files(), (Names{"sky_luminance.exr", "sky_rgb.exr", "sky_spectral.exr", "sky_xyz.exr"}));
  const auto y = channel("sky_xyz.exr", "Y");
  EXPECT_EQ(channel("sky_luminance.exr", "Y"), y);
  const auto red = channel("sky_rgb.exr", "R");
  const auto green = channel("sky_rgb.exr", "G");
  const auto blue = channel("sky_rgb.exr", "B");
  EXPECT_EQ(channel("sky_spectral.exr", "R"), red);
  const auto first = channel("sky_spectral.exr", "S0.400,000000nm");
  const auto last = channel("sky_spectral.exr", "S0.600,000000nm");
  for (std::size_t i = 0; i < y.size(); ++i) {
    EXPECT_NEAR(to_xyz(LinearRgb{red[i], green[i], blue[i]}).Y / y[i], 1.0, 1e-6);
    EXPECT_NEAR(first[i] / (1e-3 * y[i]), 1.0, 1e-6);
    EXPECT_NEAR(last[i] / (3e-3 * y[i]), 1.0, 1e-6);
  }
  const Imf::Header spectral = header("sky_spectral.exr");
  EXPECT_EQ(text(spectral, "spectralLayoutVersion"), "1.0");
  EXPECT_EQ(text(spectral, "emissiveUnits"), "W.m^-2.sr^-1");
  EXPECT_EQ(text(spectral, "skyRadianceUnit"), "W.m^-2.sr^-1.nm^-1");
}

TEST_F(SkyPicture, FacesHaveFilesOfTheirOwn) {
  write(of({SkyChannels::rgb}, "cube", 16));
  EXPECT_EQ(files(),
            (Names{"sky_nx.exr", "sky_ny.exr", "sky_nz.exr", "sky_px.exr", "sky_py.exr", "sky_pz.exr"}));
  // nx shows the east, where the light is brightest.
  EXPECT_GT(channel("sky_nx.exr", "G")[8 * 16 + 8], 1.5f * channel("sky_px.exr", "G")[8 * 16 + 8]);
  EXPECT_NE(text(header("sky_nx.exr"), "skyOrientation").find("nx east"), std::string::npos);
  EXPECT_EQ(picture_files("a/b.EXR", of({SkyChannels::rgb, SkyChannels::xyz}, "cube", 16))[3],
            "a/b_xyz_nx.EXR");
}

TEST_F(SkyPicture, NamesOfFiles) {
  const auto kinds = [](std::vector<SkyChannels> channels) { return of(std::move(channels)); };
  EXPECT_EQ(picture_files("out/a.b.exr", kinds({SkyChannels::spectral})),
            std::vector<fs::path>{"out/a.b.exr"});
  EXPECT_EQ(picture_files("out/a.b.exr", kinds({SkyChannels::luminance, SkyChannels::spectral})),
            (std::vector<fs::path>{"out/a.b_luminance.exr", "out/a.b_spectral.exr"}));
}

TEST_F(SkyPicture, ExplainsItself) {
  write(of({SkyChannels::rgb}));
  const Imf::Header rgb = header("sky.exr");
  EXPECT_EQ(text(rgb, "skylutVersion"), kVersion);
  EXPECT_EQ(text(rgb, "skylutCommand"), "skylut map");
  EXPECT_EQ(text(rgb, "skylutProvenance").front(), '{');
  EXPECT_EQ(text(rgb, "skyTurbidityKind"), "aod500");
  EXPECT_EQ(text(rgb, "skyProjection"), "latlong");
  EXPECT_NE(text(rgb, "skyOrientation").find("middle east"), std::string::npos);
  EXPECT_EQ(text(rgb, "skyLuminanceUnit"), "cd.m^-2 (0.2126 R + 0.7152 G + 0.0722 B)");
  const auto number = [&](const char* name) { return rgb.typedAttribute<Imf::FloatAttribute>(name).value(); };
  EXPECT_EQ(number("skyAltitudeKm"), 6.0f);
  EXPECT_EQ(number("skyTurbidity"), 0.25f);
  EXPECT_EQ(number("skySunZenithDeg"), 45.0f);
  EXPECT_EQ(number("skySunAzimuthDeg"), 90.0f);
  EXPECT_EQ(Imf::whiteLuminance(rgb), 1.0f);
  EXPECT_FALSE(Imf::hasEnvmap(rgb));
}

// Programs that know the ACES spaces get their primaries, white and neutral; the same light in both pictures.
TEST_F(SkyPicture, OtherSpacesSayWhichTheyAre) {
  PictureOptions options = of({SkyChannels::rgb, SkyChannels::xyz});
  options.rgb_space = "acescg";
  write(options);
  const Imf::Header aces = header("sky_rgb.exr");
  EXPECT_NEAR(Imf::chromaticities(aces).green.y, 0.830f, 1e-6);
  EXPECT_NEAR(Imf::chromaticities(aces).white.x, 0.32168f, 1e-6);
  EXPECT_NEAR(Imf::adoptedNeutral(aces).x, 0.32168f, 1e-6);
  EXPECT_EQ(text(aces, "colorInteropID"), "lin_ap1_scene");
  EXPECT_NE(text(aces, "skyWhiteAdaptation").find("Bradford"), std::string::npos);
  const RgbConversion conversion(rgb_space("acescg"));
  const Xyz back = conversion.to_xyz(LinearRgb{channel("sky_rgb.exr", "R")[9], channel("sky_rgb.exr", "G")[9],
                                               channel("sky_rgb.exr", "B")[9]});
  EXPECT_NEAR(back.Z / channel("sky_xyz.exr", "Z")[9], 1.0, 1e-6);
  options.adaptation = WhiteAdaptation::none;
  write(options);
  EXPECT_NEAR(Imf::adoptedNeutral(header("sky_rgb.exr")).x, 0.3127f, 1e-6);
  EXPECT_EQ(text(header("sky_rgb.exr"), "skyWhiteAdaptation"), "none");
}

TEST_F(SkyPicture, PixelsWithoutDirectionAreBlackAndNotCounted) {
  const PictureSummary summary = write(of({SkyChannels::luminance}, "fisheye", 20));
  const auto luminance = channel("sky.exr", "Y");
  EXPECT_EQ(luminance[0], 0.0f);
  EXPECT_GT(luminance[10 * 20 + 10], 900.0f);
  EXPECT_GT(summary.darkest_cd_m2, 400.0);
  EXPECT_LT(summary.pixels, 400u);
}

TEST_F(SkyPicture, ThreadsChangeNoByte) {
  const PictureOptions options = of({SkyChannels::spectral}, "fisheye", 70);
  write(options, "one.exr", test::on_threads(1));
  write(options, "three.exr", test::on_threads(3));
  EXPECT_EQ(bytes("one.exr"), bytes("three.exr"));
}

TEST_F(SkyPicture, AFullDiskLeavesWhatWasThere) {
  std::ofstream(folder_ / "sky_xyz.exr") << "old";
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t most : {rlim_t{100}, rlim_t{20'000}}) {
    const rlimit small{most, limit.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    EXPECT_THROW(write(of({SkyChannels::rgb, SkyChannels::xyz}, "latlong", 64)), WorkError) << most;
    ::setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_EQ(files(), Names{"sky_xyz.exr"});
    EXPECT_EQ(bytes("sky_xyz.exr"), "old");
  }
  std::signal(SIGXFSZ, handler);
}

TEST_F(SkyPicture, AFullDeviceAndAMissingFolderAreErrors) {
  EXPECT_THROW(write_pictures(test::context, "/dev/full", sky_, of({SkyChannels::rgb}), labels_), WorkError);
  EXPECT_THROW(write(of({SkyChannels::rgb}), "missing/sky.exr"), WorkError);
  EXPECT_TRUE(files().empty());
}

TEST_F(SkyPicture, CancellingLeavesNothing) {
  std::stop_source stop;
  Context context = test::context;
  context.cancel = stop.get_token();
  std::size_t calls = 0;
  context.progress = [&](std::string_view, std::size_t done, std::size_t all) {
    EXPECT_LE(done, all);
    if (++calls == 2) stop.request_stop();
  };
  EXPECT_THROW(write(of({SkyChannels::rgb}, "latlong", 400), "sky.exr", context), Cancelled);
  EXPECT_EQ(calls, 2u);
  EXPECT_TRUE(files().empty());
}

TEST_F(SkyPicture, OtherFilesOfTheCommandAppearWithIt) {
  const std::string preview_file = (folder_ / "preview.png").string();
  const std::vector<FileText> also{{preview_file, "png"}};
  write_pictures(test::context, folder_ / "sky.exr", sky_, of({SkyChannels::rgb}), labels_, nullptr, also);
  EXPECT_EQ(files(), (Names{"preview.png", "sky.exr"}));
}

TEST_F(SkyPicture, ASunOfItsOwnHasItsFiles) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.1}};
  scene.suns = {sky_.sun()};
  scene.wavelengths = sky_.wavelengths();
  const SunDisc disc(test::context, scene);
  PictureOptions options = of({SkyChannels::luminance}, "latlong", 40);
  write(options, "off.exr");
  options.sun = SunPicture::disc;
  write_pictures(test::context, folder_ / "both.exr", sky_, options, labels_, &disc);
  options.sun = SunPicture::file;
  const PictureSummary summary =
      write_pictures(test::context, folder_ / "sky.exr", sky_, options, labels_, &disc);
  EXPECT_EQ(files(), (Names{"both.exr", "off.exr", "sky.exr", "sky_sun.exr"}));
  EXPECT_EQ(summary.files, (std::vector<fs::path>{folder_ / "sky.exr", folder_ / "sky_sun.exr"}));
  EXPECT_LT(summary.brightest_cd_m2, 2000.0);
  const auto sky = channel("sky.exr", "Y");
  const auto sun = channel("sky_sun.exr", "Y");
  const auto both = channel("both.exr", "Y");
  EXPECT_EQ(sky, channel("off.exr", "Y"));
  for (std::size_t i = 0; i < sky.size(); ++i) EXPECT_NEAR(both[i], sky[i] + sun[i], 1e-6f * both[i]);
  EXPECT_GT(*std::max_element(sun.begin(), sun.end()), 1e6f);
  EXPECT_EQ(text(header("off.exr"), "skySunDisc"), "not included");
  EXPECT_NE(text(header("both.exr"), "skySunDisc"), text(header("off.exr"), "skySunDisc"));
  EXPECT_NE(text(header("sky_sun.exr"), "skySunDisc").find("alone"), std::string::npos);
  options = of({SkyChannels::rgb, SkyChannels::xyz}, "cube", 16);
  options.sun = SunPicture::file;
  EXPECT_EQ(picture_files("a/b.exr", options)[3], "a/b_xyz_sun_px.exr");
}

TEST_F(SkyPicture, WrongRequestsAreRefused) {
  PictureOptions options = of({SkyChannels::rgb});
  options.rgb_space = "srgb";
  EXPECT_THROW(write(options), InputError);
  EXPECT_THROW(write(of({SkyChannels::rgb}, "mercator")), InputError);
  EXPECT_THROW(write(of({SkyChannels::rgb}, "latlong", 1)), InputError);
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace skylut
