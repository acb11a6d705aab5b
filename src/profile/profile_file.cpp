#include "profile_file.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "core/toml_reader.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

// A unit that a column may be in: value in the unit of Profile = factor * value + offset.
struct Unit {
  const char* name;
  double factor;
  double offset = 0.0;
  bool mole_fraction = false;
};

const std::vector<Unit> kAltitudeUnits{{"km", 1.0}, {"m", 1e-3}};
const std::vector<Unit> kTemperatureUnits{{"K", 1.0}, {"degC", 1.0, 273.15}};
const std::vector<Unit> kPressureUnits{{"hPa", 1.0}, {"mbar", 1.0}, {"Pa", 1e-2}};
const std::vector<Unit> kGasUnits{{"m-3", 1.0}, {"cm-3", 1e6}, {"ppmv", 1e-6, 0.0, true}};
const std::vector<Unit> kAerosolUnits{{"1", 1.0}, {"km-1", 1.0}, {"m-1", 1.0}};
const std::vector<std::string> kGasNames{"ozone", "water_vapour", "nitrogen_dioxide", "oxygen",
                                         "carbon_dioxide"};

const Unit& unit_of(const TomlReader& column, const std::vector<Unit>& allowed) {
  const std::string name = column.text("unit");
  std::vector<std::string> names;
  for (const Unit& unit : allowed) {
    if (name == unit.name) return unit;
    names.emplace_back(unit.name);
  }
  column.refuse("unit", fmt::format("unknown unit '{}'; expected {}", name, fmt::join(names, " or ")));
}

// Reads the [column.*] tables of one file, in ascending order of altitude.
class ColumnReader {
 public:
  explicit ColumnReader(const TomlReader& columns) : columns_(columns) {
    const TomlReader altitude = columns_.table("altitude");
    const Unit& unit = unit_of(altitude, kAltitudeUnits);
    const std::vector<double> written = altitude.numbers("values");
    order_.resize(written.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](auto a, auto b) { return written[a] < written[b]; });
    for (std::size_t i : order_) altitude_km_.push_back(unit.factor * written[i]);

    for (std::size_t k = 1; k < order_.size(); ++k)
      if (written[order_[k]] == written[order_[k - 1]])
        altitude.refuse("values", order_[k], written[order_[k]],
                        "this altitude is given twice; must be given once");
    const Range ground_km{1e-3 * domain::kGroundHeight_m.lowest, 1e-3 * domain::kGroundHeight_m.highest,
                          "km"};
    if (!ground_km.holds(altitude_km_.front()))
      altitude.refuse("values", order_.front(), written[order_.front()],
                      fmt::format("the lowest level is the ground: must lie within {} to {} km",
                                  ground_km.lowest, ground_km.highest));
    if (altitude_km_.back() < domain::kLowestProfileTop_km)
      altitude.refuse(
          "values", order_.back(), written[order_.back()],
          fmt::format("the highest level must be at {} km or above", domain::kLowestProfileTop_km));
  }

  const std::vector<double>& altitude_km() const { return altitude_km_; }
  bool has(const std::string& name) const { return columns_.has(name); }

  // The column as written, sorted.
  ProfileColumn as_written(const std::string& name) const {
    const TomlReader column = columns_.table(name);
    column.allow_only({"unit", "source", "values"});
    const std::vector<double> written = column.numbers("values");
    if (written.size() != order_.size())
      column.refuse("values", fmt::format("has {} values; must have {}, one for every altitude",
                                          written.size(), order_.size()));
    ProfileColumn result{name, column.text("unit"), column.text("source"), {}};
    for (std::size_t i : order_) result.values.push_back(written[i]);
    return result;
  }

  // Converted values, each >= lowest (or > lowest), <= highest.
  std::vector<double> values(const std::string& name, const Unit& unit, double lowest, bool lowest_allowed,
                             double highest, const char* what_is_right) const {
    const TomlReader column = columns_.table(name);
    const std::vector<double> written = column.numbers("values");
    std::vector<double> result;
    for (std::size_t i : order_) {
      const double value = unit.factor * written[i] + unit.offset;
      if (!(lowest_allowed ? value >= lowest : value > lowest) || value > highest)
        column.refuse("values", i, written[i], what_is_right);
      result.push_back(value);
    }
    return result;
  }

  const Unit& unit(const std::string& name, const std::vector<Unit>& allowed) const {
    return unit_of(columns_.table(name), allowed);
  }

  void require_decrease(const std::string& name, const std::vector<double>& sorted) const {
    for (std::size_t k = 1; k < sorted.size(); ++k)
      if (!(sorted[k] < sorted[k - 1])) {
        const TomlReader column = columns_.table(name);
        column.refuse("values", order_[k], column.numbers("values")[order_[k]],
                      fmt::format("must be less than at the level below ({} km)", altitude_km_[k - 1]));
      }
  }

 private:
  const TomlReader& columns_;
  std::vector<std::size_t> order_;
  std::vector<double> altitude_km_;
};

StandardLayers read_standard_layers(const TomlReader& reader) {
  reader.allow_only({"source", "ground_temperature_K", "ground_pressure_hPa", "base_geopotential_km",
                     "lapse_rate_K_per_km", "upper_altitude_km", "upper_temperature_K",
                     "upper_molar_mass_g_per_mol"});
  StandardLayers layers;
  layers.ground_temperature_K = reader.number("ground_temperature_K");
  layers.ground_pressure_hPa = reader.number("ground_pressure_hPa");
  layers.base_geopotential_km = reader.numbers("base_geopotential_km");
  layers.lapse_rate_K_per_km = reader.numbers("lapse_rate_K_per_km");
  layers.upper_altitude_km = reader.numbers("upper_altitude_km");
  layers.upper_temperature_K = reader.numbers("upper_temperature_K");
  layers.upper_molar_mass_g_per_mol = reader.numbers("upper_molar_mass_g_per_mol");

  const auto positive = [&](const char* key, double value) {
    if (!(value > 0.0)) reader.refuse(key, fmt::format("is {}; must be greater than 0", value));
  };
  positive("ground_temperature_K", layers.ground_temperature_K);
  positive("ground_pressure_hPa", layers.ground_pressure_hPa);
  const auto ascending = [&](const char* key, const std::vector<double>& values) {
    for (std::size_t i = 1; i < values.size(); ++i)
      if (!(values[i] > values[i - 1]))
        reader.refuse(key, i, values[i], "must be greater than the one before");
  };
  ascending("base_geopotential_km", layers.base_geopotential_km);
  ascending("upper_altitude_km", layers.upper_altitude_km);
  if (layers.base_geopotential_km.front() != 0.0)
    reader.refuse("base_geopotential_km", 0, layers.base_geopotential_km.front(), "must be 0, the ground");
  const auto same_length = [&](const char* key, std::size_t size, std::size_t expected) {
    if (size != expected) reader.refuse(key, fmt::format("has {} values; must have {}", size, expected));
  };
  same_length("lapse_rate_K_per_km", layers.lapse_rate_K_per_km.size(), layers.base_geopotential_km.size());
  same_length("upper_temperature_K", layers.upper_temperature_K.size(), layers.upper_altitude_km.size());
  same_length("upper_molar_mass_g_per_mol", layers.upper_molar_mass_g_per_mol.size(),
              layers.upper_altitude_km.size());
  if (layers.upper_altitude_km.size() < 2 ||
      layers.upper_altitude_km.front() <= layers.base_geopotential_km.back())
    reader.refuse("upper_altitude_km", "must hold two or more altitudes above the last layer's base");
  for (std::size_t i = 0; i < layers.upper_altitude_km.size(); ++i) {
    if (!(layers.upper_temperature_K[i] > 0.0))
      reader.refuse("upper_temperature_K", i, layers.upper_temperature_K[i], "must be greater than 0");
    if (!(layers.upper_molar_mass_g_per_mol[i] > 0.0))
      reader.refuse("upper_molar_mass_g_per_mol", i, layers.upper_molar_mass_g_per_mol[i],
                    "must be greater than 0");
  }
  return layers;
}

Report2005 read_report_2005(const TomlReader& reader) {
  reader.allow_only({"ground_ozone_atm_cm", "ozone_decrease_per_km", "printed_altitude_km",
                     "printed_relative_humidity_percent", "printed_precipitable_water_cm"});
  Report2005 report;
  report.ground_ozone_atm_cm = reader.number("ground_ozone_atm_cm");
  report.ozone_decrease_per_km = reader.number("ozone_decrease_per_km");
  report.printed_altitude_km = reader.numbers("printed_altitude_km");
  report.printed_relative_humidity_percent = reader.numbers("printed_relative_humidity_percent");
  report.printed_precipitable_water_cm = reader.numbers("printed_precipitable_water_cm");
  const std::size_t levels = report.printed_altitude_km.size();
  if (levels < 2 || report.printed_relative_humidity_percent.size() != levels ||
      report.printed_precipitable_water_cm.size() != levels)
    reader.refuse("printed_altitude_km", "must have two or more values, as many as the other printed lists");
  return report;
}

TotalColumns read_total(const TomlReader& reader) {
  reader.allow_only({"ozone_du", "nitrogen_dioxide_du", "water_vapour_cm"});
  const auto column = [&](const char* key) -> std::optional<double> {
    if (!reader.has(key)) return std::nullopt;
    const double value = reader.number(key);
    if (!(value >= 0.0)) reader.refuse(key, fmt::format("is {}; must not be negative", value));
    return value;
  };
  return {column("ozone_du"), column("nitrogen_dioxide_du"), column("water_vapour_cm")};
}

// Where the ground is. A lowest level other than 0 is a height above sea level.
std::optional<double> read_ground_height_km(const TomlReader& reader,
                                            const std::vector<double>& altitude_km) {
  const double lowest_km = altitude_km.front();
  if (!reader.has("ground_m")) return lowest_km == 0.0 ? std::nullopt : std::optional(lowest_km);
  const double ground_m = reader.number("ground_m");
  if (!domain::kGroundHeight_m.holds(ground_m))
    reader.refuse("ground_m", fmt::format("is {}; must lie within {} to {} m above sea level", ground_m,
                                          domain::kGroundHeight_m.lowest, domain::kGroundHeight_m.highest));
  if (1e-3 * ground_m < lowest_km - 1e-6)
    reader.refuse("ground_m",
                  fmt::format("is {}; must not lie below the lowest level, {} km", ground_m, lowest_km));
  return 1e-3 * ground_m;
}

void read_columns(const TomlReader& reader, ProfileFile& profile) {
  reader.allow_only({"altitude", "temperature", "pressure", "ozone", "water_vapour", "nitrogen_dioxide",
                     "oxygen", "carbon_dioxide", "aerosol"});
  const ColumnReader columns(reader);
  profile.altitude_km = columns.altitude_km();
  for (const char* name : {"altitude", "temperature", "pressure"})
    if (columns.has(name)) profile.columns.push_back(columns.as_written(name));
  if (columns.has("temperature"))
    profile.temperature_K =
        columns.values("temperature", columns.unit("temperature", kTemperatureUnits), 0.0, false, 2000.0,
                       "must be greater than absolute zero and at most 2000 K");
  if (columns.has("pressure")) {
    profile.pressure_hPa = columns.values("pressure", columns.unit("pressure", kPressureUnits), 0.0, false,
                                          2000.0, "must be greater than 0 and at most 2000 hPa");
    columns.require_decrease("pressure", profile.pressure_hPa);
  }
  for (const std::string& name : kGasNames) {
    if (!columns.has(name)) continue;
    profile.columns.push_back(columns.as_written(name));
    const Unit& unit = columns.unit(name, kGasUnits);
    profile.gases.push_back({name, columns.values(name, unit, 0.0, true, 1e27, "must not be negative")});
    if (unit.mole_fraction) profile.mixing_ratio_gases.push_back(name);
  }
  if (columns.has("aerosol")) {
    profile.columns.push_back(columns.as_written("aerosol"));
    profile.relative_aerosol_extinction = columns.values("aerosol", columns.unit("aerosol", kAerosolUnits),
                                                         0.0, true, 1e27, "must not be negative");
    if (std::accumulate(profile.relative_aerosol_extinction.begin(),
                        profile.relative_aerosol_extinction.end(), 0.0) <= 0.0)
      reader.table("aerosol").refuse("values", "are all 0; one must be greater, or leave the column out");
  }
}

}  // namespace

ProfileFile read_profile_file(const std::string& file) {
  const toml::table document = TomlReader::parse(file);
  const TomlReader reader(document, file, "");
  reader.allow_only({"name", "description", "source", "ground_m", "temperature_and_pressure_of",
                     "standard_layers", "total", "report_2005", "column"});
  ProfileFile profile;
  profile.name = reader.text("name");
  profile.description = reader.text("description");
  profile.source = reader.text("source");
  if (reader.has("standard_layers"))
    profile.standard_layers = read_standard_layers(reader.table("standard_layers"));
  if (reader.has("temperature_and_pressure_of"))
    profile.temperature_and_pressure_of = reader.text("temperature_and_pressure_of");
  if (reader.has("total")) profile.total = read_total(reader.table("total"));
  if (reader.has("report_2005")) profile.report_2005 = read_report_2005(reader.table("report_2005"));
  const TomlReader columns = reader.table("column");
  read_columns(columns, profile);
  profile.ground_height_km = read_ground_height_km(reader, profile.altitude_km);
  if (profile.report_2005 && profile.altitude_km.front() != 0.0)
    reader.refuse("report_2005", "is given by altitude above sea level; the lowest level must be 0");

  const bool computed = profile.standard_layers || !profile.temperature_and_pressure_of.empty();
  for (const char* name : {"temperature", "pressure"}) {
    if (!computed && !columns.has(name))
      columns.refuse(name, "is missing; expected a table with unit, source, values");
    if (computed && columns.has(name))
      columns.refuse(name, "is given although it is computed; leave one of them out");
  }
  if (profile.standard_layers && !profile.temperature_and_pressure_of.empty())
    reader.refuse("temperature_and_pressure_of", "is given beside standard_layers; leave one of them out");
  if (profile.standard_layers &&
      profile.altitude_km.back() > profile.standard_layers->upper_altitude_km.back())
    columns.refuse("altitude", fmt::format("must not exceed the end of standard_layers, {} km",
                                           profile.standard_layers->upper_altitude_km.back()));
  if (!profile.report_2005 && !columns.has("ozone"))
    columns.refuse("ozone", "is missing; expected a table with unit, source, values");
  return profile;
}

}  // namespace skylut
