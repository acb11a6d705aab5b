#include "skylut/forms/map_skies.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skylut/core/constants.hpp"
#include "skylut/core/csv.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/fit/fit_sky.hpp"

namespace skylut {

namespace {

namespace fs = std::filesystem;

constexpr double kHorizon_deg = 90.0;

std::vector<fs::path> files_of(const fs::path& input) {
  std::error_code ignored;
  if (!fs::is_directory(input, ignored)) return {input};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(input))
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  if (files.empty())
    throw InputError("{}: holds neither a table nor maps: must have table.json or .csv files",
                     input.string());
  std::sort(files.begin(), files.end());
  return files;
}

double stated(const CsvTable& csv, const char* name, const Range& range) {
  const std::optional<double> value = csv.comment_number(name);
  if (!value)
    throw InputError("{}: does not say its {}: must have a line '# {}=…', as skylut map writes it",
                     csv.path().string(), name, name);
  if (!range.holds(*value))
    throw InputError("{}: {}={}: must lie within {} to {} {}", csv.path().string(), name, *value,
                     range.lowest, range.highest, range.unit);
  return *value;
}

SoughtSky conditions_of(const CsvTable& csv) {
  SoughtSky sky;
  sky.altitude_km = stated(csv, "altitude_km", domain::kObserver_km);
  sky.turbidity = {parse_turbidity_kind(csv.comment("turbidity_kind").value_or("aod500")),
                   stated(csv, "turbidity", domain::kTurbidityValue)};
  sky.sun = {stated(csv, "sun_zenith_deg", domain::kSunZenith_deg),
             stated(csv, "sun_azimuth_deg", domain::kAzimuth_deg)};
  return sky;
}

// Columns L_<nm>, which must be equally spaced to be a grid; none if there are fewer than two.
std::vector<std::pair<double, std::size_t>> band_columns(const CsvTable& csv) {
  std::vector<std::pair<double, std::size_t>> bands;
  for (std::size_t column = 0; column < csv.columns().size(); ++column) {
    const std::string& name = csv.columns()[column];
    if (!name.starts_with("L_")) continue;
    try {
      bands.emplace_back(std::stod(name.substr(2)), column);
    } catch (const std::exception&) {
      throw InputError("{}: column '{}': must be L_<nm>", csv.path().string(), name);
    }
  }
  return bands;
}

std::optional<WavelengthGrid> grid_of(const CsvTable& csv,
                                      const std::vector<std::pair<double, std::size_t>>& bands) {
  if (bands.size() < 2) return std::nullopt;
  const double step = bands[1].first - bands[0].first;
  for (std::size_t i = 1; i < bands.size(); ++i)
    if (std::abs(bands[i].first - bands[0].first - static_cast<double>(i) * step) > 1e-6)
      throw InputError("{}: column L_{}: wavelengths must be equally spaced", csv.path().string(),
                       bands[i].first);
  return WavelengthGrid(bands.front().first, bands.back().first, step);
}

TrainingSky read_sky(const CsvTable& csv, const std::vector<std::pair<double, std::size_t>>& bands) {
  TrainingSky sky;
  sky.conditions = conditions_of(csv);
  const std::size_t zenith = csv.column("zenith_deg");
  const std::size_t azimuth = csv.column("azimuth_deg");
  const std::size_t Y = csv.column("Y_cd_m2");
  const std::size_t x = csv.column("x");
  const std::size_t y = csv.column("y");
  std::vector<double> zenith_rad;
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const Direction view{csv.number(row, zenith), wrapped_azimuth_deg(csv.number(row, azimuth))};
    if (!domain::kAnyZenith_deg.holds(view.zenith_deg))
      throw InputError("{}: zenith_deg {}: must lie within 0 to 180", csv.place(row), view.zenith_deg);
    if (view.zenith_deg > kHorizon_deg) continue;
    const Yxy colour{csv.number(row, Y), csv.number(row, x), csv.number(row, y)};
    if (!(colour.Y > 0.0))
      throw InputError("{}: Y_cd_m2 {}: must be greater than 0", csv.place(row), colour.Y);
    sky.dome.views.push_back(view);
    sky.colours.push_back(colour);
    zenith_rad.push_back(view.zenith_deg * kRadiansPerDegree);
    for (const auto& [wavelength_nm, column] : bands)
      sky.radiance.push_back(static_cast<float>(csv.number(row, column)));
  }
  if (sky.colours.empty())
    throw InputError("{}: no direction up to 90 deg: must have some", csv.path().string());
  sky.dome.solid_angle = solid_angle_weights(zenith_rad);
  const double share = 2.0 * kPi / static_cast<double>(zenith_rad.size());
  for (double& solid_angle : sky.dome.solid_angle) solid_angle *= share;
  return sky;
}

bool same_but_for_azimuth(const SoughtSky& a, const SoughtSky& b) {
  return a.altitude_km == b.altitude_km && a.turbidity.value == b.turbidity.value &&
         a.sun.zenith_deg == b.sun.zenith_deg;
}

void put_into(std::vector<double>& axis, double value) {
  const auto place = std::lower_bound(axis.begin(), axis.end(), value);
  if (place == axis.end() || *place != value) axis.insert(place, value);
}

}  // namespace

MapSkies::MapSkies(const fs::path& file_or_folder)
    : input_(file_or_folder), files_(files_of(file_or_folder)) {
  for (const fs::path& file : files_) {
    const CsvTable csv = CsvTable::read(file);
    const auto bands = band_columns(csv);
    TrainingSky sky = read_sky(csv, bands);
    const std::optional<WavelengthGrid> grid = grid_of(csv, bands);
    if (skies_.empty()) {
      wavelengths_ = grid;
      axes_.turbidity_kind = sky.conditions.turbidity.kind;
    }
    if (grid.has_value() != wavelengths_.has_value() ||
        (grid && grid->values_nm() != wavelengths_->values_nm()))
      throw InputError("{}: wavelengths differ from those of {}: must be the same", file.string(),
                       files_.front().string());
    if (sky.conditions.turbidity.kind != axes_.turbidity_kind)
      throw InputError("{}: turbidity_kind={}: must be that of {}, {}", file.string(),
                       turbidity_kind_name(sky.conditions.turbidity.kind), files_.front().string(),
                       turbidity_kind_name(axes_.turbidity_kind));
    if (std::any_of(skies_.begin(), skies_.end(), [&](const TrainingSky& known) {
          return same_but_for_azimuth(known.conditions, sky.conditions);
        }))
      continue;
    put_into(axes_.altitudes_km, sky.conditions.altitude_km);
    put_into(axes_.turbidities, sky.conditions.turbidity.value);
    put_into(axes_.sun_zeniths_deg, sky.conditions.sun.zenith_deg);
    skies_.push_back(std::move(sky));
  }
}

std::vector<TrainingSky> MapSkies::given(const Context&, const ViewsUnderSun&) const { return skies_; }

std::vector<TrainingSky> MapSkies::simulated(const Context&, std::span<const SoughtSky>,
                                             const ViewsUnderSun&) const {
  throw InputError(
      "{}: the form needs skies of its own choice, which maps do not have: must be a table folder",
      input_.string());
}

}  // namespace skylut
