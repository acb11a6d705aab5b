#include "skylut/models/preetham_model.hpp"

#include <utility>

#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/interpolation.hpp"
#include "skylut/models/model_conditions.hpp"
#include "skylut/models/perez_channel_sky.hpp"

namespace skylut {

namespace {

using nlohmann::ordered_json;

constexpr double kCandelaPerKilocandela = 1000.0;

ordered_json linear_json(const PreethamMatrices::Linear& linear) { return {linear.slope, linear.offset}; }

ordered_json perez_json(const PreethamMatrices::Perez& perez) {
  ordered_json json;
  for (std::size_t i = 0; i < perez.size(); ++i) json[kPerezNames[i]] = linear_json(perez[i]);
  return json;
}

ordered_json matrices_json(const PreethamMatrices& m) {
  return {{"Y", perez_json(m.Y)},
          {"x", perez_json(m.x)},
          {"y", perez_json(m.y)},
          {"zenith_Y_kcd_m2",
           {{"chi_offset", m.zenith_Y.chi_offset},
            {"chi_divisor", m.zenith_Y.chi_divisor},
            {"tan_chi", linear_json(m.zenith_Y.tangent)},
            {"rest", linear_json(m.zenith_Y.rest)}}},
          {"zenith_x", m.zenith_x},
          {"zenith_y", m.zenith_y}};
}

std::vector<double> numbers(const JsonReader& json, std::size_t count) {
  const std::vector<JsonReader> elements = json.elements();
  if (elements.size() != count) json.refuse("must hold " + std::to_string(count) + " numbers");
  std::vector<double> values;
  for (const JsonReader& element : elements) values.push_back(element.number());
  return values;
}

PreethamMatrices::Linear read_linear(const JsonReader& json) {
  const std::vector<double> values = numbers(json, 2);
  return {values[0], values[1]};
}

PreethamMatrices::Perez read_perez(const JsonReader& json) {
  PreethamMatrices::Perez perez;
  for (std::size_t i = 0; i < perez.size(); ++i) perez[i] = read_linear(json.at(kPerezNames[i]));
  return perez;
}

PreethamMatrices::Chromaticity read_chromaticity(const JsonReader& json) {
  const std::vector<JsonReader> rows = json.elements();
  if (rows.size() != 3) json.refuse("must hold 3 rows");
  PreethamMatrices::Chromaticity matrix{};
  for (std::size_t row = 0; row < matrix.size(); ++row) {
    const std::vector<double> values = numbers(rows[row], matrix[row].size());
    std::copy(values.begin(), values.end(), matrix[row].begin());
  }
  return matrix;
}

PreethamMatrices read_matrices(const JsonReader& json) {
  const JsonReader zenith = json.at("zenith_Y_kcd_m2");
  return {.Y = read_perez(json.at("Y")),
          .x = read_perez(json.at("x")),
          .y = read_perez(json.at("y")),
          .zenith_Y = {.chi_offset = zenith.at("chi_offset").number(),
                       .chi_divisor = zenith.at("chi_divisor").number(),
                       .tangent = read_linear(zenith.at("tan_chi")),
                       .rest = read_linear(zenith.at("rest"))},
          .zenith_x = read_chromaticity(json.at("zenith_x")),
          .zenith_y = read_chromaticity(json.at("zenith_y"))};
}

}  // namespace

PreethamModel::PreethamModel(ModelInfo info, std::vector<PreethamLevel> levels)
    : frame_(std::make_shared<const ModelFrame>(ModelFrame{std::move(info), {}})),
      levels_(std::move(levels)) {
  SKYLUT_CHECK(!levels_.empty());
}

std::unique_ptr<const Sky> PreethamModel::at(const SkyConditions& conditions) const {
  require_within_domain(info(), conditions);
  const double T = conditions.turbidity.value;
  const double sun_rad = conditions.sun.zenith_deg * kRadiansPerDegree;
  std::vector<double> altitudes_km;
  for (const PreethamLevel& level : levels_) altitudes_km.push_back(level.altitude_km);
  const Bracket bracket = held_bracket(altitudes_km, conditions.altitude_km);
  std::vector<BlendedSky::Part> parts;
  for (const auto& [level, weight] :
       {std::pair(bracket.below, 1.0 - bracket.part), std::pair(bracket.above, bracket.part)}) {
    if (weight == 0.0) continue;
    const PreethamMatrices& matrices = levels_[level].matrices;
    const PerezYxy perez = matrices.coefficients(T);
    const Yxy zenith = matrices.zenith_kcd_m2(T, sun_rad);
    std::vector<ScaledPerez> formulas{scaled_to_zenith(perez.Y, kCandelaPerKilocandela * zenith.Y, sun_rad),
                                      scaled_to_zenith(perez.x, zenith.x, sun_rad),
                                      scaled_to_zenith(perez.y, zenith.y, sun_rad)};
    parts.push_back(
        {weight, std::make_unique<const PerezChannelSky>(frame_, conditions.sun, std::move(formulas))});
  }
  return std::make_unique<const BlendedSky>(frame_, conditions.sun, std::move(parts));
}

ordered_json PreethamModel::json(const std::vector<PreethamLevel>& levels) {
  ordered_json json = ordered_json::array();
  for (const PreethamLevel& level : levels) {
    ordered_json one{{"altitude_km", level.altitude_km}};
    one.update(matrices_json(level.matrices));
    json.push_back(std::move(one));
  }
  return {{"levels", std::move(json)}};
}

std::unique_ptr<const SkyModel> PreethamModel::read(const ModelInfo& info, const JsonReader& model) {
  std::vector<PreethamLevel> levels;
  for (const JsonReader& level : model.at("levels").elements()) {
    const JsonReader altitude = level.at("altitude_km");
    levels.push_back({altitude.number(domain::kObserver_km), read_matrices(level)});
    if (levels.size() > 1 && !(levels.back().altitude_km > levels[levels.size() - 2].altitude_km))
      altitude.refuse("must be above the level before");
  }
  return std::make_unique<const PreethamModel>(info, std::move(levels));
}

}  // namespace skylut
