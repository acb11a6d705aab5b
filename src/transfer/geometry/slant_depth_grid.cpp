#include "slant_depth_grid.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::transfer {

SlantDepthGrid::SlantDepthGrid(const ShellGeometry& layers)
    : nodes_(layers), planet_km_(layers.planet_radius_km()) {
  fill();
}

SlantDepthGrid::SlantDepthGrid(const RefractiveShells& shells)
    : nodes_(shells.optical()),
      stretch_(shells.stretch()),
      refraction_(std::make_unique<const SunRefraction>(shells)),
      planet_km_(shells.layers().planet_radius_km()) {
  fill();
}

void SlantDepthGrid::fill() {
  for (int i = 0; i < nodes_.level_nodes(); ++i) add_path(nodes_.level_node(i), from_level_path_km_);
  for (int i = 0; i < nodes_.perigee_nodes(); ++i) add_path(nodes_.perigee_node(i), from_perigee_path_km_);
}

void SlantDepthGrid::add_path(const SunbeamNodes::Node& node, std::vector<float>& to) const {
  const ShellGeometry& layers = nodes_.layers();
  std::vector<double> length_km;
  layers.path_to_top(node.altitude_km, node.along_sun_km / (layers.planet_radius_km() + node.altitude_km),
                     length_km);
  for (std::size_t layer = 0; layer < length_km.size(); ++layer)
    to.push_back(
        static_cast<float>(node.scale * length_km[layer] * (stretch_.empty() ? 1.0 : stretch_[layer])));
}

Sunbeam SlantDepthGrid::sunbeam(double altitude_km, double along_sun_km) const {
  if (!refraction_) return {altitude_km, along_sun_km, 1.0};
  return refraction_->sunbeam(altitude_km, along_sun_km / (planet_km_ + altitude_km));
}

SlantDepthWeights SlantDepthGrid::weights(const Sunbeam& sunbeam) const {
  SlantDepthWeights found = nodes_.weights(sunbeam.altitude_km, sunbeam.along_sun_km);
  if (refraction_) {
    found.to_level_km *= static_cast<float>(stretch_[static_cast<std::size_t>(found.layer)]);
    found.spread = static_cast<float>(-std::log(sunbeam.concentration));
  }
  return found;
}

bool SlantDepthGrid::is_lit(double altitude_km, double along_sun_km) const {
  if (along_sun_km >= 0.0) return true;
  if (!refraction_) return nodes_.perigee_km(altitude_km, along_sun_km) >= 0.0;
  return along_sun_km >= (planet_km_ + altitude_km) * std::cos(refraction_->last_sun_rad(altitude_km));
}

SlantDepthWeights SlantDepthGrid::weights_towards(double altitude_km, double cos_sun_zenith) const {
  const double along_sun_km = (planet_km_ + altitude_km) * cos_sun_zenith;
  if (is_lit(altitude_km, along_sun_km)) return weights(altitude_km, along_sun_km);
  SlantDepthWeights dark;
  dark.from_level = kShadow;
  return dark;
}

double SlantDepthGrid::cos_apparent_sun(double altitude_km, double cos_sun_zenith) const {
  if (!refraction_) return cos_sun_zenith;
  return std::cos(
      refraction_->apparent_sun_rad(altitude_km, std::acos(std::clamp(cos_sun_zenith, -1.0, 1.0))));
}

double SlantDepthGrid::apparent_sun_deg(double altitude_km, double sun_zenith_deg) const {
  if (!refraction_) return sun_zenith_deg;
  return refraction_->apparent_sun_rad(altitude_km, sun_zenith_deg * kRadiansPerDegree) * kDegreesPerRadian;
}

SlantDepthView SlantDepthGrid::view() const {
  return {.layers = nodes_.layers().layers(),
          .level_points = nodes_.level_nodes(),
          .perigee_points = nodes_.perigee_nodes(),
          .from_level_path_km = from_level_path_km_.data(),
          .from_perigee_path_km = from_perigee_path_km_.data()};
}

}  // namespace skylut::transfer
