#include "sky_quadrature.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {

namespace {

constexpr int kZenithNodes = 16;  // on either side of the sun
constexpr int kAzimuthNodes = 16;
constexpr int kConeRings = 8;
constexpr int kConeNodes = 8;  // on the half circle

// Both halves, on either side of the sun's vertical plane.
constexpr double kSides = 2.0;

// Zenith angles between the sun's and an end, with dθ in radians.
void add_zenith_angles(double sun_deg, double end_deg, Quadrature& rule) {
  const Quadrature gauss = gauss_legendre(kZenithNodes, 0.0, 1.0);
  for (std::size_t i = 0; i < gauss.node.size(); ++i) {
    const double t = gauss.node[i];
    rule.node.push_back(sun_deg + (end_deg - sun_deg) * t * t);
    rule.weight.push_back(gauss.weight[i] * 2.0 * t * std::abs(end_deg - sun_deg) * kRadiansPerDegree);
  }
}

std::vector<Direction> directions_of(const SkyLight& sky, const SkyQuadrature& quadrature) {
  std::vector<Direction> directions;
  for (const RelativeView& view : quadrature.views)
    directions.push_back({view.zenith_deg, sky.sun().azimuth_deg + view.relative_azimuth_deg});
  return directions;
}

}  // namespace

std::vector<double> integrate(const SkyLight& sky, const SkyQuadrature& quadrature) {
  const std::vector<Direction> directions = directions_of(sky, quadrature);
  const std::size_t width = sky.wavelengths().size();
  std::vector<float> radiance(directions.size() * width);
  sky.radiance(directions, radiance);
  std::vector<double> total(width);
  for (std::size_t view = 0; view < directions.size(); ++view)
    for (std::size_t i = 0; i < width; ++i)
      total[i] += quadrature.weight[view] * static_cast<double>(radiance[view * width + i]);
  return total;
}

Xyz integrate_colour(const SkyLight& sky, const SkyQuadrature& quadrature) {
  const std::vector<Direction> directions = directions_of(sky, quadrature);
  std::vector<Xyz> colour(directions.size());
  sky.colour(directions, colour);
  Xyz total;
  for (std::size_t view = 0; view < directions.size(); ++view) {
    total.X += quadrature.weight[view] * colour[view].X;
    total.Y += quadrature.weight[view] * colour[view].Y;
    total.Z += quadrature.weight[view] * colour[view].Z;
  }
  return total;
}

SkyQuadrature hemisphere_quadrature(double sun_zenith_deg) {
  const double centre_deg = std::min(sun_zenith_deg, 90.0);
  Quadrature zenith;
  if (centre_deg > 0.0) add_zenith_angles(centre_deg, 0.0, zenith);
  if (centre_deg < 90.0) add_zenith_angles(centre_deg, 90.0, zenith);
  const Quadrature azimuth = gauss_legendre(kAzimuthNodes, 0.0, 1.0);
  SkyQuadrature result;
  for (std::size_t i = 0; i < zenith.node.size(); ++i) {
    const double theta = zenith.node[i] * kRadiansPerDegree;
    for (std::size_t k = 0; k < azimuth.node.size(); ++k) {
      const double t = azimuth.node[k];
      result.views.push_back({zenith.node[i], 180.0 * t * t});
      result.weight.push_back(kSides * std::cos(theta) * std::sin(theta) * zenith.weight[i] *
                              azimuth.weight[k] * 2.0 * t * kPi);
    }
  }
  return result;
}

SkyQuadrature circumsolar_quadrature(double sun_zenith_deg, double half_angle_deg) {
  const double sun = sun_zenith_deg * kRadiansPerDegree;
  const Quadrature ring = gauss_legendre(kConeRings, 0.0, half_angle_deg * kRadiansPerDegree);
  const Quadrature around = gauss_legendre(kConeNodes, 0.0, kPi);
  SkyQuadrature result;
  for (std::size_t i = 0; i < ring.node.size(); ++i)
    for (std::size_t k = 0; k < around.node.size(); ++k) {
      const double gamma = ring.node[i];
      const double turn = around.node[k];  // 0: towards the zenith
      // Components along the vertical, towards the sun's azimuth, and across.
      const double up = std::cos(gamma) * std::cos(sun) + std::sin(gamma) * std::sin(sun) * std::cos(turn);
      const double along = std::cos(gamma) * std::sin(sun) - std::sin(gamma) * std::cos(sun) * std::cos(turn);
      const double across = std::sin(gamma) * std::sin(turn);
      result.views.push_back({std::acos(std::clamp(up, -1.0, 1.0)) * kDegreesPerRadian,
                              std::atan2(across, along) * kDegreesPerRadian});
      result.weight.push_back(kSides * std::cos(gamma) * std::sin(gamma) * ring.weight[i] * around.weight[k]);
    }
  return result;
}

}  // namespace skylut
