#include "skylut/scattering/aerosol_shape.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

// ∫₀^z of the haze: constant to h, exp(-(z-h)/H) above.
double mixed_below(const AerosolShape& shape, double z) {
  const double mixed = std::min(z, shape.mixed_layer_km);
  const double above = std::max(0.0, z - shape.mixed_layer_km);
  return mixed - shape.haze_scale_height_km * std::expm1(-above / shape.haze_scale_height_km);
}

// Extinction of the table at an altitude inside piece i.
double table_value(const AerosolShape& shape, std::size_t i, double z) {
  const double lower = shape.relative_extinction[i];
  const double upper = shape.relative_extinction[i + 1];
  const double part = (z - shape.altitude_km[i]) / (shape.altitude_km[i + 1] - shape.altitude_km[i]);
  if (lower > 0.0 && upper > 0.0) return lower * std::pow(upper / lower, part);
  return lower + part * (upper - lower);
}

// ∫ of the table below an altitude, every piece in closed form.
double table_below(const AerosolShape& shape, double z) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < shape.altitude_km.size() && z > shape.altitude_km[i]; ++i) {
    const double end = std::min(z, shape.altitude_km[i + 1]);
    const double lower = shape.relative_extinction[i];
    const double upper = table_value(shape, i, end);
    const double thickness = end - shape.altitude_km[i];
    // The mean of an exponential by its ends; their plain mean where the piece is linear or as good as
    // constant.
    const bool exponential = lower > 0.0 && shape.relative_extinction[i + 1] > 0.0;
    const double ratio = exponential ? std::log(upper / lower) : 0.0;
    sum += thickness * (std::abs(ratio) > 1e-6 ? (upper - lower) / ratio : 0.5 * (lower + upper));
  }
  return sum;
}

double haze_below(const AerosolShape& shape, double z) {
  return shape.altitude_km.empty() ? mixed_below(shape, z) : table_below(shape, z);
}

double haze_value(const AerosolShape& shape, double z) {
  if (shape.altitude_km.empty())
    return std::exp(-std::max(0.0, z - shape.mixed_layer_km) / shape.haze_scale_height_km);
  if (z > shape.altitude_km.back()) return 0.0;
  const auto above = std::upper_bound(shape.altitude_km.begin() + 1, shape.altitude_km.end() - 1, z) -
                     shape.altitude_km.begin();
  return table_value(shape, static_cast<std::size_t>(above) - 1, z);
}

// ∫₀^z of a Gaussian of unit area.
double gaussian_below(const AerosolShape& shape, double altitude_km) {
  const auto cumulative = [&](double z) {
    return 0.5 *
           std::erf((z - shape.stratospheric_centre_km) / (shape.stratospheric_width_km * std::sqrt(2.0)));
  };
  return cumulative(altitude_km) - cumulative(0.0);
}

void validate_table(const AerosolShape& shape) {
  const std::vector<double>& z = shape.altitude_km;
  if (z.size() != shape.relative_extinction.size() || z.size() < 2)
    throw InputError("aerosol shape with {} altitudes and {} values: must have as many of each, at least 2",
                     z.size(), shape.relative_extinction.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (!(i == 0 ? z[i] == 0.0 : z[i] > z[i - 1]))
      throw InputError("aerosol shape altitude {} km: must begin with 0 and ascend", z[i]);
    if (!(shape.relative_extinction[i] >= 0.0) || !std::isfinite(shape.relative_extinction[i]))
      throw InputError("aerosol shape value {} at {} km: must be finite and not negative",
                       shape.relative_extinction[i], z[i]);
    largest = std::max(largest, shape.relative_extinction[i]);
  }
  if (largest == 0.0) throw InputError("aerosol shape: must not be 0 at all altitudes");
  if (z.back() > 100.0) throw InputError("aerosol shape altitude {} km: must be 100 km or less", z.back());
}

void require(const char* what, double value, double lowest, double highest, const char* unit) {
  if (!(value >= lowest && value <= highest))
    throw InputError("{} {}{}: must lie within {}-{}{}", what, value, unit, lowest, highest, unit);
}

}  // namespace

double AerosolShape::stratospheric_share(double aod500) const {
  return aod500 > stratospheric_aod500 ? stratospheric_aod500 / aod500 : 1.0;
}

double AerosolShape::haze_between(double lower_km, double upper_km, double top_km) const {
  return (haze_below(*this, upper_km) - haze_below(*this, lower_km)) / haze_below(*this, top_km);
}

double AerosolShape::stratospheric_between(double lower_km, double upper_km, double top_km) const {
  return (gaussian_below(*this, upper_km) - gaussian_below(*this, lower_km)) / gaussian_below(*this, top_km);
}

double AerosolShape::haze_density_per_km(double altitude, double top_km) const {
  return haze_value(*this, altitude) / haze_below(*this, top_km);
}

double AerosolShape::stratospheric_density_per_km(double altitude, double top_km) const {
  const double distance = (altitude - stratospheric_centre_km) / stratospheric_width_km;
  return std::exp(-0.5 * distance * distance) /
         (stratospheric_width_km * std::sqrt(2.0 * kPi) * gaussian_below(*this, top_km));
}

double AerosolShape::part_between(double lower_km, double upper_km, double top_km, double aod500) const {
  const double layer = stratospheric_share(aod500);
  return layer * stratospheric_between(lower_km, upper_km, top_km) +
         (1.0 - layer) * haze_between(lower_km, upper_km, top_km);
}

double AerosolShape::density_per_km(double altitude, double top_km, double aod500) const {
  const double layer = stratospheric_share(aod500);
  return layer * stratospheric_density_per_km(altitude, top_km) +
         (1.0 - layer) * haze_density_per_km(altitude, top_km);
}

void AerosolShape::validate() const {
  require("mixed layer", mixed_layer_km, 0.0, 10.0, " km");
  require("haze scale height", haze_scale_height_km, 0.1, 20.0, " km");
  if (!altitude_km.empty() || !relative_extinction.empty()) validate_table(*this);
  require("stratospheric aerosol optical depth", stratospheric_aod500, 0.0, 100.0, "");
  require("stratospheric aerosol altitude", stratospheric_centre_km, 5.0, 40.0, " km");
  require("stratospheric aerosol width", stratospheric_width_km, 0.5, 10.0, " km");
}

}  // namespace skylut
