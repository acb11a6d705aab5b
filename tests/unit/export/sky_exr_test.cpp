#include "skylut/export/sky_exr.hpp"

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "skylut/core/errors.hpp"
#include "skylut/core/version.hpp"
#include "test_map.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

class SkyExr : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(SkyChannels channels, const std::string& name = "sky.exr") {
    const fs::path path = folder_ / name;
    write_sky_exr(path, map_, *projection_, channels, Provenance("skylut map"));
    return path;
  }

  std::vector<float> channel(const fs::path& path, const std::string& name) {
    Imf::InputFile file(path.c_str());
    std::vector<float> pixels(map_.directions.size());
    const auto width = static_cast<std::size_t>(projection_->width());
    Imf::FrameBuffer frame;
    frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), sizeof(float),
                                  width * sizeof(float)));
    file.setFrameBuffer(frame);
    file.readPixels(0, projection_->height() - 1);
    return pixels;
  }

  static std::vector<std::string> channel_names(const fs::path& path) {
    Imf::InputFile file(path.c_str());
    std::vector<std::string> names;
    const Imf::ChannelList& channels = file.header().channels();
    for (auto it = channels.begin(); it != channels.end(); ++it) names.emplace_back(it.name());
    return names;
  }

  const fs::path folder_ = fs::temp_directory_path() / "skylut_sky_exr_test";
  const std::unique_ptr<Projection> projection_ = std::move(make_projections({"latlong", 4, {}}).front());
  const SkyMap map_ = made_up_map(directions_of(*projection_));
};

// Luminance comes back from the linear Rec. 709 values; one 32-bit rounding per channel.
TEST_F(SkyExr, RgbHoldsAbsoluteLuminance) {
  const fs::path path = write(SkyChannels::rgb);
  EXPECT_EQ(channel_names(path), (std::vector<std::string>{"B", "G", "R"}));
  const auto red = channel(path, "R");
  const auto green = channel(path, "G");
  const auto blue = channel(path, "B");
  for (const std::size_t i : {std::size_t{0}, std::size_t{9}, std::size_t{31}}) {
    const Xyz back = to_xyz(LinearRgb{red[i], green[i], blue[i]});
    EXPECT_NEAR(back.Y / map_.colour[i].Y, 1.0, 3e-7);
  }
  Imf::InputFile file(path.c_str());
  EXPECT_EQ(Imf::whiteLuminance(file.header()), 1.0f);
  EXPECT_NEAR(Imf::chromaticities(file.header()).green.y, 0.6f, 1e-6);
  EXPECT_EQ(file.header().findTypedAttribute<Imf::StringAttribute>("envmap"), nullptr);
  EXPECT_FALSE(Imf::hasEnvmap(file.header()));
}

TEST_F(SkyExr, XyzHoldsTristimulusValuesAlone) {
  const fs::path path = write(SkyChannels::xyz);
  EXPECT_EQ(channel_names(path), (std::vector<std::string>{"X", "Y", "Z"}));
  EXPECT_EQ(channel(path, "Y")[5], static_cast<float>(to_xyz(map_.colour[5]).Y));
}

TEST_F(SkyExr, SpectralHoldsTheRadiancesAndAPreview) {
  const fs::path path = write(SkyChannels::spectral);
  const auto names = channel_names(path);
  ASSERT_EQ(names.size(), 3u + 7u);
  EXPECT_EQ(names[3], "S0.400,000000nm");
  const auto blue = channel(path, "S0.450,000000nm");
  for (std::size_t i = 0; i < blue.size(); ++i) EXPECT_EQ(blue[i], map_.spectrum(i)[1]);
  Imf::InputFile file(path.c_str());
  const auto text = [&](const char* name) {
    return file.header().typedAttribute<Imf::StringAttribute>(name).value();
  };
  EXPECT_EQ(text("spectralLayoutVersion"), "1.0");
  EXPECT_EQ(text("emissiveUnits"), "W.m^-2.sr^-1");
  EXPECT_EQ(text("skyRadianceUnit"), "W.m^-2.sr^-1.nm^-1");
}

TEST_F(SkyExr, ExplainsItself) {
  const fs::path path = write(SkyChannels::rgb);
  Imf::InputFile file(path.c_str());
  const Imf::Header& header = file.header();
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("skylutVersion").value(), kVersion);
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("skylutCommand").value(), "skylut map");
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("skylutProvenance").value().front(), '{');
  EXPECT_EQ(header.typedAttribute<Imf::FloatAttribute>("skyAltitudeKm").value(), 6.0f);
  EXPECT_EQ(header.typedAttribute<Imf::FloatAttribute>("skyTurbidity").value(), 0.25f);
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("skyTurbidityKind").value(), "aod500");
  EXPECT_EQ(header.typedAttribute<Imf::FloatAttribute>("skySunZenithDeg").value(), 45.0f);
  EXPECT_EQ(header.typedAttribute<Imf::FloatAttribute>("skySunAzimuthDeg").value(), 90.0f);
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("skyProjection").value(), "latlong");
  EXPECT_NE(header.typedAttribute<Imf::StringAttribute>("skyOrientation").value().find("middle east"),
            std::string::npos);
}

TEST_F(SkyExr, SameMapSameBytes) {
  const auto bytes = [](const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_EQ(bytes(write(SkyChannels::spectral, "a.exr")), bytes(write(SkyChannels::spectral, "b.exr")));
}

TEST_F(SkyExr, AFullDiskIsAnErrorAndLeavesNothing) {
  EXPECT_THROW(write_sky_exr("/dev/full", map_, *projection_, SkyChannels::rgb, Provenance()), WorkError);
  EXPECT_THROW(
      write_sky_exr(folder_ / "missing" / "sky.exr", map_, *projection_, SkyChannels::rgb, Provenance()),
      WorkError);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(SkyExr, PixelsAndDirectionsMustAgree) {
  EXPECT_THROW(write_sky_exr(folder_ / "sky.exr", map_, *make_projections({"latlong", 5, {}}).front(),
                             SkyChannels::rgb, Provenance()),
               InputError);
}

// Monochromatic light of 500 nm lies outside Rec. 709, white light does not.
TEST_F(SkyExr, CountsColoursOutsideRec709) {
  SkyMap map = map_;
  map.colour.assign(map.directions.size(), Yxy{100.0, kD65_x, kD65_y});
  EXPECT_EQ(count_outside_rec709(map), 0u);
  map.colour[3] = {100.0, 0.0082, 0.5384};
  EXPECT_EQ(count_outside_rec709(map), 1u);
}

}  // namespace
}  // namespace skylut
