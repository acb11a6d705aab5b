#include "skylut/models/compact/zenith_grid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "skylut/core/constants.hpp"

namespace skylut::compact {

namespace {

constexpr double kElevation_deg = 1.5;
constexpr double kHaze_km = 1.5;
constexpr double kBelow_deg = 0.5;
constexpr double kEven = 0.4;  // the share of the limb's coordinate that is even in angle

CubicSpline whole_numbers(std::size_t count) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < count; ++i) nodes.push_back(static_cast<double>(i));
  return CubicSpline(nodes);
}

}  // namespace

ZenithGrid::ZenithGrid(const Counts& counts, double planet_radius_km)
    : counts_(counts),
      planet_radius_km_(planet_radius_km),
      above_(whole_numbers(counts.above)),
      limb_(whole_numbers(counts.limb)),
      ground_(whole_numbers(counts.ground)) {}

double ZenithGrid::horizon_zenith_deg(double altitude_km) const {
  return 180.0 - std::asin(planet_radius_km_ / (planet_radius_km_ + altitude_km)) * kDegreesPerRadian;
}

double ZenithGrid::limb_coordinate(double zenith_deg, double altitude_km, double horizon_deg) const {
  const double dip_deg = horizon_deg - 90.0;
  if (!(dip_deg > 0.0)) return 1.0;
  const double even = std::clamp((zenith_deg - 90.0) / dip_deg, 0.0, 1.0);
  const double lowest_km =
      (planet_radius_km_ + altitude_km) * std::sin(zenith_deg * kRadiansPerDegree) - planet_radius_km_;
  const double low =
      1.0 - std::log1p(std::max(lowest_km, 0.0) / kHaze_km) / std::log1p(altitude_km / kHaze_km);
  return kEven * even + (1.0 - kEven) * low;
}

double ZenithGrid::node_zenith_deg(std::size_t node, double altitude_km) const {
  const double horizon_deg = horizon_zenith_deg(altitude_km);
  const auto share = [](std::size_t i, std::size_t count) {
    return static_cast<double>(i) / static_cast<double>(count - 1);
  };
  if (node < counts_.above)
    return std::max(0.0, 90.0 - kElevation_deg * std::expm1(share(node, counts_.above) *
                                                            std::log1p(90.0 / kElevation_deg)));
  node -= counts_.above;
  if (node < counts_.limb) {
    // The coordinate rises with the angle: halving, to the last bit that counts.
    double low = 90.0;
    double high = horizon_deg;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (limb_coordinate(middle, altitude_km, horizon_deg) < share(node, counts_.limb) ? low : high) = middle;
    }
    return node == 0 ? 90.0 : node + 1 == counts_.limb ? horizon_deg : high;
  }
  node -= counts_.limb;
  return std::min(180.0,
                  horizon_deg + kBelow_deg * std::expm1(share(node, counts_.ground) *
                                                        std::log1p((180.0 - horizon_deg) / kBelow_deg)));
}

SplineTaps ZenithGrid::taps(double zenith_deg, double altitude_km) const {
  const auto steps = [](std::size_t count) { return static_cast<double>(count - 1); };
  if (zenith_deg <= 90.0)
    return above_.taps(std::log1p((90.0 - zenith_deg) / kElevation_deg) / std::log1p(90.0 / kElevation_deg) *
                       steps(counts_.above));
  const double horizon_deg = horizon_zenith_deg(altitude_km);
  SplineTaps taps;
  if (zenith_deg <= horizon_deg) {
    taps = limb_.taps(limb_coordinate(zenith_deg, altitude_km, horizon_deg) * steps(counts_.limb));
    taps.first += counts_.above;
  } else {
    taps = ground_.taps(std::log1p((zenith_deg - horizon_deg) / kBelow_deg) /
                        std::log1p((180.0 - horizon_deg) / kBelow_deg) * steps(counts_.ground));
    taps.first += counts_.above + counts_.limb;
  }
  return taps;
}

}  // namespace skylut::compact
