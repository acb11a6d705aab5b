#include "slant_depth_grid.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/check.hpp"

namespace skylut::transfer {

namespace {

// 48 nodes keep the depth to 1e-5 for scale heights of 1-8 km; halving them costs 16 times that.
constexpr int kLevelNodes = 48;
// Eight nodes in each layer: 2e-5 of the depth of a grazing sunbeam.
constexpr int kPerigeeNodes = 8;
// w0 = √(2 R top/32), 200 km on Earth: what a level line needs to climb a few kilometres.
constexpr double kScaleFraction = 32.0;

/// Cubic Lagrange weights at t among the nodes 0, 1, … count-1, times `factor`. @return first node
int uniform_weights(double t, int count, double factor, float* weight) {
  SKYLUT_CHECK_GE(t, 0.0);
  SKYLUT_CHECK_LE(t, count - 1 + 1e-9);
  const int first = std::clamp(static_cast<int>(t) - 1, 0, count - 4);
  const double u = t - first;
  weight[0] = static_cast<float>(factor * (u - 1.0) * (u - 2.0) * (u - 3.0) / -6.0);
  weight[1] = static_cast<float>(factor * u * (u - 2.0) * (u - 3.0) / 2.0);
  weight[2] = static_cast<float>(factor * u * (u - 1.0) * (u - 3.0) / -2.0);
  weight[3] = static_cast<float>(factor * u * (u - 1.0) * (u - 2.0) / 6.0);
  return first;
}

}  // namespace

SlantDepthGrid::SlantDepthGrid(const ShellGeometry& layers)
    : layers_(&layers),
      scale_km_(std::sqrt(2.0 * layers.planet_radius_km() * layers.top_km() / kScaleFraction)) {
  const double radius = layers.planet_radius_km() + layers.top_km();
  last_x_ = radius / (radius + scale_km_);
  for (int level = 0; level < layers.levels(); ++level)
    for (int node = 0; node < kLevelNodes; ++node) {
      const double x = last_x_ * node / (kLevelNodes - 1);
      const double w = scale_km_ * x / (1.0 - x);
      const double altitude = layers.level_km(level);
      const std::vector<float> path =
          path_to_sun(altitude, w / (layers.planet_radius_km() + altitude), w + scale_km_);
      from_level_path_km_.insert(from_level_path_km_.end(), path.begin(), path.end());
    }
  for (int layer = 0; layer < layers.layers(); ++layer)
    for (int node = 0; node < kPerigeeNodes; ++node) {
      const double u = static_cast<double>(node) / (kPerigeeNodes - 1);
      const double top = layers.level_km(layer + 1);
      const std::vector<float> path = path_to_sun(top - u * u * (top - layers.level_km(layer)), 0.0, 1.0);
      from_perigee_path_km_.insert(from_perigee_path_km_.end(), path.begin(), path.end());
    }
}

std::vector<float> SlantDepthGrid::path_to_sun(double altitude_km, double cos_zenith, double scale) const {
  std::vector<double> length_km;
  layers_->path_to_top(altitude_km, cos_zenith, length_km);
  std::vector<float> scaled;
  for (const double length : length_km) scaled.push_back(static_cast<float>(scale * length));
  return scaled;
}

double SlantDepthGrid::perigee_km(double altitude_km, double along_sun_km) const {
  const double planet = layers_->planet_radius_km();
  const double local = planet + altitude_km;
  const double perigee_radius = std::sqrt(std::max(0.0, local * local - along_sun_km * along_sun_km));
  // p - R without cancellation: (p² - R²)/(p + R).
  const double perigee =
      (altitude_km * (2.0 * planet + altitude_km) - along_sun_km * along_sun_km) / (perigee_radius + planet);
  return std::min(perigee, altitude_km);
}

SlantDepthWeights SlantDepthGrid::weights(double altitude_km, double along_sun_km) const {
  SlantDepthWeights found;
  found.layer = layers_->layer_of(altitude_km);
  const int level = altitude_km > layers_->level_km(found.layer) ? found.layer + 1 : found.layer;
  const double climb = layers_->radius_square_difference(layers_->level_km(level), altitude_km);
  const double w = std::sqrt(along_sun_km * along_sun_km + climb);
  found.to_level_km = climb > 0.0 ? static_cast<float>(climb / (w + std::abs(along_sun_km))) : 0.0f;
  const double scaled = 1.0 / (w + scale_km_);
  found.from_level = level * kLevelNodes + uniform_weights(w * scaled / last_x_ * (kLevelNodes - 1),
                                                           kLevelNodes, scaled, found.from_level_weight);
  if (along_sun_km < 0.0) {
    const double perigee = std::max(0.0, perigee_km(altitude_km, along_sun_km));
    const int lowest = layers_->layer_of(perigee);
    const double top = layers_->level_km(lowest + 1);
    const double u = std::sqrt((top - perigee) / (top - layers_->level_km(lowest)));
    found.from_perigee = lowest * kPerigeeNodes + uniform_weights(u * (kPerigeeNodes - 1), kPerigeeNodes, 2.0,
                                                                  found.from_perigee_weight);
  }
  return found;
}

SlantDepthWeights SlantDepthGrid::weights_towards(double altitude_km, double cos_sun_zenith) const {
  const double height = (layers_->planet_radius_km() + altitude_km) * cos_sun_zenith;
  if (height >= 0.0 || perigee_km(altitude_km, height) >= 0.0) return weights(altitude_km, height);
  SlantDepthWeights dark;
  dark.from_level = kShadow;
  return dark;
}

SlantDepthView SlantDepthGrid::view() const {
  return {.layers = layers_->layers(),
          .level_points = layers_->levels() * kLevelNodes,
          .perigee_points = layers_->layers() * kPerigeeNodes,
          .from_level_path_km = from_level_path_km_.data(),
          .from_perigee_path_km = from_perigee_path_km_.data()};
}

double SlantDepthGrid::points(double layers) { return (layers + 1.0) * kLevelNodes + layers * kPerigeeNodes; }

}  // namespace skylut::transfer
