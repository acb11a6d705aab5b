#include "options/light_kinds.hpp"

#include <gtest/gtest.h>

namespace skylut::cli {
namespace {

template <class T>
std::string refusal(const Kind<T>& kind, const std::string& text) {
  try {
    kind.read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

template <class T>
std::string again(const Kind<T>& kind, const std::string& text) {
  const std::string written = kind.write(kind.read(text));
  EXPECT_EQ(kind.write(kind.read(written)), written);
  return written;
}

TEST(Azimuth, IsBroughtToOneTurn) {
  EXPECT_EQ(again(azimuth(), "-90"), "270");
  EXPECT_EQ(again(azimuth(), "720"), "0");
  EXPECT_EQ(again(azimuth(), "360"), "0");
  EXPECT_EQ(again(azimuth(), "-0"), "0");
  EXPECT_EQ(again(azimuth(), "359.5"), "359.5");
  EXPECT_LT(azimuth().read("-1e-20"), 360.0);
  EXPECT_EQ(refusal(azimuth(), "1e9"), "must be a number within -3600 to 3600 deg");
}

TEST(Suns, AreReadAndWritten) {
  EXPECT_EQ(again(suns(), "90:-90, 45 : 450,0:0"), "90:270,45:90,0:0");
  EXPECT_EQ(refusal(suns(), "100:0"), "zenith angle '100': must be a number within 0 to 99 deg");
  EXPECT_EQ(refusal(suns(), "45"), "'45' must be ZENITH:AZIMUTH in degrees, for example 45:90");
  EXPECT_NE(refusal(suns(), "45:90,"), "read");
  EXPECT_NE(refusal(suns(), "45:90:0"), "read");
}

TEST(RelativeViews, AreFolded) {
  EXPECT_EQ(again(relative_views(), "60:-90,180:270,0:0"), "60:90,180:90,0:0");
}

TEST(Place, TakesDegreesMinutesAndSeconds) {
  EXPECT_EQ(again(latitude(), "48:30S"), "-48.5");
  EXPECT_EQ(again(longitude(), "2d15'E"), "2.25");
  EXPECT_EQ(refusal(latitude(), "91"), "must lie within -90 to 90 degrees");
  EXPECT_NE(refusal(latitude(), "2E"), "read");
  EXPECT_NE(refusal(longitude(), "nan"), "read");
}

TEST(Time, IsWrittenInUtc) {
  EXPECT_EQ(again(time_of_day(), "2024-06-21T11:00+02:00"), "2024-06-21T09:00:00Z");
  EXPECT_EQ(again(day(), "2024-06-21"), "2024-06-21");
  EXPECT_NE(refusal(time_of_day(), "2024-06-21T11:00"), "read");
  EXPECT_NE(refusal(day(), "2024-02-30"), "read");
}

TEST(TimeOrSteps, IsWhicheverWasWritten) {
  EXPECT_EQ(again(time_or_steps(), "2024-06-21T06:00+02:00"), "2024-06-21T04:00:00Z");
  EXPECT_EQ(again(time_or_steps(), "2024-06-21T06:00Z/2024-06-21T07:00Z/30min"),
            "2024-06-21T06:00:00Z/2024-06-21T07:00:00Z/30min");
  EXPECT_NE(refusal(one_time(), "2024-06-21T06:00Z/2024-06-21T07:00Z/30min"), "");
}

TEST(TimeSteps, AreWrittenInUtc) {
  EXPECT_EQ(again(time_steps(), "2024-06-21T06:00+02:00/2024-06-21T20:00Z/PT15M"),
            "2024-06-21T04:00:00Z/2024-06-21T20:00:00Z/15min");
  EXPECT_EQ(refusal(time_steps(), "2024-06-21T06:00Z"),
            "must be START/END/STEP, for example 2024-06-21T04:00Z/2024-06-21T20:00Z/10min");
  EXPECT_EQ(refusal(time_steps(), "2024-06-21T06:00Z/2024-06-20T06:00Z/1h"),
            "end 2024-06-20T06:00:00Z lies before start 2024-06-21T06:00:00Z: must not");
}

TEST(Albedo, IsANumberOrAName) {
  EXPECT_EQ(again(albedo(), "+0.20"), "0.2");
  EXPECT_EQ(again(albedo(), "grass"), "grass");
  EXPECT_EQ(refusal(albedo(), "1.5"), "must be a number within 0 to 1");
}

TEST(Wavelengths, AreReadAndWritten) {
  EXPECT_EQ(again(wavelengths(), "380 : 780 : +5"), "380:780:5");
  EXPECT_EQ(refusal(wavelengths(), "visible"), "expected LO:HI:STEP in nm, for example 380:780:5");
  for (const char* text : {"", "nan:780:5", "380:inf:5", "380:780:0", "380:780:5:1"})
    EXPECT_NE(refusal(wavelengths(), text), "read") << text;
}

TEST(RefractiveIndex, AbsorbsOrNot) {
  EXPECT_EQ(again(refractive_index(), "1.5, 0.01"), "1.5,0.01");
  EXPECT_NE(refusal(refractive_index(), "1.5,-0.01"), "read");
}

}  // namespace
}  // namespace skylut::cli
