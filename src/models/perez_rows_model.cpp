#include "skylut/models/perez_rows_model.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"
#include "skylut/models/model_conditions.hpp"
#include "skylut/models/perez_channel_sky.hpp"

namespace skylut {

namespace {

using nlohmann::ordered_json;

std::vector<double> axis_of(const std::vector<PerezRow>& rows, double PerezRow::*value) {
  std::vector<double> nodes;
  for (const PerezRow& row : rows) nodes.push_back(row.*value);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::array<std::pair<std::size_t, double>, 2> neighbours(const std::vector<double>& nodes, double value) {
  const Bracket bracket = held_bracket(nodes, value);
  return {{{bracket.below, 1.0 - bracket.part}, {bracket.above, bracket.part}}};
}

std::size_t index_of(const std::vector<double>& nodes, double value) {
  return static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), value) - nodes.begin());
}

PerezRow read_row(const JsonReader& json, std::size_t channels) {
  PerezRow row{.altitude_km = json.at("altitude_km").number(domain::kObserver_km),
               .turbidity = json.at("turbidity").number(domain::kTurbidityValue),
               .sun_zenith_deg = json.at("sun_zenith_deg").number(domain::kSunZenith_deg),
               .coefficients = {},
               .zenith = {}};
  for (const JsonReader& zenith : json.at("zenith").elements()) row.zenith.push_back(zenith.number());
  for (const JsonReader& five : json.at("ABCDE").elements()) {
    const std::vector<JsonReader> k = five.elements();
    if (k.size() != 5) five.refuse("must be [A, B, C, D, E]");
    row.coefficients.push_back({k[0].number(), k[1].number(), k[2].number(), k[3].number(), k[4].number()});
    if (!(row.coefficients.back().B < 0.0))
      five.refuse("must have B < 0, or the sky is infinite at the horizon");
  }
  if (row.zenith.size() != channels) json.at("zenith").refuse("must be one per channel");
  if (row.coefficients.size() != channels) json.at("ABCDE").refuse("must be one per channel");
  return row;
}

}  // namespace

PerezRowsModel::PerezRowsModel(ModelInfo info, SkyChannels channels, std::vector<PerezRow> rows)
    : frame_(std::make_shared<const ModelFrame>(ModelFrame{std::move(info), std::move(channels)})),
      rows_(std::move(rows)),
      altitudes_km_(axis_of(rows_, &PerezRow::altitude_km)),
      turbidities_(axis_of(rows_, &PerezRow::turbidity)),
      suns_deg_(axis_of(rows_, &PerezRow::sun_zenith_deg)) {
  SKYLUT_CHECK(!rows_.empty());
  const std::size_t nodes = altitudes_km_.size() * turbidities_.size() * suns_deg_.size();
  std::vector<std::size_t> grid(nodes, rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::size_t node = (index_of(altitudes_km_, rows_[i].altitude_km) * turbidities_.size() +
                              index_of(turbidities_, rows_[i].turbidity)) *
                                 suns_deg_.size() +
                             index_of(suns_deg_, rows_[i].sun_zenith_deg);
    if (grid[node] != rows_.size())
      throw InputError("rows {} and {} have the same altitude, turbidity and sun: must be different",
                       grid[node] + 1, i + 1);
    grid[node] = i;
  }
  if (rows_.size() == nodes) grid_ = std::move(grid);
}

BlendedSky::Part PerezRowsModel::part(const SkyConditions& conditions, const PerezRow& row,
                                      double weight) const {
  std::vector<ScaledPerez> formulas;
  for (std::size_t i = 0; i < row.coefficients.size(); ++i)
    formulas.push_back(
        scaled_to_zenith(row.coefficients[i], row.zenith[i], row.sun_zenith_deg * kRadiansPerDegree));
  return {weight, std::make_unique<const PerezChannelSky>(frame_, conditions.sun, std::move(formulas))};
}

std::unique_ptr<const Sky> PerezRowsModel::at(const SkyConditions& conditions) const {
  require_within_domain(info(), conditions);
  std::vector<BlendedSky::Part> parts;
  if (grid_.empty()) {
    for (const PerezRow& row : rows_)
      if (row.altitude_km == conditions.altitude_km && row.turbidity == conditions.turbidity.value &&
          row.sun_zenith_deg == conditions.sun.zenith_deg)
        parts.push_back(part(conditions, row, 1.0));
    if (parts.empty())
      throw InputError(
          "altitude {} km, turbidity {}, sun zenith angle {} deg: must be those of one of the model's {} "
          "rows, "
          "which fill no grid",
          conditions.altitude_km, conditions.turbidity.value, conditions.sun.zenith_deg, rows_.size());
    return std::make_unique<const BlendedSky>(frame_, conditions.sun, std::move(parts));
  }
  for (const auto& [altitude, by_altitude] : neighbours(altitudes_km_, conditions.altitude_km))
    for (const auto& [turbidity, by_turbidity] : neighbours(turbidities_, conditions.turbidity.value))
      for (const auto& [sun, by_sun] : neighbours(suns_deg_, conditions.sun.zenith_deg)) {
        const double weight = by_altitude * by_turbidity * by_sun;
        const std::size_t node = (altitude * turbidities_.size() + turbidity) * suns_deg_.size() + sun;
        if (weight > 0.0) parts.push_back(part(conditions, rows_[grid_[node]], weight));
      }
  return std::make_unique<const BlendedSky>(frame_, conditions.sun, std::move(parts));
}

ordered_json PerezRowsModel::json(const SkyChannels& channels, const std::vector<PerezRow>& rows) {
  ordered_json list = ordered_json::array();
  for (const PerezRow& row : rows) {
    ordered_json coefficients = ordered_json::array();
    for (const PerezCoefficients& k : row.coefficients) coefficients.push_back(k.values());
    list.push_back({{"altitude_km", row.altitude_km},
                    {"turbidity", row.turbidity},
                    {"sun_zenith_deg", row.sun_zenith_deg},
                    {"zenith", row.zenith},
                    {"ABCDE", std::move(coefficients)}});
  }
  return {{"channels", channels.json()}, {"rows", std::move(list)}};
}

std::unique_ptr<const SkyModel> PerezRowsModel::read(const ModelInfo& info, const JsonReader& model) {
  SkyChannels channels = SkyChannels::read(model.at("channels"));
  std::vector<PerezRow> rows;
  for (const JsonReader& row : model.at("rows").elements()) rows.push_back(read_row(row, channels.size()));
  try {
    return std::make_unique<const PerezRowsModel>(info, std::move(channels), std::move(rows));
  } catch (const InputError& error) {
    throw InputError("{}: {}", model.at("rows").name(), error.what());
  }
}

}  // namespace skylut
