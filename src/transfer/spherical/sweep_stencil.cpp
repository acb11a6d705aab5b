#include "sweep_stencil.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::transfer {

namespace {

/// Ray that ends at altitude end_km, with |cosine| alpha there, after crossing the sublayer.
struct Crossing {
  double length_km;
  double start_km;      ///< altitude where it entered
  double start_cosine;  ///< |cosine| there
  bool chord;
};

Crossing crossing_down(const ShellGeometry& shells, int layer, double alpha) {
  const double lower_km = shells.level_km(layer);
  const double upper_km = shells.level_km(layer + 1);
  const double along = (shells.planet_radius_km() + lower_km) * alpha;
  const double gained = shells.radius_square_difference(upper_km, lower_km);
  const double from_closest = std::sqrt(gained + along * along);
  return {gained / (from_closest + along), upper_km, from_closest / (shells.planet_radius_km() + upper_km),
          false};
}

Crossing crossing_up(const ShellGeometry& shells, int layer, double alpha) {
  const double lower_km = shells.level_km(layer);
  const double upper_km = shells.level_km(layer + 1);
  const double along = (shells.planet_radius_km() + upper_km) * alpha;
  const double gained = shells.radius_square_difference(upper_km, lower_km);
  const double square = along * along - gained;
  if (square <= 0.0) return {2.0 * along, upper_km, alpha, true};
  const double from_closest = std::sqrt(square);
  return {gained / (from_closest + along), lower_km, from_closest / (shells.planet_radius_km() + lower_km),
          false};
}

}  // namespace

SweepStencil::SweepStencil(const ShellGeometry& shells, const AngularGrid& angles,
                           const std::vector<double>& sun_nodes_deg)
    : polar_nodes_(angles.polar_nodes()),
      sun_nodes_(static_cast<int>(sun_nodes_deg.size())),
      directions_(static_cast<std::size_t>(angles.directions())) {
  std::vector<double> root;  // the polar nodes are evenly spread in √|μ|: interpolate there
  for (const double alpha : angles.cos_polar()) root.push_back(std::sqrt(alpha));
  const CubicInterpolation among_polar(root);
  const CubicInterpolation among_suns(sun_nodes_deg);

  for (const Hemisphere hemisphere : {kDown, kUp}) {
    polar_[hemisphere].reserve(static_cast<std::size_t>(shells.layers() * polar_nodes_));
    sun_[hemisphere].resize(static_cast<std::size_t>(shells.layers() * sun_nodes_) * directions_);
    for (int layer = 0; layer < shells.layers(); ++layer) {
      for (int j = 0; j < polar_nodes_; ++j) {
        const double alpha = angles.cos_polar()[static_cast<std::size_t>(j)];
        const Crossing ray =
            hemisphere == kDown ? crossing_down(shells, layer, alpha) : crossing_up(shells, layer, alpha);
        if (ray.chord) chord_nodes_ = std::max(chord_nodes_, j + 1);
        polar_[hemisphere].push_back(
            {static_cast<float>(ray.length_km), ray.chord, among_polar(std::sqrt(ray.start_cosine))});

        const double mu = hemisphere == kDown ? -alpha : alpha;
        const double sine = std::sqrt(1.0 - mu * mu);
        const double end_km = shells.level_km(hemisphere == kDown ? layer : layer + 1);
        const double end_radius = shells.planet_radius_km() + end_km;
        const double start_radius = shells.planet_radius_km() + ray.start_km;
        for (int node = 0; node < sun_nodes_; ++node) {
          const double sun = sun_nodes_deg[static_cast<std::size_t>(node)] * kRadiansPerDegree;
          InterpolationWeights* weights = sun_[hemisphere].data() +
                                          static_cast<std::size_t>(layer * sun_nodes_ + node) * directions_ +
                                          j * angles.azimuth_nodes();
          for (const double azimuth : angles.azimuth_rad()) {
            const double towards_sun = mu * std::cos(sun) - sine * std::cos(azimuth) * std::sin(sun);
            const double cosine = (end_radius * std::cos(sun) - ray.length_km * towards_sun) / start_radius;
            const double start_sun_deg = std::acos(std::clamp(cosine, -1.0, 1.0)) * kDegreesPerRadian;
            *weights++ = among_suns(start_sun_deg);
          }
        }
      }
    }
  }
}

}  // namespace skylut::transfer
