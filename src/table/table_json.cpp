#include "skylut/table/table_json.hpp"

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
           "F = (1 + A exp(B/cos theta)) (1 + C exp(D gamma) + E cos^2 gamma), gamma in radians"},
          {"rmse", "Y: relative; x, y: absolute"},
          {"worst_residual", "Y: relative; x, y: absolute; signed, model minus simulation"}};
}

Json report_json(const FitReport& report, const std::vector<Direction>& directions) {
  return fit_report_json(report, as_json(directions.at(report.worst_direction)));
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

std::string table_json(const SkyTable& table, const std::vector<Direction>& directions,
                       const Provenance& provenance) {
  Json file{{"format", "skylut table"}, {"format_version", 1}};
  const Json how = provenance.json();
  for (const auto& [key, value] : how.items()) file[key] = value;
  // By which the table beside is known to be this one.
  file["table_csv"] = {{"file", "table.csv"}, {"sha256", sha256_hex(format_table_csv(table.entries))}};
  file["units"] = units();
  if (!table.between_nodes.empty()) file["between_nodes"] = Json::parse(table.between_nodes);
  Json& rows = file["rows"] = Json::array();
  for (std::size_t i = 0; i < table.entries.size(); ++i)
    rows.push_back(row_json(i + 1, table.entries[i], table.fits[i], directions));
  return file.dump(1) + "\n";
}

}  // namespace skylut
