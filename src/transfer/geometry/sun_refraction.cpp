#include "sun_refraction.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::transfer {

namespace {

/// 2 cm sideways at the far end of the longest way.
constexpr double kAngle_rad = 1e-8;
constexpr int kMostSteps = 60;
/// Either way along the line, over which the concentration is a mean: the lowest altitude of a beam from
/// below changes by 16 m at 100 km, 160 m at 1000 km. Without it the air's kinks, such as the tropopause of a
/// standard atmosphere, would be lenses.
constexpr double kAlong_km = 1.0;
/// Where air of odd profiles makes caustics.
constexpr double kMostConcentration = 5.0;

}  // namespace

SunRefraction::SunRefraction(const RefractiveShells& shells, Bending bending)
    : shells_(&shells), nodes_(shells.optical()) {
  if (bending == Bending::integrated) return;
  // Over b, which is √(x² - w²): without it the bending is as smooth in w as the paths are.
  const auto value = [&](const SunbeamNodes::Node& node) {
    // A beam from the zenith is not bent; the limit, 1 km beside it.
    const double along =
        std::min(node.along_sun_km, shells.optical().planet_radius_km() + node.altitude_km - 1e-4);
    return node.scale * shells.bending_above(node.altitude_km, along) / impact_km(node.altitude_km, along);
  };
  for (int i = 0; i < nodes_.level_nodes(); ++i) from_level_.push_back(value(nodes_.level_node(i)));
  for (int i = 0; i < nodes_.perigee_nodes(); ++i) from_perigee_.push_back(value(nodes_.perigee_node(i)));
}

double SunRefraction::impact_km(double optical_km, double along_km) const {
  const double x = shells_->optical().planet_radius_km() + optical_km;
  return std::sqrt(std::max(0.0, (x - along_km) * (x + along_km)));
}

double SunRefraction::bending(double optical_km, double along_km) const {
  if (!from_level_.empty()) return bending_from_table(optical_km, along_km);
  const double above = shells_->bending_above(optical_km, std::abs(along_km));
  if (along_km >= 0.0) return above;
  return 2.0 * shells_->bending_above(std::max(0.0, nodes_.perigee_km(optical_km, along_km)), 0.0) - above;
}

double SunRefraction::bending_from_table(double optical_km, double along_km) const {
  const SlantDepthWeights weights = nodes_.weights(optical_km, along_km);
  const double impact = impact_km(optical_km, along_km);
  const double start = std::abs(along_km);
  const double within = weights.to_level_km > 0.0f
                            ? shells_->bending_within(weights.layer, impact, start,
                                                      start + static_cast<double>(weights.to_level_km))
                            : 0.0;
  double above = 0.0;
  for (int t = 0; t < 4; ++t)
    above += from_level_[static_cast<std::size_t>(weights.from_level + t)] *
             static_cast<double>(weights.from_level_weight[t]);
  if (weights.from_perigee < 0) return impact * above + within;
  double whole = 0.0;
  for (int t = 0; t < 4; ++t)
    whole += from_perigee_[static_cast<std::size_t>(weights.from_perigee + t)] *
             static_cast<double>(weights.from_perigee_weight[t]);
  return impact * (whole - above) - within;
}

double SunRefraction::true_zenith_rad(double optical_km, double along_km) const {
  return std::atan2(impact_km(optical_km, along_km), along_km) + bending(optical_km, along_km);
}

double SunRefraction::lowest_along_km(double optical_km) const {
  return -std::sqrt(std::max(0.0, shells_->optical().radius_square_difference(optical_km, 0.0)));
}

double SunRefraction::last_sun_rad(double altitude_km) const {
  const double optical = shells_->optical_km(altitude_km);
  return true_zenith_rad(optical, lowest_along_km(optical));
}

double SunRefraction::apparent_sun_rad(double altitude_km, double sun_rad) const {
  const double hidden = std::max(0.0, sun_rad - last_sun_rad(altitude_km));
  const Sunbeam found = sunbeam(altitude_km, std::cos(sun_rad));
  const double x = shells_->optical().planet_radius_km() + found.altitude_km;
  return std::acos(std::clamp(found.along_sun_km / x, -1.0, 1.0)) + hidden;
}

double SunRefraction::true_sun_rad(double altitude_km, double apparent_rad) const {
  const double optical = shells_->optical_km(altitude_km);
  const double x = shells_->optical().planet_radius_km() + optical;
  const double lowest = lowest_along_km(optical);
  const double along = std::max(lowest, x * std::cos(apparent_rad));
  const double hidden = std::max(0.0, apparent_rad - std::acos(std::clamp(lowest / x, -1.0, 1.0)));
  return true_zenith_rad(optical, along) + hidden;
}

double SunRefraction::concentration(double optical_km, double along_km) const {
  const double x = shells_->optical().planet_radius_km() + optical_km;
  const double lower = std::max(along_km - kAlong_km, lowest_along_km(optical_km));
  const double upper = std::min(along_km + kAlong_km, x);
  const double from = true_zenith_rad(optical_km, lower);
  const double to = true_zenith_rad(optical_km, upper);
  // d(cos χ) = 2 sin((χ1 + χ2)/2) sin((χ1 - χ2)/2).
  const double change = 2.0 * std::sin(0.5 * (from + to)) * std::sin(0.5 * (from - to));
  const double apparent = (upper - lower) / x;
  return change * kMostConcentration > apparent ? apparent / change : kMostConcentration;
}

Sunbeam SunRefraction::sunbeam(double altitude_km, double cos_sun_zenith) const {
  const double optical = shells_->optical_km(altitude_km);
  const double x = shells_->optical().planet_radius_km() + optical;
  const double wanted = std::acos(std::clamp(cos_sun_zenith, -1.0, 1.0));
  const double lowest = lowest_along_km(optical);
  const double last = true_zenith_rad(optical, lowest);
  if (wanted >= last) return {optical, lowest, concentration(optical, lowest)};

  // ψ + ε(ψ) = χ with ε rising towards the horizon: within [χ - ε(last), χ], by the regula falsi of Dowell
  // and Jarratt (1971, doi:10.1007/BF01934364), which halves the weight of an end that stays.
  const double lowest_apparent = std::atan2(std::sqrt((x - lowest) * (x + lowest)), lowest);
  double above = std::max(0.0, wanted - (last - lowest_apparent));
  double below = std::min(wanted, lowest_apparent);
  const auto excess = [&](double apparent) {
    return true_zenith_rad(optical, std::max(lowest, x * std::cos(apparent))) - wanted;
  };
  double at_above = excess(above);
  double at_below = excess(below);
  double apparent = below;
  double at_apparent = at_below;
  int kept = 0;
  for (int step = 0; step < kMostSteps && std::abs(at_apparent) > kAngle_rad; ++step) {
    apparent = (above * at_below - below * at_above) / (at_below - at_above);
    at_apparent = excess(apparent);
    if (at_apparent > 0.0) {
      below = apparent;
      at_below = at_apparent;
      if (kept == 1) at_above *= 0.5;
      kept = 1;
    } else {
      above = apparent;
      at_above = at_apparent;
      if (kept == -1) at_below *= 0.5;
      kept = -1;
    }
  }
  const double along = std::max(lowest, x * std::cos(apparent));
  return {optical, along, concentration(optical, along)};
}

}  // namespace skylut::transfer
