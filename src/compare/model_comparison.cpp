#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "compared_entry.hpp"
#include "skylut/compare/comparisons.hpp"
#include "skylut/compare/metrics.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/table/table_model.hpp"

namespace skylut {

namespace {

constexpr double kCandelaPerKilocandela = 1000.0;

// "preetham-t" as a column's name.
std::string column_of(TurbidityKind kind) {
  std::string name(turbidity_kind_name(kind));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

ComparedSky their_sky(const ModelInfo& info, const Sky& sky) {
  ComparedSky theirs{info.name, "_" + info.name, "kcd_m2", sky.colour(Direction{}), {}};
  theirs.zenith->Y /= kCandelaPerKilocandela;
  if (const auto* perez = dynamic_cast<const PerezSky*>(&sky)) {
    const PerezYxy& k = perez->coefficients();
    theirs.coefficients = {{"Y", k.Y}, {"x", k.x}, {"y", k.y}};
  }
  return theirs;
}

std::vector<Yxy> colours_of(const Sky& sky, const std::vector<Direction>& views) {
  std::vector<Yxy> colours(views.size());
  sky.colour(views, colours);
  return colours;
}

// The difference over the dome; where the model has none, the verdict says why.
std::optional<SkyDifference> dome_difference(const Sky& ours, const Sky& theirs, std::string& verdict) {
  const std::vector<Direction> views = directions_utm271();
  std::vector<Yxy> reference;
  try {
    reference = colours_of(theirs, views);
  } catch (const InputError& error) {
    verdict += fmt::format(", {}", error.what());
    return {};
  }
  if (!std::all_of(reference.begin(), reference.end(), [](const Yxy& colour) { return colour.Y > 0.0; })) {
    verdict += ", the model's luminance is not positive everywhere";
    return {};
  }
  return difference(colours_of(ours, views), reference);
}

CompareRow row_of(const TableEntry& entry, double turbidity, const SkyModel& model) {
  const ModelInfo& info = model.info();
  const std::unique_ptr<const Sky> theirs = model.at(
      {.altitude_km = entry.altitude_km, .turbidity = {info.turbidity_kind, turbidity}, .sun = entry.sun});
  std::string verdict = "in range";
  if (turbidity < info.turbidity.lowest)
    verdict = fmt::format("{} below {}", turbidity_kind_name(info.turbidity_kind), info.turbidity.lowest);
  if (turbidity > info.turbidity.highest)
    verdict = fmt::format("{} above {}", turbidity_kind_name(info.turbidity_kind), info.turbidity.highest);
  CompareRow row;
  row.has_difference = true;
  row.difference = dome_difference(sky_of(entry), *theirs, verdict);
  row.facts = {{"altitude_km", entry.altitude_km},          {"turbidity", entry.turbidity},
               {column_of(info.turbidity_kind), turbidity}, {"sun_zenith_deg", entry.sun.zenith_deg},
               {"sun_azimuth_deg", entry.sun.azimuth_deg},  {"range", verdict}};
  row.skies = {our_sky(&entry), their_sky(info, *theirs)};
  return row;
}

}  // namespace

CompareReport compare_with_model(const Context& context, const Table& table, const SkyModel& model) {
  const ModelInfo& info = model.info();
  const std::vector<double> converted = table.turbidities_as(context, info.turbidity_kind);
  std::map<double, double> turbidity_of;
  for (std::size_t i = 0; i < converted.size(); ++i) turbidity_of[table.axes().turbidities[i]] = converted[i];

  CompareReport report;
  report.name = info.name;
  report.notes = {
      fmt::format("{} ({}); {} {}", info.title, info.source, turbidity_kind_name(info.turbidity_kind),
                  table.conversion_source(info.turbidity_kind)),
      fmt::format("meant for {} {} to {}; differences are ours minus theirs over 271 directions, Y "
                  "relative to theirs",
                  turbidity_kind_name(info.turbidity_kind), info.turbidity.lowest, info.turbidity.highest)};
  for (const TableEntry& entry : table.entries())
    if (info.altitude_km.holds(entry.altitude_km) && info.sun_zenith_deg.holds(entry.sun.zenith_deg))
      report.rows.push_back(row_of(entry, turbidity_of.at(entry.turbidity), model));
  const std::string where =
      fmt::format("altitude {} to {} km, sun zenith angle {} to {} deg", info.altitude_km.lowest,
                  info.altitude_km.highest, info.sun_zenith_deg.lowest, info.sun_zenith_deg.highest);
  if (report.rows.empty())
    throw InputError("table of {} rows: none at {}, must have at least one", table.entries().size(), where);
  if (const std::size_t left_out = table.entries().size() - report.rows.size(); left_out > 0)
    report.notes.push_back(fmt::format("{} rows left out: not at {}", left_out, where));
  return report;
}

}  // namespace skylut
