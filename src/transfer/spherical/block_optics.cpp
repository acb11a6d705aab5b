#include "block_optics.hpp"

#include <algorithm>

namespace skylut::transfer {

BlockOptics::BlockOptics(const Discretisation& grid, std::span<const OpticalColumn* const> columns,
                         int lanes_, bool delta_m)
    : lanes(lanes_), scatterers(0) {
  for (int lane = 0; lane < lanes; ++lane)
    column.push_back(columns[std::min(static_cast<std::size_t>(lane), columns.size() - 1)]);
  for (const OpticalColumn* one : column)
    scatterers = std::max(scatterers, static_cast<int>(one->scatterers.size()));

  const auto width = static_cast<std::size_t>(lanes);
  const auto layer_count = static_cast<std::size_t>(grid.layers.layers());
  const auto degree_count = static_cast<std::size_t>(grid.angles.resolution().max_l + 1);
  extinction_per_km.resize(layer_count * width);
  source_factor.resize(layer_count * degree_count * width);
  scattering_per_km.resize(static_cast<std::size_t>(scatterers) * layer_count * width);

  for (std::size_t lane = 0; lane < width; ++lane) {
    const OpticalColumn& one = *column[lane];
    ground_albedo.push_back(static_cast<float>(one.ground_albedo));
    // χ_l of every scatterer up to the degree that delta-M cuts off.
    std::vector<std::vector<double>> chi;
    for (const Scatterer& scatterer : one.scatterers) {
      std::vector<double>& moments = chi.emplace_back();
      for (std::size_t l = 0; l <= degree_count; ++l)
        moments.push_back(scatterer.phase->moment(static_cast<int>(l)));
    }
    for (std::size_t layer = 0; layer < layer_count; ++layer) {
      const double thickness_km =
          grid.layers.level_km(static_cast<int>(layer) + 1) - grid.layers.level_km(static_cast<int>(layer));
      std::vector<double> mixed(degree_count + 1);
      for (std::size_t s = 0; s < chi.size(); ++s) {
        const double depth = one.scatterers[s].scattering_depth[layer];
        for (std::size_t l = 0; l <= degree_count; ++l) mixed[l] += depth * chi[s][l];
        scattering_per_km[(s * layer_count + layer) * width + lane] =
            static_cast<float>(depth / thickness_km);
      }
      // Truncated forward peak: f = χ_{L+1}; β' = β - f β_sca, and β'ω'χ'_l = β_sca (χ_l - f). [S2-S4]
      const double peak = delta_m ? mixed[degree_count] : 0.0;
      const double extinction = one.extinction_depth[layer] - peak;
      extinction_per_km[layer * width + lane] = static_cast<float>(extinction / thickness_km);
      for (std::size_t l = 0; l < degree_count; ++l) {
        const double factor =
            extinction > 0.0 ? (2.0 * static_cast<double>(l) + 1.0) * (mixed[l] - peak) / extinction : 0.0;
        source_factor[(layer * degree_count + l) * width + lane] = static_cast<float>(factor);
      }
    }
  }
}

void BlockOptics::phase_values(double cos_scattering_angle, float* value) const {
  const auto width = static_cast<std::size_t>(lanes);
  for (std::size_t lane = 0; lane < width; ++lane)
    for (std::size_t s = 0; s < static_cast<std::size_t>(scatterers); ++s)
      value[s * width + lane] =
          s < column[lane]->scatterers.size()
              ? static_cast<float>(column[lane]->scatterers[s].phase->value(cos_scattering_angle))
              : 0.0f;
}

}  // namespace skylut::transfer
