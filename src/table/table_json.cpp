#include "skylut/table/table_json.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "skylut/core/sha256.hpp"
#include "skylut/fit/fit_report_json.hpp"
#include "skylut/table/table_csv.hpp"

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
           "F = (1 + A exp(B/cos theta)) (1 + C exp(D gamma) + E cos^2 gamma), gamma in radians; "
           "theta the view's zenith angle times 90/horizon_zenith_deg, gamma the true angle to the sun"},
          {"rmse",
           "Y: relative; x, y: absolute; by solid angle over directions between those of the fit, from the "
           "zenith to horizon_zenith_deg; rmse_horizon: the last 10 deg of them; fit_rmse: over those of the "
           "fit with its weights"},
          {"cost_over_least",
           "the fit's cost over that of its best minimum, less 1: what continuing the neighbours cost"},
          {"Y_below_90", "kcd m-2, mean between 90 deg and the geometric horizon; 0 on the ground"},
          {"light_below_90", "part of all the light from the zenith to the geometric horizon"},
          {"worst_residual", "Y: relative; x, y: absolute; signed, model minus simulation"}};
}

Json channel_json(const FitReport& report, double rmse, const FormulaNotes& notes, double cost_over_least) {
  Json json = fit_report_json(report, as_json(notes.worst_direction));
  json["rmse"] = rmse;
  json["rmse_horizon"] = notes.rmse_horizon;
  json["worst_residual"] = notes.worst;
  json["fit_rmse"] = report.rmse;
  json["cost_over_least"] = cost_over_least;
  return json;
}

Json row_json(std::size_t row, const TableEntry& entry, const SkyFit& fit,
              const std::array<double, 3>& cost_over_least) {
  return {{"row", row},
          {"altitude_km", entry.altitude_km},
          {"turbidity", entry.turbidity},
          {"sun", as_json(entry.sun)},
          {"zenith", {{"Y", entry.zenith.Y}, {"x", entry.zenith.x}, {"y", entry.zenith.y}}},
          {"horizon_zenith_deg", entry.horizon_zenith_deg},
          {"Y_below_90", entry.Y_below_90_kcd_m2},
          {"light_below_90", entry.light_below_90},
          {"Y", channel_json(fit.Y, entry.rmse_Y_rel, entry.notes_Y, cost_over_least[0])},
          {"x", channel_json(fit.x, entry.rmse_x, entry.notes_x, cost_over_least[1])},
          {"y", channel_json(fit.y, entry.rmse_y, entry.notes_y, cost_over_least[2])}};
}

}  // namespace

std::string table_json(const SkyTable& table, const Provenance& provenance) {
  Json file{{"format", "skylut table"}, {"format_version", 1}};
  const Json how = provenance.json();
  for (const auto& [key, value] : how.items()) file[key] = value;
  // By which the table beside is known to be this one.
  file["table_csv"] = {{"file", "table.csv"}, {"sha256", sha256_hex(format_table_csv(table.entries))}};
  file["units"] = units();
  file["fitted_together"] = table.grid;
  if (!table.between_nodes.empty()) file["between_nodes"] = Json::parse(table.between_nodes);
  Json& rows = file["rows"] = Json::array();
  for (std::size_t i = 0; i < table.entries.size(); ++i)
    rows.push_back(row_json(i + 1, table.entries[i], table.fits[i], table.cost_over_least[i]));
  return file.dump(1) + "\n";
}

}  // namespace skylut
