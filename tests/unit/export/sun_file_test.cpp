#include "skylut/export/sun_file.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace skylut {
namespace {

SunIrradiance two_wavelengths() {
  SunIrradiance sun;
  sun.wavelengths = WavelengthGrid(500.0, 505.0, 5.0);
  sun.sun = {60.0, 180.0};
  sun.beam_arrives = true;
  sun.extraterrestrial = {2.0, 1.9};
  sun.luminous_weight = {1100.0, 1400.0};
  sun.direct_normal = {1.0, 0.5};
  sun.diffuse_horizontal = {0.25, 0.125};
  sun.transmittance = {{"rayleigh", {0.5, 0.25}}, {"aerosol", {1.0, 1.0}}};
  return sun;
}

TEST(SunFile, CsvColumns) {
  const std::string text = sun_csv(two_wavelengths());
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "wavelength_nm,direct_normal_w_m2_nm,diffuse_horizontal_w_m2_nm,global_horizontal_w_m2_nm,"
            "extraterrestrial_w_m2_nm,transmittance_rayleigh,transmittance_aerosol");
  EXPECT_EQ(text.substr(text.rfind("505,")).substr(0, 14), "505,0.5,0.125,");
}

TEST(SunFile, WhatWasNotComputedIsLeftOut) {
  SunIrradiance sun = two_wavelengths();
  sun.diffuse_horizontal.clear();
  sun.circumsolar_normal = {0.01, 0.01};
  EXPECT_EQ(sun_csv(sun),
            "wavelength_nm,direct_normal_w_m2_nm,extraterrestrial_w_m2_nm,circumsolar_normal_w_m2_nm,"
            "transmittance_rayleigh,transmittance_aerosol\n"
            "500,1,2,0.01,0.5,1\n505,0.5,1.9,0.01,0.25,1\n");
}

TEST(SunFile, LightOnAPlane) {
  SunIrradiance sun = two_wavelengths();
  sun.plane = TiltedPlane{90.0, 45.0};
  sun.plane_direct = {0.5, 0.25};
  sun.plane_sky = {0.125, 0.125};
  sun.plane_ground = {0.0625, 0.0};
  const std::string text = sun_csv(sun);
  EXPECT_NE(text.find(",plane_direct_w_m2_nm,plane_sky_w_m2_nm,plane_ground_w_m2_nm,plane_global_w_m2_nm,"),
            std::string::npos);
  EXPECT_NE(text.find(",0.5,0.125,0.0625,0.6875,"), std::string::npos) << text;
  SkyScene scene;
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.1}};
  const auto json = nlohmann::json::parse(sun_json(sun, {}, scene, "shells", Provenance()));
  EXPECT_EQ(json["plane"]["azimuth_deg"], 45.0);
  EXPECT_EQ(json["sums"]["plane_global"]["w_m2"], 5.0 * (0.6875 + 0.375));
}

TEST(SunFile, JsonSaysHowItWasMade) {
  SkyScene scene;
  scene.altitudes_km = {1.5};
  scene.turbidities = {{TurbidityKind::aod500, 0.1}};
  scene.sun_distance_au = 0.99;
  SunAppearance seen;
  seen.angular_diameter_deg = 0.54;
  seen.visible_part = 1.0;
  seen.mean_luminance_cd_m2 = 1.5e9;
  seen.disc = LightColour{1e5, 0.34, 0.35, ColourTemperature{5200.0, 0.002}, {1.1e5, 1e5, 0.8e5}};
  seen.sky = LightColour{1e4, 0.24, 0.24, std::nullopt, {0.6e4, 1e4, 2e4}};
  const auto json =
      nlohmann::json::parse(sun_json(two_wavelengths(), seen, scene, "shells", Provenance("skylut sun …")));
  EXPECT_EQ(json["command"], "skylut sun …");
  EXPECT_EQ(json["sun_distance_au"], 0.99);
  EXPECT_EQ(json["direct_normal_w_m2_nm"], (std::vector<double>{1.0, 0.5}));
  EXPECT_EQ(json["sums"]["direct_normal"]["w_m2"], 7.5);
  EXPECT_GT(json["sums"]["global_horizontal"]["lux"], 0.0);
  EXPECT_EQ(json["transmittance_rayleigh"][1], 0.25);
  EXPECT_EQ(json["disc"]["angular_diameter_deg"], 0.54);
  EXPECT_EQ(json["disc"]["mean_luminance_cd_m2"], 1.5e9);
  EXPECT_EQ(json["disc"]["cct_k"], 5200.0);
  EXPECT_EQ(json["sky"]["linear_rec709_lux"], (std::vector<double>{0.6e4, 1e4, 2e4}));
  EXPECT_FALSE(json["sky"].contains("cct_k"));
}

TEST(SunFile, WhereNoLightIsNoColourIs) {
  SkyScene scene;
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.1}};
  const auto json = nlohmann::json::parse(sun_json(two_wavelengths(), {}, scene, "shells", Provenance()));
  EXPECT_EQ(json["disc"]["visible_part"], 0.0);
  EXPECT_FALSE(json["disc"].contains("x"));
  EXPECT_FALSE(json.contains("sky"));
}

}  // namespace
}  // namespace skylut
