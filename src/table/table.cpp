#include "skylut/table/table.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"
#include "skylut/profile/profile.hpp"
#include "skylut/table/table_csv.hpp"
#include "table_json_reader.hpp"

namespace skylut {

namespace fs = std::filesystem;

namespace {

template <class T>
void append_if_new(std::vector<T>& values, const T& value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

// Proportional to optical depth but for a constant, and back.
double straight(double value, TurbidityKind kind) {
  return kind == TurbidityKind::visibility_km ? 1.0 / value : value;
}
double not_straight(double value, TurbidityKind kind) { return straight(value, kind); }

}  // namespace

Table::Table(std::vector<TableEntry> entries, TurbidityKind kind)
    : entries_(std::move(entries)), kind_(kind) {
  if (entries_.empty()) throw InputError("table without rows: must have at least one");
  std::map<std::tuple<double, double, double, double>, std::size_t> row_of;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const TableEntry& e = entries_[i];
    const auto [first, is_new] =
        row_of.emplace(std::tuple(e.altitude_km, e.turbidity, e.sun.zenith_deg, e.sun.azimuth_deg), i);
    if (!is_new)
      throw InputError("table rows {} and {}: both at altitude {} km, turbidity {}, sun {}:{}, must differ",
                       first->second + 1, i + 1, e.altitude_km, e.turbidity, e.sun.zenith_deg,
                       e.sun.azimuth_deg);
    append_if_new(axes_.altitudes_km, e.altitude_km);
    append_if_new(axes_.turbidities, e.turbidity);
    append_if_new(axes_.suns, e.sun);
  }
}

Table Table::read(const fs::path& folder_or_csv, std::optional<TurbidityKind> kind) {
  const fs::path csv = fs::is_directory(folder_or_csv) ? folder_or_csv / "table.csv" : folder_or_csv;
  Table table(read_table_csv(csv));
  const fs::path json = csv.parent_path() / "table.json";
  if (fs::is_regular_file(json))
    if (std::optional<TableManifest> manifest = read_table_json(json, csv)) {
      table.kind_ = manifest->turbidity_kind;
      table.provenance_ = std::move(manifest->provenance);
      table.listed_ = std::move(manifest->turbidities);
    }
  if (!kind) return table;
  if (table.provenance_ && table.kind_ != *kind)
    throw InputError("turbidity kind {}: {} says {}", turbidity_kind_name(*kind), json.string(),
                     turbidity_kind_name(table.kind_));
  table.kind_ = *kind;
  return table;
}

const TableEntry* Table::find(double altitude_km, double turbidity, const Direction& sun) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const TableEntry& entry) {
    return entry.altitude_km == altitude_km && entry.turbidity == turbidity && entry.sun == sun;
  });
  return found == entries_.end() ? nullptr : &*found;
}

std::vector<double> Table::turbidities_as(const Context& context, TurbidityKind kind) const {
  if (kind == kind_) return axes_.turbidities;
  std::vector<double> converted;
  if (provenance_) {
    for (const double value : axes_.turbidities) {
      const auto listed = std::find_if(listed_.begin(), listed_.end(),
                                       [&](const ListedTurbidity& one) { return one.given == value; });
      if (listed == listed_.end() || !listed->by_kind.contains(kind))
        throw InputError("turbidity {} of the table: its table.json must list it in {}", value,
                         turbidity_kind_name(kind));
      converted.push_back(listed->by_kind.at(kind));
    }
    return converted;
  }
  const Atmosphere air(context, load_profile(context, "ussa1976"), {});
  for (const double value : axes_.turbidities)
    converted.push_back(from_aod500(to_aod500({kind_, value}, air), kind, air));
  return converted;
}

Turbidity Table::in_own_kind(const Context& context, const Turbidity& turbidity) const {
  if (turbidity.kind == kind_) return turbidity;
  if (!provenance_) {
    const Atmosphere air(context, load_profile(context, "ussa1976"), {});
    return {kind_, from_aod500(to_aod500(turbidity, air), kind_, air)};
  }
  const std::vector<double> others = turbidities_as(context, turbidity.kind);
  std::map<double, double> own_of;  // by what is proportional to optical depth
  for (std::size_t i = 0; i < others.size(); ++i)
    own_of[straight(others[i], turbidity.kind)] = straight(axes_.turbidities[i], kind_);
  const double value = straight(turbidity.value, turbidity.kind);
  if (const auto found = own_of.find(value); found != own_of.end())
    return {kind_, not_straight(found->second, kind_)};
  if (own_of.size() < 2)
    throw InputError("turbidity {} ({}): the table has one turbidity only, {} ({}), and converts no other",
                     turbidity.value, turbidity_kind_name(turbidity.kind), axes_.turbidities.front(),
                     turbidity_kind_name(kind_));
  auto above = own_of.upper_bound(value);
  if (above == own_of.begin()) ++above;
  if (above == own_of.end()) --above;
  const auto below = std::prev(above);
  const double part = (value - below->first) / (above->first - below->first);
  return {kind_, not_straight(linear(below->second, above->second, part), kind_)};
}

std::string Table::conversion_source(TurbidityKind kind) const {
  if (kind == kind_) return "as the table has it";
  if (provenance_) return "as table.json converts it";
  return "from " + std::string(turbidity_kind_name(kind_)) + " in the 1976 standard atmosphere";
}

}  // namespace skylut
