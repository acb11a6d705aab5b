#include "sky_patch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/cosine_series.hpp"

namespace skylut {

namespace {

/// Σ_m row_m cos mφ, by the recurrence of the cosines.
void sum_series(std::span<const float> row, std::size_t width, double cos_azimuth, std::vector<float>& sum) {
  sum.assign(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(width));
  double before = 1.0;
  double cosine = cos_azimuth;
  for (std::size_t first = width; first < row.size(); first += width) {
    const auto factor = static_cast<float>(cosine);
    const float* order = row.data() + first;
    float* to = sum.data();
    for (std::size_t i = 0; i < width; ++i) to[i] += factor * order[i];
    before = std::exchange(cosine, 2.0 * cos_azimuth * cosine - before);
  }
}

}  // namespace

PatchDirection patch_direction(double zenith_deg, double relative_azimuth_deg, double sun_zenith_deg) {
  const double zenith = zenith_deg * kRadiansPerDegree;
  const double sun = sun_zenith_deg * kRadiansPerDegree;
  const double cos_azimuth = std::cos(relative_azimuth_deg * kRadiansPerDegree);
  return {cos_azimuth, std::cos(zenith) * std::cos(sun) + std::sin(zenith) * std::sin(sun) * cos_azimuth};
}

SkyPatch::SkyPatch(ZenithPanel panel, int points, int azimuths)
    : panel_(panel), x_(lobatto_points(points)), azimuths_(azimuths) {
  for (int k = 0; k < azimuths; ++k) azimuth_deg_.push_back(azimuths == 1 ? 0.0 : 180.0 * k / (azimuths - 1));
}

void SkyPatch::set_points(const SolvedSky& sky, double observer_km, double sun_zenith_deg) {
  std::vector<SightLine> lines;
  for (int point = 0; point < points(); ++point)
    lines.push_back({observer_km, point_zenith_deg(point), sun_zenith_deg, azimuth_deg_});
  std::vector<float> parts(lines.size() * sky.parts() * azimuth_deg_.size() * sky.wavelengths().size());
  sky.radiance_parts(lines, parts);
  set_points(sky, parts);
}

void SkyPatch::set_points(const SolvedSky& sky, std::span<const float> parts) {
  const std::size_t wavelengths = sky.wavelengths().size();
  const std::size_t width = sky.parts() * wavelengths;
  const auto azimuths = static_cast<std::size_t>(azimuths_);
  SKYLUT_CHECK_EQ(parts.size(), x_.size() * azimuths * width);
  const std::vector<double> series = cosine_series(azimuths);
  spectral_.assign(parts.size(), 0.0f);
  for (std::size_t m = 0; m < azimuths; ++m)
    for (std::size_t k = 0; k < azimuths; ++k) {
      const auto factor = static_cast<float>(series[m * azimuths + k]);
      for (std::size_t point = 0; point < x_.size(); ++point)
        for (std::size_t part = 0; part < sky.parts(); ++part) {
          const float* from = parts.data() + ((point * sky.parts() + part) * azimuths + k) * wavelengths;
          float* to = spectral_.data() + (point * azimuths + m) * width + part * wavelengths;
          for (std::size_t i = 0; i < wavelengths; ++i) to[i] += factor * from[i];
        }
    }
}

void SkyPatch::set_colours(const SolvedSky& sky) {
  const std::vector<ScatteringFactors::Term>& terms = sky.factors().terms();
  const std::size_t wavelengths = sky.wavelengths().size();
  const std::size_t width = sky.parts() * wavelengths;
  // Weights [X, Y, Z][term][wavelength].
  std::vector<float> weights;
  for (const auto channel : {&Xyz::X, &Xyz::Y, &Xyz::Z})
    for (const ScatteringFactors::Term& term : terms)
      for (std::size_t i = 0; i < wavelengths; ++i)
        weights.push_back(static_cast<float>(sky.colour_weights()[i].*channel * term.spectrum[i]));
  colour_.clear();
  for (std::size_t series = 0; series < spectral_.size() / width; ++series) {
    const float* weight = weights.data();
    for (int channel = 0; channel < 3; ++channel)
      for (const ScatteringFactors::Term& term : terms) {
        const float* part = spectral_.data() + series * width + term.part * wavelengths;
        float sum = 0.0f;
        for (std::size_t i = 0; i < wavelengths; ++i) sum += part[i] * weight[i];
        weight += wavelengths;
        colour_.push_back(sum);
      }
  }
}

void SkyPatch::blend(const std::vector<float>& coefficients, double zenith_deg, std::span<float> row) const {
  std::vector<double> weights(x_.size());
  lobatto_weights(panel_.coordinate(zenith_deg), x_, weights);
  SKYLUT_CHECK_EQ(row.size() * x_.size(), coefficients.size());
  std::fill(row.begin(), row.end(), 0.0f);
  for (std::size_t j = 0; j < x_.size(); ++j) {
    const auto weight = static_cast<float>(weights[j]);
    if (weight == 0.0f) continue;
    const float* point = coefficients.data() + j * row.size();
    for (std::size_t i = 0; i < row.size(); ++i) row[i] += weight * point[i];
  }
}

void SkyPatch::radiance(const ScatteringFactors& factors, std::span<const float> row,
                        const PatchDirection& direction, std::vector<float>& scratch,
                        std::span<float> radiance) {
  const std::size_t wavelengths = radiance.size();
  const std::size_t parts = factors.parts().size();
  const std::size_t width = parts * wavelengths;
  sum_series(row, width, direction.cos_azimuth, scratch);
  scratch.resize(2 * width);
  factors.spectral(direction.cos_scattering, std::span(scratch).last(width));
  std::fill(radiance.begin(), radiance.end(), 0.0f);
  const float* amplitude = scratch.data();
  const float* factor = scratch.data() + width;
  for (std::size_t part = 0; part < parts; ++part, amplitude += wavelengths, factor += wavelengths)
    for (std::size_t i = 0; i < wavelengths; ++i) radiance[i] += amplitude[i] * factor[i];
  for (float& value : radiance) value = std::max(value, 0.0f);
}

Xyz SkyPatch::colour(const SolvedSky& sky, std::span<const float> row, const PatchDirection& direction,
                     std::vector<float>& scratch) {
  const std::size_t terms = sky.factors().terms().size();
  const std::size_t width = 3 * terms;
  sum_series(row, width, direction.cos_azimuth, scratch);
  scratch.resize(width + terms);
  const float* amplitude = scratch.data();
  const float* factor = amplitude + width;
  sky.factors().terms_at(direction.cos_scattering, std::span(scratch).last(terms));
  float sums[3] = {};
  for (std::size_t channel = 0; channel < 3; ++channel)
    for (std::size_t term = 0; term < terms; ++term)
      sums[channel] += amplitude[channel * terms + term] * factor[term];
  return {static_cast<double>(std::max(sums[0], 0.0f)), static_cast<double>(std::max(sums[1], 0.0f)),
          static_cast<double>(std::max(sums[2], 0.0f))};
}

}  // namespace skylut
