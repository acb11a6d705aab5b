#include "skylut/atmosphere/ground_albedo.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "skylut/core/context.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

constexpr const char* kFolder = "grounds";

}  // namespace

std::vector<std::string> GroundAlbedo::names(const Context& context) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(context.data_folder / kFolder, none))
    if (entry.path().extension() == ".csv") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

GroundAlbedo GroundAlbedo::load(const Context& context, const std::string& name_or_file) {
  std::string path = name_or_file;
  if (!names_a_csv_file(name_or_file)) {
    const std::vector<std::string> known = names(context);
    if (std::find(known.begin(), known.end(), name_or_file) == known.end())
      throw InputError("ground albedo '{}': must be a number within 0 to 1, one of {}, or a .csv file",
                       name_or_file, fmt::join(known, ", "));
    path = context.data_file(std::string(kFolder) + "/" + name_or_file + ".csv").string();
  }
  return {name_or_file, read_spectral_curve(path, "albedo", 0.0, 1.0), path};
}

GroundAlbedo GroundAlbedo::parse(const Context& context, const std::string& text) {
  double number = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || stop != text.data() + text.size()) return load(context, text);
  if (!domain::kAlbedo.holds(number))
    throw InputError("ground albedo '{}': must be a number within {} to {}, one of {}, or a .csv file", text,
                     domain::kAlbedo.lowest, domain::kAlbedo.highest, fmt::join(names(context), ", "));
  return number;
}

nlohmann::ordered_json GroundAlbedo::describe() const {
  if (!curve_) return value_;
  std::vector<double> values;
  for (const double nm : curve_->edges_nm()) values.push_back(curve_->at(nm));
  return {{"name", name_}, {"wavelength_nm", curve_->edges_nm()}, {"albedo", values}};
}

void GroundAlbedo::validate() const {
  const double lowest = curve_ ? curve_->lowest() : value_;
  const double highest = curve_ ? curve_->highest() : value_;
  if (!(lowest >= 0.0 && highest <= 1.0))
    throw InputError("ground albedo {}: must lie within 0-1", lowest >= 0.0 ? highest : lowest);
}

std::string GroundAlbedo::text() const { return curve_ ? name_ : fmt::format("{}", value_); }

double GroundAlbedo::at(double wavelength_nm, double band_nm) const {
  if (!curve_) return value_;
  if (!(wavelength_nm >= curve_->first_nm() && wavelength_nm <= curve_->last_nm()))
    throw InputError("ground albedo {}: has no value at {} nm, only within {}-{} nm", name_, wavelength_nm,
                     curve_->first_nm(), curve_->last_nm());
  const double lower = std::max(curve_->first_nm(), wavelength_nm - 0.5 * band_nm);
  const double upper = std::min(curve_->last_nm(), wavelength_nm + 0.5 * band_nm);
  return upper > lower ? curve_->integral(lower, upper) / (upper - lower) : curve_->at(wavelength_nm);
}

}  // namespace skylut
