#include "skylut/table/table_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "row_blend.hpp"
#include "row_grid.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"
#include "skylut/models/model_domain.hpp"

namespace skylut {

namespace {

constexpr double kCandelaPerKilocandela = 1000.0;
constexpr double kNearZenith_deg = 5.0;  // a sun and its mirror image are neighbours up to here
constexpr std::size_t kCubicNodes = 4;

Range range_of(const std::vector<double>& values, const char* unit) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  return {*lowest, *highest, unit};
}

ModelInfo info_of(const Table& table) {
  std::vector<double> sun_zeniths;
  for (const Direction& sun : table.axes().suns) sun_zeniths.push_back(sun.zenith_deg);
  ModelInfo info{.name = "table",
                 .title = "fitted table",
                 .source = table.provenance() ? table.provenance()->command : "",
                 .quantities = "Y, x, y",
                 .altitude_km = range_of(table.axes().altitudes_km, "km"),
                 .turbidity_kind = table.turbidity_kind(),
                 .turbidity = range_of(table.axes().turbidities, ""),
                 .sun_zenith_deg = range_of(sun_zeniths, "deg"),
                 .view_zenith_deg = {0.0, 90.0, "deg"}};
  for (const TableEntry& entry : table.entries())
    info.view_zenith_deg.highest = std::max(info.view_zenith_deg.highest, entry.horizon_zenith_deg);
  if (info.sun_zenith_deg.lowest <= kNearZenith_deg) info.sun_zenith_deg.lowest = 0.0;
  return info;
}

// In which skies change smoothly from air without aerosol on: the root of something proportional to its
// optical depth. [fit.md T2]
double smooth_turbidity(double value, TurbidityKind kind) {
  if (kind == TurbidityKind::preetham_t) return std::sqrt(std::max(0.0, value - 1.0));
  if (kind == TurbidityKind::visibility_km) return std::sqrt(1.0 / value);
  return std::sqrt(value);
}

// The same bracket with its part counted along another scale of the nodes.
template <class Scale>
Bracket rescaled(Bracket bracket, const std::vector<double>& nodes, double value, const Scale& scale) {
  if (bracket.part <= 0.0) return bracket;
  const double below = scale(nodes[bracket.below]);
  const double above = scale(nodes[bracket.above]);
  bracket.part = (scale(value) - below) / (above - below);
  return bracket;
}

std::array<std::pair<std::size_t, double>, 2> ends(const Bracket& bracket) {
  return {{{bracket.below, 1.0 - bracket.part}, {bracket.above, bracket.part}}};
}

// The first of the four nodes whose middle pair holds x, or the nearest such four. [fit.md T4]
std::size_t first_of_four(const std::vector<double>& nodes, double x) {
  const std::size_t piece = piece_of(nodes, x);
  return std::min(piece > 0 ? piece - 1 : 0, nodes.size() - kCubicNodes);
}

// Lagrange's weights at x of four nodes.
std::array<double, kCubicNodes> lagrange_weights(const double* nodes, double x) {
  std::array<double, kCubicNodes> weights{1.0, 1.0, 1.0, 1.0};
  for (std::size_t i = 0; i < kCubicNodes; ++i)
    for (std::size_t j = 0; j < kCubicNodes; ++j)
      if (i != j) weights[i] *= (x - nodes[j]) / (nodes[i] - nodes[j]);
  return weights;
}

}  // namespace

PerezSky sky_of(const TableEntry& entry) {
  return {{entry.Y, entry.x, entry.y},
          {entry.zenith.Y * kCandelaPerKilocandela, entry.zenith.x, entry.zenith.y},
          entry.sun,
          entry.horizon_zenith_deg};
}

TableModel::TableModel(Table table, const TableModelOptions& options)
    : table_(std::move(table)), options_(options), info_(info_of(table_)) {
  if (std::optional<RowGrid> grid = RowGrid::of(table_))
    grid_ = std::make_unique<const RowGrid>(std::move(*grid));
}

TableModel::~TableModel() = default;

std::string TableModel::rule() const {
  const char* const values =
      "means of ln Y, ln x, ln y of the rows around, each by its own formula at the view's angle to the sun "
      "asked for; linear in the square root of the aerosol's optical depth and in the sun's zenith angle";
  if (options_.rule == TableRule::blend) return fmt::format("{} and in altitude", values);
  return fmt::format("Y, x, y by Lagrange's cubic through four altitudes (UTM report 2005); {}", values);
}

const TableEntry* TableModel::row(const SkyConditions& conditions) const {
  const TableEntry* const exact =
      table_.find(conditions.altitude_km, conditions.turbidity.value, conditions.sun);
  if (exact != nullptr) return exact;
  const auto same = [&](const TableEntry& entry) {
    return entry.altitude_km == conditions.altitude_km && entry.turbidity == conditions.turbidity.value &&
           entry.sun.zenith_deg == conditions.sun.zenith_deg;
  };
  const auto found = std::find_if(table_.entries().begin(), table_.entries().end(), same);
  return found == table_.entries().end() ? nullptr : &*found;
}

bool TableModel::is_node(const SkyConditions& conditions) const { return row(conditions) != nullptr; }

std::unique_ptr<const Sky> TableModel::at(const SkyConditions& conditions) const {
  if (conditions.turbidity.kind != info_.turbidity_kind)
    throw InputError("turbidity of kind {}: must be the table's, {}",
                     turbidity_kind_name(conditions.turbidity.kind),
                     turbidity_kind_name(info_.turbidity_kind));
  if (const TableEntry* const entry = row(conditions)) {
    const PerezSky own = sky_of(*entry);
    return std::make_unique<const PerezSky>(own.coefficients(), own.zenith(), conditions.sun,
                                            own.horizon_zenith_deg());
  }
  const std::vector<std::string> outside = outside_domain(info_, conditions);
  if (!outside.empty() && !options_.extrapolate)
    throw InputError("{}: must lie within what the table has", fmt::join(outside, ", "));
  if (grid_)
    return options_.rule == TableRule::utm2005
               ? summed_over_altitudes(conditions)
               : blended(conditions, horizon_zenith_deg(conditions.altitude_km));
  std::vector<std::string> suns;
  for (const Direction& sun : table_.axes().suns)
    suns.push_back(fmt::format("{}:{}", sun.zenith_deg, sun.azimuth_deg));
  throw InputError(
      "altitude {} km, turbidity {}, sun {}:{} deg: must be those of a row, as the table lacks rows to "
      "interpolate "
      "between; it has some of altitudes {} km, turbidities {}, suns {}",
      conditions.altitude_km, conditions.turbidity.value, conditions.sun.zenith_deg,
      conditions.sun.azimuth_deg, fmt::join(table_.axes().altitudes_km, ", "),
      fmt::join(table_.axes().turbidities, ", "), fmt::join(suns, ", "));
}

std::unique_ptr<const Sky> TableModel::blended(const SkyConditions& conditions,
                                               double horizon_zenith_deg) const {
  const double turbidity = conditions.turbidity.value;
  const Bracket altitudes = held_bracket(grid_->altitudes_km(), conditions.altitude_km);
  const Bracket turbidities =
      rescaled(held_bracket(grid_->turbidities(), turbidity), grid_->turbidities(), turbidity,
               [this](double value) { return smooth_turbidity(value, info_.turbidity_kind); });
  const Bracket suns = held_bracket(grid_->sun_zeniths_deg(), conditions.sun.zenith_deg);
  std::vector<WeightedRow> rows;
  for (const auto& [altitude, of_altitude] : ends(altitudes))
    for (const auto& [load, of_load] : ends(turbidities))
      for (const auto& [sun, of_sun] : ends(suns)) {
        const double weight = of_altitude * of_load * of_sun;
        if (weight != 0.0) rows.push_back({&table_.entries()[grid_->row(altitude, load, sun)], weight});
      }
  return std::make_unique<const RowBlend>(rows, conditions.sun, horizon_zenith_deg);
}

// The dip of the horizon goes with the root of the altitude.
double TableModel::horizon_zenith_deg(double altitude_km) const {
  const Bracket altitudes = rescaled(held_bracket(grid_->altitudes_km(), altitude_km), grid_->altitudes_km(),
                                     altitude_km, [](double value) { return std::sqrt(value); });
  const auto at = [&](std::size_t altitude) {
    return table_.entries()[grid_->row(altitude, 0, 0)].horizon_zenith_deg;
  };
  return linear(at(altitudes.below), at(altitudes.above), altitudes.part);
}

Range TableModel::view_zenith_deg(const SkyConditions& conditions) const {
  const TableEntry* const entry = row(conditions);
  if (entry == nullptr && !grid_) return info_.view_zenith_deg;
  return {0.0, entry != nullptr ? entry->horizon_zenith_deg : horizon_zenith_deg(conditions.altitude_km),
          "deg"};
}

std::unique_ptr<const Sky> TableModel::summed_over_altitudes(const SkyConditions& conditions) const {
  const std::vector<double>& nodes = grid_->altitudes_km();
  if (nodes.size() < kCubicNodes)
    throw InputError("interpolation utm2005: needs a table of at least {} altitudes, this one has {}",
                     kCubicNodes, nodes.size());
  const double altitude_km = std::clamp(conditions.altitude_km, nodes.front(), nodes.back());
  const std::size_t first = first_of_four(nodes, altitude_km);
  const auto weights = lagrange_weights(&nodes[first], altitude_km);
  std::vector<std::pair<std::unique_ptr<const Sky>, double>> skies;
  for (std::size_t i = 0; i < kCubicNodes; ++i) {
    SkyConditions of_layer = conditions;
    of_layer.altitude_km = nodes[first + i];
    skies.emplace_back(blended(of_layer, horizon_zenith_deg(altitude_km)), weights[i]);
  }
  return std::make_unique<const LayerSum>(std::move(skies));
}

}  // namespace skylut
