// How a scene describes itself into the files made from it: with what was used, not with what was asked for.

#include "skylut/sky/sky_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "skylut/atmosphere/atmosphere_description.hpp"
#include "skylut/core/version.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

SkyScene scene_of(const AtmosphereDescription& description) {
  SkyScene scene;
  scene.atmosphere = std::make_shared<const Atmosphere>(build_atmosphere(test::context, description));
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.5}};
  scene.suns = {{60.0, 90.0}};
  scene.directions = directions_utm271();
  scene.directions_name = "utm271";
  scene.place = description.place;
  return scene;
}

nlohmann::ordered_json inputs_of(const AtmosphereDescription& description) {
  return scene_provenance(test::context, scene_of(description), "skylut table").json()["inputs"];
}

TEST(SceneProvenance, HoldsEveryInput) {
  AtmosphereDescription description;
  description.ground_albedo = "0.15";
  const nlohmann::ordered_json json =
      scene_provenance(test::context, scene_of(description), "skylut table --albedo 0.15").json();
  EXPECT_EQ(json["skylut_version"], kVersion);
  EXPECT_EQ(json["command"], "skylut table --albedo 0.15");
  const auto& inputs = json["inputs"];
  EXPECT_EQ(inputs["altitudes_km"], nlohmann::ordered_json::array({0.0}));
  EXPECT_EQ(inputs["turbidities"][0]["kind"], "aod500");
  EXPECT_EQ(inputs["turbidities"][0]["given"], 0.5);
  EXPECT_GT(inputs["turbidities"][0]["preetham-t"], 1.0);
  EXPECT_EQ(inputs["suns"][0]["zenith_deg"], 60.0);
  EXPECT_EQ(inputs["directions"]["name"], "utm271");
  EXPECT_EQ(inputs["directions"]["count"], 271);
  EXPECT_EQ(inputs["wavelengths_nm"]["step"], 5.0);
  EXPECT_EQ(inputs["air"]["ground_albedo"], 0.15);
  EXPECT_EQ(inputs["air"]["aerosol"]["name"], "rural");
  EXPECT_EQ(inputs["profile"]["name"], "ussa1976");
  EXPECT_EQ(inputs["profile"]["altitude_km"].size(), inputs["profile"]["temperature_K"].size());
}

// Each option at another value than the profile's own: the numbers are those of the air that was used.
TEST(SceneProvenance, TheProfileIsTheOneThatWasUsed) {
  AtmosphereDescription description;
  description.ozone_du = 100.0;
  description.no2_du = 5.0;
  description.water_cm = 4.0;
  description.surface_pressure_hPa = 700.0;
  const nlohmann::ordered_json used = inputs_of(description);
  const nlohmann::ordered_json plain = inputs_of({});
  EXPECT_EQ(used["profile"]["pressure_hPa"][0], 700.0);
  EXPECT_EQ(plain["profile"]["pressure_hPa"][0], 1013.25);
  EXPECT_NEAR(used["air"]["ozone_du"].get<double>(), 100.0, 1e-9);
  EXPECT_NEAR(used["air"]["no2_du"].get<double>(), 5.0, 1e-9);
  EXPECT_NEAR(used["air"]["water_cm"].get<double>(), 4.0, 1e-9);
  EXPECT_EQ(used["air"]["surface_pressure_hPa"], 700.0);
  for (const char* gas : {"ozone", "nitrogen_dioxide", "water_vapour", "oxygen"})
    EXPECT_NE(used["profile"]["gas_density_per_m3"][gas], plain["profile"]["gas_density_per_m3"][gas]) << gas;
}

// Two atmospheres, one difference each: their provenances differ.
TEST(SceneProvenance, EveryPartOfAnAtmosphereShows) {
  const nlohmann::ordered_json plain = inputs_of({});
  AtmosphereDescription other;
  other.profile = "tropical";
  EXPECT_NE(inputs_of(other), plain);
  other = {};
  other.aerosol = "desert";
  EXPECT_NE(inputs_of(other)["air"]["aerosol"], plain["air"]["aerosol"]);
  other = {};
  other.aerosol = "urban";
  const nlohmann::ordered_json dry_city = inputs_of(other);
  other.humidity_percent = 95.0;
  EXPECT_NE(inputs_of(other)["air"]["aerosol"], dry_city["air"]["aerosol"]);
  other = {};
  other.ground_albedo = "sand";
  EXPECT_NE(inputs_of(other)["air"]["ground_albedo"], plain["air"]["ground_albedo"]);
  other = {};
  other.place = Place{0.0, 0.0, 0.0};
  EXPECT_NE(inputs_of(other)["air"]["gravity_m_s2"], plain["air"]["gravity_m_s2"]);
  EXPECT_NE(inputs_of(other)["air"]["planet_radius_km"], plain["air"]["planet_radius_km"]);
}

TEST(SceneProvenance, NamesTheFilesThatWereRead) {
  AtmosphereDescription description;
  description.aerosol = "desert";
  description.ground_albedo = "sand";
  const nlohmann::ordered_json json =
      scene_provenance(test::context, scene_of(description), "skylut table").json();
  const auto names = [&](const std::string& name) {
    return std::any_of(json["sources"].begin(), json["sources"].end(),
                       [&](const auto& source) { return source["file"] == name; });
  };
  for (const char* name : {"profiles/ussa1976.toml", "profiles/aerosols/desert.toml",
                           "profiles/aerosols/components/mineral-coarse.toml", "profiles/grounds/sand.csv",
                           "profiles/spectra/solar_astm_g173.csv", "profiles/spectra/water_lines.csv"})
    EXPECT_TRUE(names(name)) << name;
}

// A mountain's air: at 4205 m the standard atmosphere's pressure is 1013.25 (1 - 6.5 H / 288.15)^5.25588 hPa
// with the geopotential height H = 4.2022 km: 600.3 hPa. The Rayleigh depth p / (m g) is as much smaller, but
// for gravity, which falls by 2 h / R on the way up.
TEST(Atmosphere, TheGroundsHeightSetsTheAir) {
  AtmosphereDescription description;
  description.place = Place{19.82, -155.47, 4205.0};
  const Atmosphere mountain = build_atmosphere(test::context, description);
  EXPECT_NEAR(mountain.profile().pressure_hPa.front(), 600.3, 0.2);
  description.place->height_m = 0.0;
  const Atmosphere sea = build_atmosphere(test::context, description);
  EXPECT_EQ(sea.profile().pressure_hPa.front(), 1013.25);
  EXPECT_NEAR(mountain.rayleigh_depth(500.0) / sea.rayleigh_depth(500.0),
              600.3 / 1013.25 * (1.0 + 2.0 * 4.205 / 6371.0), 3e-4);
  description.place->height_m = 4205.0;
  description.surface_pressure_hPa = 900.0;
  EXPECT_EQ(build_atmosphere(test::context, description).profile().pressure_hPa.front(), 900.0);
}

}  // namespace
}  // namespace skylut
