#include "aerosol_component.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace skylut {

namespace {

constexpr double kSmallestRadius_um = 1e-4;
constexpr double kLargestRadius_um = 100.0;

double number_within(const TomlReader& reader, std::string_view key, double lowest, double highest) {
  const double value = reader.number(key);
  if (!(value >= lowest && value <= highest))
    reader.refuse(key, fmt::format("is {}; must lie within {} to {}", value, lowest, highest));
  return value;
}

// A list with one number per wavelength, or a number for all of them.
std::vector<double> by_wavelength(const TomlReader& reader, std::string_view key, std::size_t count,
                                  double lowest, double highest) {
  std::vector<double> values =
      reader.is_number(key) ? std::vector<double>(count, reader.number(key)) : reader.numbers(key);
  if (values.size() != count)
    reader.refuse(key, fmt::format("has {} values; must have {}, one for every wavelength, or be one number",
                                   values.size(), count));
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(values[i] >= lowest && values[i] <= highest)) {
      const std::string right = fmt::format("must lie within {} to {}", lowest, highest);
      if (reader.is_number(key)) reader.refuse(key, fmt::format("is {}; {}", values[i], right));
      reader.refuse(key, i, values[i], right);
    }
  return values;
}

std::vector<double> read_wavelengths(const TomlReader& reader) {
  if (!reader.has("wavelength_nm")) return {500.0};
  std::vector<double> wavelengths = reader.numbers("wavelength_nm");
  for (std::size_t i = 0; i < wavelengths.size(); ++i)
    if (!(wavelengths[i] > (i == 0 ? 0.0 : wavelengths[i - 1])))
      reader.refuse("wavelength_nm", i, wavelengths[i], "must be greater than the one before, in nm");
  return wavelengths;
}

SizeDistribution::Kind read_kind(const TomlReader& reader) {
  if (!reader.has("distribution")) return SizeDistribution::Kind::lognormal;
  const std::string name = reader.text("distribution");
  if (name == "lognormal") return SizeDistribution::Kind::lognormal;
  if (name == "power-law") return SizeDistribution::Kind::power_law;
  reader.refuse("distribution", fmt::format("is '{}'; must be lognormal or power-law", name));
}

// What depends on humidity: radii and refractive index.
void read_state(const TomlReader& reader, AerosolComponent& component) {
  SizeDistribution& size = component.size;
  size.r_min_um = number_within(reader, "r_min_um", kSmallestRadius_um, kLargestRadius_um);
  size.r_max_um = number_within(reader, "r_max_um", kSmallestRadius_um, kLargestRadius_um);
  if (!(size.r_max_um > size.r_min_um))
    reader.refuse("r_max_um",
                  fmt::format("is {}; must be greater than r_min_um = {}", size.r_max_um, size.r_min_um));
  if (size.kind == SizeDistribution::Kind::lognormal)
    size.mode_radius_um = number_within(reader, "mode_radius_um", kSmallestRadius_um, kLargestRadius_um);
  component.n = by_wavelength(reader, "n", component.wavelength_nm.size(), 0.05, 20.0);
  component.k = by_wavelength(reader, "k", component.wavelength_nm.size(), 0.0, 20.0);
}

// Between two states of the same component.
AerosolComponent blend(AerosolComponent lower, const AerosolComponent& upper, double part) {
  const auto geometric = [part](double a, double b) { return a * std::pow(b / a, part); };
  lower.size.mode_radius_um = geometric(lower.size.mode_radius_um, upper.size.mode_radius_um);
  lower.size.r_min_um = geometric(lower.size.r_min_um, upper.size.r_min_um);
  lower.size.r_max_um = geometric(lower.size.r_max_um, upper.size.r_max_um);
  for (std::size_t i = 0; i < lower.n.size(); ++i) {
    lower.n[i] += part * (upper.n[i] - lower.n[i]);
    lower.k[i] += part * (upper.k[i] - lower.k[i]);
  }
  return lower;
}

AerosolComponent at_humidity(const TomlReader& reader, const AerosolComponent& component,
                             std::optional<double> humidity_percent) {
  std::vector<std::pair<double, AerosolComponent>> states;
  for (const TomlReader& state : reader.tables("humidity")) {
    state.allow_only({"percent", "r_min_um", "r_max_um", "mode_radius_um", "n", "k"});
    const double percent = number_within(state, "percent", 0.0, 99.0);
    if (!states.empty() && !(percent > states.back().first))
      state.refuse("percent", fmt::format("is {}; must be greater than the one before", percent));
    states.emplace_back(percent, component);
    read_state(state, states.back().second);
  }
  if (!humidity_percent)
    reader.refuse("humidity",
                  fmt::format("'{}' takes up water: the aerosol must say humidity_percent", component.name));
  if (*humidity_percent < states.front().first || *humidity_percent > states.back().first)
    reader.refuse("humidity",
                  fmt::format("'{}' is given for {} to {} %; humidity {} % must lie within", component.name,
                              states.front().first, states.back().first, *humidity_percent));
  std::size_t above = 0;
  while (states[above].first < *humidity_percent) ++above;
  if (states[above].first == *humidity_percent) return states[above].second;
  const auto& [from, lower] = states[above - 1];
  const auto& [to, upper] = states[above];
  return blend(lower, upper, (*humidity_percent - from) / (to - from));
}

}  // namespace

ReadComponent read_component(const TomlReader& reader, std::initializer_list<std::string_view> extra_keys,
                             std::optional<double> humidity_percent) {
  std::vector<std::string_view> allowed{"name",           "description",   "source",   "distribution",
                                        "sigma_g",        "exponent",      "r_min_um", "r_max_um",
                                        "mode_radius_um", "wavelength_nm", "n",        "k",
                                        "humidity"};
  allowed.insert(allowed.end(), extra_keys.begin(), extra_keys.end());
  reader.allow_only(allowed);
  ReadComponent result;
  AerosolComponent& component = result.component;
  component.name = reader.text("name");
  if (reader.has("source")) component.source = reader.text("source");
  component.size.kind = read_kind(reader);
  if (component.size.kind == SizeDistribution::Kind::lognormal)
    component.size.sigma_g = number_within(reader, "sigma_g", 1.01, 10.0);
  else
    component.size.exponent = number_within(reader, "exponent", 0.1, 10.0);
  component.wavelength_nm = read_wavelengths(reader);
  result.takes_up_water = reader.has("humidity");
  if (result.takes_up_water)
    component = at_humidity(reader, component, humidity_percent);
  else
    read_state(reader, component);
  return result;
}

}  // namespace skylut
