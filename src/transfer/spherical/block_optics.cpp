#include "block_optics.hpp"

#include <algorithm>
#include <array>

#include "skylut/core/check.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut::transfer {

namespace {

/// Adds what scatters Q and U to lane `lane`: the matrix of the layer's mixture, without the part of the peak
/// that delta-M takes for unscattered. [docs/polarisation.md P4]
/// @param terms  polarised degrees + 1
void scale_polarisation(const OpticalColumn& column, std::size_t legendre_terms, std::size_t terms,
                        bool delta_m, std::size_t lane, std::size_t lanes, ScaledLayers& scaled) {
  std::vector<std::vector<MatrixMoments>> matrix;
  std::vector<double> peak;
  for (const Scatterer& scatterer : column.scatterers) {
    matrix.push_back(scatterer.phase->matrix_moments(static_cast<int>(terms) - 1));
    peak.push_back(delta_m ? scatterer.phase->moment(static_cast<int>(legendre_terms)) : 0.0);
  }
  for (std::size_t layer = 0; layer < column.extinction_depth.size(); ++layer) {
    double depth = column.extinction_depth[layer];
    for (std::size_t s = 0; s < matrix.size(); ++s)
      depth -= column.scatterers[s].scattering_depth[layer] * peak[s];
    if (!(depth > 0.0)) continue;
    for (std::size_t l = 2; l < terms; ++l) {
      std::array<double, 3> mixed{};
      for (std::size_t s = 0; s < matrix.size(); ++s) {
        const double scattering = column.scatterers[s].scattering_depth[layer];
        mixed[0] += scattering * matrix[s][l].beta1;
        mixed[1] += scattering * (matrix[s][l].alpha2 - peak[s]);
        mixed[2] += scattering * (matrix[s][l].alpha3 - peak[s]);
      }
      for (std::size_t i = 0; i < mixed.size(); ++i)
        scaled.polarised_factor[((layer * terms + l) * mixed.size() + i) * lanes + lane] =
            static_cast<float>((2.0 * static_cast<double>(l) + 1.0) * mixed[i] / depth);
    }
  }
}

/// Scales one column's layers into lane `lane`. [S2-S4]
void scale_column(const Shells& shells, const OpticalColumn& column, std::size_t legendre_terms, bool delta_m,
                  std::size_t lane, std::size_t lanes, ScaledLayers& scaled) {
  SKYLUT_CHECK_EQ(column.extinction_depth.size() + 1, shells.levels_km.size());
  // χ_l of every scatterer up to the degree that delta-M cuts off.
  std::vector<std::vector<double>> chi;
  for (const Scatterer& scatterer : column.scatterers) {
    SKYLUT_CHECK_EQ(scatterer.scattering_depth.size(), column.extinction_depth.size());
    std::vector<double>& moments = chi.emplace_back();
    for (std::size_t l = 0; l <= legendre_terms; ++l)
      moments.push_back(scatterer.phase->moment(static_cast<int>(l)));
  }
  for (std::size_t layer = 0; layer < column.extinction_depth.size(); ++layer) {
    std::vector<double> mixed(legendre_terms + 1);
    for (std::size_t s = 0; s < chi.size(); ++s)
      for (std::size_t l = 0; l <= legendre_terms; ++l)
        mixed[l] += column.scatterers[s].scattering_depth[layer] * chi[s][l];
    // Truncated forward peak: f = χ_{L+1}; β' = β - f β_sca, and β'ω'χ'_l = β_sca (χ_l - f).
    const double peak = delta_m ? mixed[legendre_terms] : 0.0;
    const double depth = column.extinction_depth[layer] - peak;
    const double thickness_km = shells.levels_km[layer + 1] - shells.levels_km[layer];
    scaled.extinction_per_km[layer * lanes + lane] = static_cast<float>(depth / thickness_km);
    for (std::size_t l = 0; l < legendre_terms; ++l)
      scaled.source_factor[(layer * legendre_terms + l) * lanes + lane] =
          depth > 0.0 ? static_cast<float>((2.0 * static_cast<double>(l) + 1.0) * (mixed[l] - peak) / depth)
                      : 0.0f;
  }
}

ScaledLayers zero_layers(const Shells& shells, std::size_t legendre_terms, std::size_t polarised_terms,
                         std::size_t lanes) {
  const std::size_t layers = shells.levels_km.size() - 1;
  return {std::vector<float>(layers * lanes), std::vector<float>(layers * legendre_terms * lanes),
          std::vector<float>(layers * polarised_terms * 3 * lanes)};
}

}  // namespace

BlockOptics::BlockOptics(const Discretisation& grid, std::span<const OpticalColumn* const> columns,
                         int lanes_, bool delta_m)
    : lanes(lanes_), scatterers(0) {
  SKYLUT_CHECK(!columns.empty());
  for (int lane = 0; lane < lanes; ++lane)
    column.push_back(columns[std::min(static_cast<std::size_t>(lane), columns.size() - 1)]);
  for (const OpticalColumn* one : column)
    scatterers = std::max(scatterers, static_cast<int>(one->scatterers.size()));

  const Shells& shells = grid.common.shells;
  const auto width = static_cast<std::size_t>(lanes);
  const std::size_t layer_count = shells.levels_km.size() - 1;
  const auto legendre_terms = static_cast<std::size_t>(grid.angles.resolution().max_l + 1);
  const auto polarised_terms =
      grid.polarised ? static_cast<std::size_t>(grid.polarised->view().degrees) : std::size_t{0};
  layers = zero_layers(shells, legendre_terms, polarised_terms, width);
  sweep_layers = zero_layers(grid.common.merge.shells(), legendre_terms, polarised_terms, width);
  scattering_per_km.resize(static_cast<std::size_t>(scatterers) * layer_count * width);
  peak_per_km.resize(layer_count * width);

  std::vector<OpticalColumn> merged;
  for (const OpticalColumn* one : column) merged.push_back(grid.common.merge.column(*one));
  if (delta_m && grid.cuts_peak) horizon = HorizonPeaks(merged, grid.angles.resolution().max_l);

  for (std::size_t lane = 0; lane < width; ++lane) {
    const OpticalColumn& one = *column[lane];
    ground_albedo.push_back(static_cast<float>(one.ground_albedo));
    scale_column(shells, one, legendre_terms, delta_m, lane, width, layers);
    scale_column(grid.common.merge.shells(), merged[lane], legendre_terms, delta_m, lane, width,
                 sweep_layers);
    if (polarised_terms > 0) {
      scale_polarisation(one, legendre_terms, polarised_terms, delta_m, lane, width, layers);
      scale_polarisation(merged[lane], legendre_terms, polarised_terms, delta_m, lane, width, sweep_layers);
    }
    for (std::size_t layer = 0; layer < layer_count; ++layer) {
      const double thickness_km = shells.levels_km[layer + 1] - shells.levels_km[layer];
      const double whole = one.extinction_depth[layer] / thickness_km;
      const std::size_t at = layer * width + lane;
      peak_per_km[at] = delta_m ? static_cast<float>(whole) - layers.extinction_per_km[at] : 0.0f;
    }
    std::vector<ForwardPeakCorrection>& spread = spread_.emplace_back();
    for (const Scatterer& scatterer : one.scatterers)
      spread.emplace_back(*scatterer.phase, grid.angles.resolution().max_l);
    for (std::size_t s = 0; s < one.scatterers.size(); ++s)
      for (std::size_t layer = 0; layer < layer_count; ++layer)
        scattering_per_km[(s * layer_count + layer) * width + lane] =
            static_cast<float>(one.scatterers[s].scattering_depth[layer] /
                               (shells.levels_km[layer + 1] - shells.levels_km[layer]));
  }
}

std::vector<float> BlockOptics::phases(const Ray& ray) const {
  const auto stride = static_cast<std::size_t>(scatterers * lanes);
  std::vector<float> phase(stride * ray.cos_scattering().size());
  for (std::size_t pair = 0; pair < ray.cos_scattering().size(); ++pair)
    phase_values(ray.cos_scattering()[pair], phase.data() + pair * stride);
  return phase;
}

std::vector<float> BlockOptics::polarising_phases(const Ray& ray) const {
  const auto width = static_cast<std::size_t>(lanes);
  const auto count = static_cast<std::size_t>(scatterers);
  std::vector<float> f12(count * width * ray.cos_scattering().size());
  for (std::size_t pair = 0; pair < ray.cos_scattering().size(); ++pair)
    for (std::size_t lane = 0; lane < width; ++lane)
      for (std::size_t s = 0; s < column[lane]->scatterers.size(); ++s)
        f12[(pair * count + s) * width + lane] =
            static_cast<float>(column[lane]->scatterers[s].phase->matrix(ray.cos_scattering()[pair]).f12);
  return f12;
}

std::vector<float> BlockOptics::peaks(const Ray& ray) const {
  const auto stride = static_cast<std::size_t>(2 * scatterers * lanes);
  std::vector<float> peak;
  for (std::size_t pair = 0; pair < ray.cos_scattering().size(); ++pair) {
    if (ray.aureole()[pair] < 0) continue;
    peak.resize(peak.size() + stride);
    peak_values(ray.cos_scattering()[pair], peak.data() + peak.size() - stride);
    if (const double weight = aureole_weight(ray.cos_scattering()[pair]); weight < 1.0)
      for (std::size_t i = peak.size() - stride; i < peak.size(); ++i) peak[i] *= static_cast<float>(weight);
  }
  return peak;
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

void BlockOptics::peak_values(double cos_scattering_angle, float* value) const {
  const auto width = static_cast<std::size_t>(lanes);
  const auto count = static_cast<std::size_t>(scatterers);
  std::size_t terms = 1;
  for (const std::vector<ForwardPeakCorrection>& lane : spread_)
    for (const ForwardPeakCorrection& spread : lane) terms = std::max(terms, spread.terms());
  const std::vector<double> legendre =
      normalised_legendre(0, static_cast<int>(terms) - 1, cos_scattering_angle);
  for (std::size_t lane = 0; lane < width; ++lane)
    for (std::size_t s = 0; s < count; ++s) {
      // A lane with fewer scatterers than its block has none, and none scatters, in the places left over.
      ForwardPeakCorrection::Coefficients spread;
      if (s < spread_[lane].size()) spread = spread_[lane][s].at(legendre);
      value[s * width + lane] = static_cast<float>(spread.first);
      value[(count + s) * width + lane] = static_cast<float>(spread.second);
    }
}

void BlockOptics::part_factors(int lane, double cos_scattering_angle, std::span<double> factor) const {
  const auto own = static_cast<std::size_t>(lane);
  const std::size_t count = (factor.size() - 1) / 3;
  std::fill(factor.begin(), factor.end(), 0.0);
  factor.back() = 1.0;
  std::size_t terms = 1;
  for (const ForwardPeakCorrection& spread : spread_[own]) terms = std::max(terms, spread.terms());
  const double weight = aureole_weight(cos_scattering_angle);
  std::vector<double> legendre;
  if (weight > 0.0 && terms > 1)
    legendre = normalised_legendre(0, static_cast<int>(terms) - 1, cos_scattering_angle);
  for (std::size_t s = 0; s < spread_[own].size(); ++s) {
    factor[s] = column[own]->scatterers[s].phase->value(cos_scattering_angle);
    if (legendre.empty()) continue;
    const ForwardPeakCorrection::Coefficients spread = spread_[own][s].at(legendre);
    factor[count + s] = -weight * spread.first;
    factor[2 * count + s] = weight * spread.second;
  }
}

}  // namespace skylut::transfer
