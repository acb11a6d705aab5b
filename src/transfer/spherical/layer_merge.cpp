#include "layer_merge.hpp"

#include <numeric>

namespace skylut::transfer {

namespace {

/// Thickness up to which layers that start at an altitude are merged: about a tenth of the scale of the air's
/// own changes with altitude there, finer in the haze near the ground.
double thickest_merged_km(double altitude_km) {
  if (altitude_km < 1.5) return 0.25;
  if (altitude_km < 3.0) return 0.5;
  if (altitude_km < 20.0) return 1.0;
  if (altitude_km < 30.0) return 2.0;
  if (altitude_km < 50.0) return 5.0;
  return 10.0;
}

}  // namespace

LayerMerge::LayerMerge(const Shells& fine, bool keep_all) {
  shells_.planet_radius_km = fine.planet_radius_km;
  shells_.levels_km.push_back(fine.levels_km.front());
  first_layer_.push_back(0);
  for (std::size_t level = 1; level < fine.levels_km.size(); ++level) {
    const double start_km = shells_.levels_km.back();
    const bool last = level + 1 == fine.levels_km.size();
    const double rounding_km = 1e-9;
    if (last || keep_all ||
        fine.levels_km[level + 1] - start_km > thickest_merged_km(start_km) + rounding_km) {
      shells_.levels_km.push_back(fine.levels_km[level]);
      first_layer_.push_back(level);
    }
  }
}

std::vector<double> LayerMerge::sum(const std::vector<double>& depth) const {
  std::vector<double> sums;
  for (std::size_t layer = 0; layer + 1 < first_layer_.size(); ++layer)
    sums.push_back(std::accumulate(depth.begin() + static_cast<std::ptrdiff_t>(first_layer_[layer]),
                                   depth.begin() + static_cast<std::ptrdiff_t>(first_layer_[layer + 1]),
                                   0.0));
  return sums;
}

OpticalColumn LayerMerge::column(const OpticalColumn& fine) const {
  OpticalColumn merged;
  merged.ground_albedo = fine.ground_albedo;
  merged.extinction_depth = sum(fine.extinction_depth);
  for (const Scatterer& scatterer : fine.scatterers)
    merged.scatterers.push_back({scatterer.phase, sum(scatterer.scattering_depth)});
  return merged;
}

}  // namespace skylut::transfer
