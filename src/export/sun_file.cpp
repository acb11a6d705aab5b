#include "skylut/export/sun_file.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "skylut/sky/refracted_sun.hpp"

namespace skylut {

namespace {

using Column = std::pair<std::string, std::vector<double>>;

std::vector<Column> irradiance_columns(const SunIrradiance& sun) {
  std::vector<Column> columns{{"direct_normal_w_m2_nm", sun.direct_normal},
                              {"diffuse_horizontal_w_m2_nm", sun.diffuse_horizontal},
                              {"global_horizontal_w_m2_nm", sun.global_horizontal()},
                              {"extraterrestrial_w_m2_nm", sun.extraterrestrial},
                              {"circumsolar_normal_w_m2_nm", sun.circumsolar_normal},
                              {"plane_direct_w_m2_nm", sun.plane_direct},
                              {"plane_sky_w_m2_nm", sun.plane_sky},
                              {"plane_ground_w_m2_nm", sun.plane_ground},
                              {"plane_global_w_m2_nm", sun.plane_global()}};
  std::erase_if(columns, [](const Column& column) { return column.second.empty(); });
  return columns;
}

std::vector<Column> columns_of(const SunIrradiance& sun) {
  std::vector<Column> columns = irradiance_columns(sun);
  for (const ConstituentTransmittance& constituent : sun.transmittance)
    columns.emplace_back("transmittance_" + constituent.name, constituent.band_mean);
  return columns;
}

using Json = nlohmann::ordered_json;

// Nothing for no light.
Json colour_json(const std::optional<LightColour>& light) {
  Json json = Json::object();
  if (!light) return json;
  json["illuminance_lux"] = light->illuminance_lux;
  json["x"] = light->x;
  json["y"] = light->y;
  if (light->temperature) {
    json["cct_k"] = light->temperature->temperature_K;
    json["duv"] = light->temperature->duv;
  }
  json["linear_rec709_lux"] = {light->rgb.r, light->rgb.g, light->rgb.b};
  return json;
}

Json disc_json(const SunAppearance& appearance) {
  Json json{{"angular_diameter_deg", appearance.angular_diameter_deg},
            {"visible_part", appearance.visible_part},
            {"mean_luminance_cd_m2", appearance.mean_luminance_cd_m2}};
  json.update(colour_json(appearance.disc));
  return json;
}

}  // namespace

std::string sun_csv(const SunIrradiance& sun) {
  const std::vector<Column> columns = columns_of(sun);
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "wavelength_nm");
  for (const auto& [name, values] : columns) fmt::format_to(out, ",{}", name);
  text.push_back('\n');
  for (std::size_t i = 0; i < sun.wavelengths.size(); ++i) {
    fmt::format_to(out, "{}", sun.wavelengths[i]);
    for (const auto& [name, values] : columns) fmt::format_to(out, ",{}", values[i]);
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

std::string sun_json(const SunIrradiance& sun, const SunAppearance& appearance, const SkyScene& scene,
                     const std::string& method, const Provenance& provenance) {
  Json json{{"format", "skylut sun"}, {"format_version", 1}};
  const Json how = provenance.json();
  for (const auto& [key, value] : how.items()) json[key] = value;
  const Turbidity& turbidity = scene.turbidities.at(0);
  json["method"] = method;
  json["units"] =
      "irradiance in W m-2 nm-1, means over bands of step_nm around each wavelength; sums in W m-2 and lux";
  json["altitude_km"] = scene.altitudes_km.at(0);
  json["turbidity"] = {{"kind", turbidity_kind_name(turbidity.kind)}, {"value", turbidity.value}};
  json["sun"] = {{"zenith_deg", sun.sun.zenith_deg}, {"azimuth_deg", sun.sun.azimuth_deg}};
  if (const std::optional<RefractedSun> seen = refracted_sun(scene); seen && method == "shells")
    json["sun"].update({{"apparent_zenith_deg", seen->apparent_zenith_deg},
                        {"last_zenith_deg", seen->last_zenith_deg},
                        {"refraction_deg",
                         {{"450", seen->blue_refraction_deg},
                          {"550", seen->refraction_deg},
                          {"650", seen->red_refraction_deg}}},
                        {"vertical_diameter_deg", seen->vertical_diameter_deg},
                        {"horizontal_diameter_deg", seen->horizontal_diameter_deg}});
  if (sun.plane) json["plane"] = {{"tilt_deg", sun.plane->tilt_deg}, {"azimuth_deg", sun.plane->azimuth_deg}};
  json["beam_arrives"] = sun.beam_arrives;
  json["sun_distance_au"] = scene.sun_distance_au;
  json["solar"] = scene.solar;
  json["step_nm"] = sun.wavelengths.step_nm();
  Json& sums = json["sums"] = Json::object();
  for (const auto& [name, values] : irradiance_columns(sun)) {
    const std::string quantity = name.substr(0, name.find("_w_m2_nm"));
    sums[quantity] = {{"w_m2", broadband_W_m2(values, sun.wavelengths)},
                      {"lux", illuminance_lux(values, sun.luminous_weight)}};
  }
  json["disc"] = disc_json(appearance);
  if (appearance.sky) json["sky"] = colour_json(appearance.sky);
  json["wavelength_nm"] = sun.wavelengths.values_nm();
  for (const auto& [name, values] : columns_of(sun)) json[name] = values;
  return json.dump(1) + "\n";
}

}  // namespace skylut
