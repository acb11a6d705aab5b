#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "skylut/sky/sky_scene.hpp"

namespace skylut::compact {

/// The columns of all bands of a scene at one load, over a grey ground in the place of the scene's.
struct GreyColumns {
  std::vector<OpticalColumn> columns;
  std::vector<double> weight;     ///< of a column in its band
  std::vector<std::size_t> band;  ///< of a column
};

inline GreyColumns grey_columns(const SkyScene& scene, double aod500, double albedo) {
  GreyColumns all;
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i)
    for (BandColumn& one :
         scene.atmosphere->band_columns({scene.wavelengths[i], scene.wavelengths.step_nm()}, aod500)) {
      one.column.ground_albedo = albedo;
      all.columns.push_back(std::move(one.column));
      all.weight.push_back(one.weight);
      all.band.push_back(i);
    }
  return all;
}

}  // namespace skylut::compact
