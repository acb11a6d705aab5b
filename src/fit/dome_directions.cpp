#include "skylut/fit/dome_directions.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

/// How a set is laid out.
struct Layout {
  std::vector<double> zeniths_deg;  ///< of a dome that ends at 90°, rising from 0
  double azimuth_step_deg;          ///< of its rings; twice that of short ones, and of those for the sun
  bool between;                     ///< azimuths begin half a step from the sun
  std::vector<double> around_sun_deg;
};

struct Ring {
  double zenith_deg;
  bool for_sun;
};

constexpr double kOverhead_deg = 1e-6;
constexpr double kShortRing_deg = 25.0;
constexpr double kNearSun_deg = 9.0;
constexpr double kSameRing_deg = 0.09;

std::vector<Ring> rings_of(const Layout& layout, double sun_deg, double horizon_deg) {
  std::vector<Ring> rings;
  for (const double zenith : layout.zeniths_deg) rings.push_back({zenith * horizon_deg / 90.0, false});
  for (const double offset : layout.around_sun_deg)
    for (const double zenith : {sun_deg - offset, sun_deg + offset})
      if (zenith > kSameRing_deg && zenith <= horizon_deg &&
          std::none_of(rings.begin(), rings.end(),
                       [&](const Ring& ring) { return std::abs(ring.zenith_deg - zenith) < kSameRing_deg; }))
        rings.push_back({zenith, true});
  std::sort(rings.begin(), rings.end(),
            [](const Ring& one, const Ring& other) { return one.zenith_deg < other.zenith_deg; });
  return rings;
}

/// Azimuths from the sun's, [0, 180], rising.
std::vector<double> azimuths_of(const Ring& ring, const Layout& layout, double sun_deg) {
  if (sun_deg < kOverhead_deg || ring.zenith_deg == 0.0) return {0.0};
  std::vector<double> azimuths;
  const bool short_ring = ring.zenith_deg < kShortRing_deg;
  const double step = ring.for_sun || short_ring ? 2.0 * layout.azimuth_step_deg : layout.azimuth_step_deg;
  for (double azimuth = layout.between ? 0.5 * step : 0.0; azimuth <= 180.0; azimuth += step)
    azimuths.push_back(azimuth);
  const double sine = std::sin(ring.zenith_deg * kRadiansPerDegree);
  if (std::abs(ring.zenith_deg - sun_deg) < kNearSun_deg)
    for (const double offset : layout.around_sun_deg) {
      const double azimuth = offset / sine;
      const bool new_one = std::none_of(azimuths.begin(), azimuths.end(), [&](double other) {
        return std::abs(other - azimuth) * sine < 0.5 * kSameRing_deg;
      });
      if (azimuth < 90.0 && new_one) azimuths.push_back(azimuth);
    }
  std::sort(azimuths.begin(), azimuths.end());
  return azimuths;
}

/// The part of [low, high] that is nearest to each of some rising values.
std::vector<double> shares(const std::vector<double>& values, double low, double high) {
  std::vector<double> shares;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double from = i == 0 ? low : 0.5 * (values[i - 1] + values[i]);
    const double to = i + 1 == values.size() ? high : 0.5 * (values[i] + values[i + 1]);
    shares.push_back(to - from);
  }
  return shares;
}

DomeDirections laid_out(const Layout& layout, const Direction& sun, double horizon_deg) {
  const std::vector<Ring> rings = rings_of(layout, sun.zenith_deg, horizon_deg);
  DomeDirections dome;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const double from = i == 0 ? 0.0 : 0.5 * (rings[i - 1].zenith_deg + rings[i].zenith_deg);
    const double to =
        i + 1 == rings.size() ? horizon_deg : 0.5 * (rings[i].zenith_deg + rings[i + 1].zenith_deg);
    const double height = std::cos(from * kRadiansPerDegree) - std::cos(to * kRadiansPerDegree);
    const std::vector<double> azimuths = azimuths_of(rings[i], layout, sun.zenith_deg);
    const std::vector<double> widths = shares(azimuths, 0.0, 180.0);
    for (std::size_t k = 0; k < azimuths.size(); ++k) {
      const double azimuth =
          rings[i].zenith_deg == 0.0 ? 0.0 : wrapped_azimuth_deg(sun.azimuth_deg + azimuths[k]);
      dome.directions.push_back({rings[i].zenith_deg, azimuth});
      dome.solid_angles_sr.push_back(height * 2.0 * widths[k] * kRadiansPerDegree);
    }
  }
  return dome;
}

}  // namespace

DomeDirections dome_directions(const Direction& sun, double horizon_zenith_deg) {
  const Layout layout{.zeniths_deg = {0.0, 12.0, 24.0, 36.0, 48.0, 57.0, 65.0, 72.0, 76.0, 80.0, 82.0, 84.0,
                                      86.0, 87.0, 88.0, 89.0, 89.5, 89.9, 90.0},
                      .azimuth_step_deg = 15.0,
                      .between = false,
                      .around_sun_deg = {0.0, 0.5, 1.0, 2.1, 4.1, 8.0}};
  return laid_out(layout, sun, horizon_zenith_deg);
}

DomeDirections dome_check_directions(const Direction& sun, double horizon_zenith_deg) {
  Layout layout{.zeniths_deg = {0.0},
                .azimuth_step_deg = 15.0,
                .between = true,
                .around_sun_deg = {0.7, 1.4, 2.9, 5.2}};
  for (double zenith = 2.0; zenith < 80.0; zenith += 4.0) layout.zeniths_deg.push_back(zenith);
  for (double zenith = 80.25; zenith < 89.0; zenith += 0.5) layout.zeniths_deg.push_back(zenith);
  for (const double zenith : {89.15, 89.4, 89.65, 89.85, 89.97}) layout.zeniths_deg.push_back(zenith);
  return laid_out(layout, sun, horizon_zenith_deg);
}

double horizon_emphasis(double zenith_rad) {
  constexpr double kExtra = 2.0;
  constexpr double kPower = 20.0;
  return 1.0 + kExtra * std::pow(std::sin(std::min(zenith_rad, 0.5 * kPi)), kPower);
}

}  // namespace skylut
