#include "sunbeam_nodes.hpp"

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

SunbeamNodes::SunbeamNodes(const ShellGeometry& layers)
    : layers_(&layers),
      scale_km_(std::sqrt(2.0 * layers.planet_radius_km() * layers.top_km() / kScaleFraction)) {
  const double radius = layers.planet_radius_km() + layers.top_km();
  last_x_ = radius / (radius + scale_km_);
}

int SunbeamNodes::level_nodes() const { return layers_->levels() * kLevelNodes; }
int SunbeamNodes::perigee_nodes() const { return layers_->layers() * kPerigeeNodes; }

SunbeamNodes::Node SunbeamNodes::level_node(int index) const {
  const double x = last_x_ * (index % kLevelNodes) / (kLevelNodes - 1);
  const double w = scale_km_ * x / (1.0 - x);
  return {layers_->level_km(index / kLevelNodes), w, w + scale_km_};
}

SunbeamNodes::Node SunbeamNodes::perigee_node(int index) const {
  const int layer = index / kPerigeeNodes;
  const double u = static_cast<double>(index % kPerigeeNodes) / (kPerigeeNodes - 1);
  const double top = layers_->level_km(layer + 1);
  return {top - u * u * (top - layers_->level_km(layer)), 0.0, 1.0};
}

double SunbeamNodes::perigee_km(double altitude_km, double along_sun_km) const {
  const double planet = layers_->planet_radius_km();
  const double local = planet + altitude_km;
  const double perigee_radius = std::sqrt(std::max(0.0, local * local - along_sun_km * along_sun_km));
  // p - R without cancellation: (p² - R²)/(p + R).
  const double perigee =
      (altitude_km * (2.0 * planet + altitude_km) - along_sun_km * along_sun_km) / (perigee_radius + planet);
  return std::min(perigee, altitude_km);
}

SlantDepthWeights SunbeamNodes::weights(double altitude_km, double along_sun_km) const {
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

double SunbeamNodes::count(double layers) { return (layers + 1.0) * kLevelNodes + layers * kPerigeeNodes; }

}  // namespace skylut::transfer
