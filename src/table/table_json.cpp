#include "skylut/table/table_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "skylut/core/constants.hpp"
#include "skylut/core/version.hpp"

namespace skylut {

namespace {

using Json = nlohmann::ordered_json;

Json as_json(const Direction& direction) {
  return {{"zenith_deg", direction.zenith_deg}, {"azimuth_deg", direction.azimuth_deg}};
}

Json units() {
  return {{"altitude_km", "kilometres above the ground"},
          {"zenith_deg", "degrees from the local vertical"},
          {"azimuth_deg", "degrees clockwise from north"},
          {"zenith", "Y in kcd m-2; x, y CIE 1931 2 deg chromaticity"},
          {"formula",
           "v = v_zenith F(theta,gamma)/F(0,theta_sun), "
           "F = (1 + A exp(B/cos theta)) (1 + C exp(D gamma) + E cos^2 gamma), gamma in radians"},
          {"rmse", "Y: relative; x, y: absolute"},
          {"worst_residual", "Y: relative; x, y: absolute; signed, model minus simulation"}};
}

// The atmosphere as it was used, so that the table can be made again without the profile's file.
Json profile_json(const Profile& profile) {
  Json gases = Json::object();
  for (const GasProfile& gas : profile.gases) gases[gas.name] = gas.density_per_m3;
  return {{"name", profile.name},
          {"description", profile.description},
          {"source", profile.source},
          {"described_top_km", profile.described_top_km},
          {"altitude_km", profile.altitude_km},
          {"temperature_K", profile.temperature_K},
          {"pressure_hPa", profile.pressure_hPa},
          {"gas_density_per_m3", gases},
          {"relative_aerosol_extinction", profile.relative_aerosol_extinction}};
}

Json aerosol_json(const AerosolOptics& aerosol) {
  std::vector<double> extinction;
  for (const double nm : aerosol.wavelength_nm) extinction.push_back(aerosol.relative_depth(nm));
  Json json{{"name", aerosol.name},
            {"wavelength_nm", aerosol.wavelength_nm},
            {"relative_extinction", extinction},
            {"single_scattering_albedo", aerosol.single_scattering_albedo},
            {"asymmetry", aerosol.asymmetry}};
  if (aerosol.shape.altitude_km.empty()) {
    json["mixed_layer_km"] = aerosol.shape.mixed_layer_km;
    json["haze_scale_height_km"] = aerosol.shape.haze_scale_height_km;
  } else {
    json["haze_altitude_km"] = aerosol.shape.altitude_km;
    json["haze_relative_extinction"] = aerosol.shape.relative_extinction;
  }
  json["stratospheric_aerosol"] = aerosol.stratospheric_optics().name;
  json["stratospheric_aod500"] = aerosol.shape.stratospheric_aod500;
  json["stratospheric_centre_km"] = aerosol.shape.stratospheric_centre_km;
  json["stratospheric_width_km"] = aerosol.shape.stratospheric_width_km;
  return json;
}

double ozone_column_du(const Profile& profile) {
  const GasProfile* ozone = profile.gas("ozone");
  if (ozone == nullptr) return 0.0;
  return gas_column_per_m2(profile, *ozone, 0.0, profile.altitude_km.back()) / kDobsonUnit_per_m2;
}

// A number, or the name of a curve with the albedo of each band.
Json ground_json(const SkyScene& scene) {
  const GroundAlbedo& ground = scene.air.ground_albedo;
  if (const std::optional<double> number = ground.constant()) return *number;
  std::vector<double> albedo;
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i)
    albedo.push_back(ground.at(scene.wavelengths[i], scene.wavelengths.step_nm()));
  return {{"name", ground.name()}, {"wavelength_nm", scene.wavelengths.values_nm()}, {"albedo", albedo}};
}

Json air_json(const SkyScene& scene, const TableOrigin& origin) {
  Json air = {{"ground_albedo", ground_json(scene)},
              {"ozone_du", scene.air.ozone_du.value_or(ozone_column_du(scene.profile))},
              {"gravity_m_s2", scene.air.gravity_m_s2},
              {"planet_radius_km", scene.air.planet_radius_km}};
  if (origin.place)
    air["place"] = {{"latitude_deg", origin.place->latitude_deg},
                    {"longitude_deg", origin.place->longitude_deg},
                    {"height_m", origin.place->height_m}};
  air["aerosol"] = aerosol_json(scene.air.aerosol);
  return air;
}

// Every kind of turbidity for each value given, as far as it exists in this air.
Json turbidities_json(const Context& context, const SkyScene& scene) {
  const Atmosphere air(context, scene.profile, scene.air);
  Json all = Json::array();
  for (const Turbidity& turbidity : scene.turbidities) {
    Json one = {{"given", turbidity.value}, {"kind", turbidity_kind_name(turbidity.kind)}};
    const double aod500 = to_aod500(turbidity, air);
    for (const TurbidityKind kind : turbidity_kinds())
      one[std::string(turbidity_kind_name(kind))] = from_aod500(aod500, kind, air);
    all.push_back(one);
  }
  return all;
}

Json inputs(const Context& context, const SkyScene& scene, const TableOrigin& origin) {
  Json suns = Json::array();
  for (const Direction& sun : scene.suns) suns.push_back(as_json(sun));
  return {{"altitudes_km", scene.altitudes_km},
          {"turbidities", turbidities_json(context, scene)},
          {"suns", suns},
          {"directions", {{"name", origin.directions}, {"count", scene.directions.size()}}},
          {"wavelengths_nm",
           {{"first", scene.wavelengths.first_nm()},
            {"last", scene.wavelengths.last_nm()},
            {"step", scene.wavelengths.step_nm()}}},
          {"solar", scene.solar},
          {"sun_distance_au", scene.sun_distance_au},
          {"quality", origin.quality},
          {"weights", origin.weights},
          {"air", air_json(scene, origin)},
          {"profile", profile_json(scene.profile)}};
}

Json report_json(const FitReport& report, const std::vector<Direction>& directions) {
  const std::array<double, 5> values = report.coefficients.values();
  Json coefficients = Json::object();
  Json standard_errors = Json::object();
  Json determined = Json::object();
  Json at_bound = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i) {
    coefficients[kPerezNames[i]] = values[i];
    standard_errors[kPerezNames[i]] = report.standard_error[i];
    determined[kPerezNames[i]] = report.determined[i];
    at_bound[kPerezNames[i]] = report.at_bound[i];
  }
  return {{"coefficients", coefficients},
          {"standard_errors", standard_errors},
          {"determined", determined},
          {"at_bound", at_bound},
          {"rmse", report.rmse},
          {"worst_residual", report.worst_residual},
          {"worst_direction", as_json(directions.at(report.worst_direction))},
          {"termination", to_string(report.termination)},
          {"message", report.message},
          {"cost", report.cost},
          {"iterations", report.iterations}};
}

Json row_json(std::size_t row, const TableEntry& entry, const SkyFit& fit,
              const std::vector<Direction>& directions) {
  return {{"row", row},
          {"altitude_km", entry.altitude_km},
          {"turbidity", entry.turbidity},
          {"sun", as_json(entry.sun)},
          {"zenith", {{"Y", entry.zenith.Y}, {"x", entry.zenith.x}, {"y", entry.zenith.y}}},
          {"Y", report_json(fit.Y, directions)},
          {"x", report_json(fit.x, directions)},
          {"y", report_json(fit.y, directions)}};
}

}  // namespace

std::string table_json(const Context& context, const SkyTable& table, const SkyScene& scene,
                       const TableOrigin& origin) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < table.entries.size(); ++i)
    rows.push_back(row_json(i + 1, table.entries[i], table.fits[i], scene.directions));
  const Json file = {{"format", "skylut table"},
                     {"format_version", 1},
                     {"skylut_version", kVersion},
                     {"command", origin.command},
                     {"units", units()},
                     {"inputs", inputs(context, scene, origin)},
                     {"rows", rows}};
  return file.dump(1) + "\n";
}

}  // namespace skylut
