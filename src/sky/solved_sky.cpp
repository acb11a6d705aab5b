#include "skylut/sky/solved_sky.hpp"

#include "band_columns.hpp"
#include "scattering_factors.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/sky/limb_darkening.hpp"
#include "skylut/sky/sky_scene.hpp"
#include "skylut/sky/sun_disc.hpp"

namespace skylut {

SolvedSky::SolvedSky(const Context& context, const SkyScene& scene, const TransferOptions& options,
                     SunShape shape)
    : wavelengths_(scene.wavelengths),
      colour_weights_(ColourMatching::load(context).weights(scene.wavelengths)) {
  if (scene.turbidities.size() != 1 || scene.suns.empty())
    throw InputError("solved sky of {} turbidities and {} suns: needs one turbidity and at least one sun",
                     scene.turbidities.size(), scene.suns.size());
  BandColumns bands(scene);
  const std::vector<double> irradiance = extraterrestrial_irradiance(context, scene);
  first_column_ = bands.first;
  for (std::size_t i = 0; i < wavelengths_.size(); ++i)
    for (std::size_t column = bands.first[i]; column < bands.first[i + 1]; ++column)
      column_weight_.push_back(static_cast<float>(irradiance[i] * bands.weights[column]));
  std::vector<double> suns_deg;
  for (const Direction& sun : scene.suns) suns_deg.push_back(sun.zenith_deg);
  columns_ = std::make_unique<SolvedColumns>(context, scene.atmosphere->shells(), std::move(bands.columns),
                                             suns_deg, options);
  factors_ = std::make_unique<const ScatteringFactors>(*columns_,
                                                       std::span(first_column_).first(wavelengths_.size()));
  if (shape == SunShape::point) return;
  const LimbDarkening limb = LimbDarkening::load(context);
  std::vector<LimbDarkeningLaw> darkening;
  for (std::size_t i = 0; i < wavelengths_.size(); ++i) darkening.push_back(limb.at(wavelengths_[i]));
  averaged_factors_ = std::make_unique<const ScatteringFactors>(
      factors_->over_disc(sun_angular_radius_deg(scene.sun_distance_au), darkening));
}

SolvedSky::~SolvedSky() = default;
SolvedSky::SolvedSky(SolvedSky&&) noexcept = default;
SolvedSky& SolvedSky::operator=(SolvedSky&&) noexcept = default;

std::size_t SolvedSky::parts() const { return factors_->parts().size(); }

void SolvedSky::radiance(const SightLine& line, std::span<float> radiance) const {
  const std::size_t azimuths = line.relative_azimuth_deg.size();
  const std::size_t width = wavelengths_.size();
  SKYLUT_CHECK_EQ(radiance.size(), azimuths * width);
  std::vector<float> columns(columns_->columns() * azimuths);
  columns_->radiance(line, columns);
  for (std::size_t azimuth = 0; azimuth < azimuths; ++azimuth)
    for (std::size_t i = 0; i < width; ++i) {
      double sum = 0.0;
      for (std::size_t column = first_column_[i]; column < first_column_[i + 1]; ++column)
        sum += static_cast<double>(column_weight_[column]) *
               static_cast<double>(columns[column * azimuths + azimuth]);
      radiance[azimuth * width + i] = static_cast<float>(sum);
    }
}

void SolvedSky::collect(std::span<const float> of_columns, std::size_t azimuths,
                        std::span<float> parts) const {
  const std::size_t width = wavelengths_.size();
  const std::size_t columns = columns_->columns();
  float* out = parts.data();
  for (const std::size_t part : factors_->parts())
    for (std::size_t azimuth = 0; azimuth < azimuths; ++azimuth) {
      const float* from = of_columns.data() + (part * azimuths + azimuth) * columns;
      for (std::size_t i = 0; i < width; ++i) {
        float sum = 0.0f;
        for (std::size_t column = first_column_[i]; column < first_column_[i + 1]; ++column)
          sum += column_weight_[column] * from[column];
        *out++ = sum;
      }
    }
}

void SolvedSky::radiance_parts(std::span<const SightLine> lines, std::span<float> parts) const {
  if (lines.empty()) return;
  const std::size_t azimuths = lines.front().relative_azimuth_deg.size();
  const std::size_t of_line = this->parts() * azimuths * wavelengths_.size();
  const std::size_t all_of_line = columns_->parts() * azimuths * columns_->columns();
  SKYLUT_CHECK_EQ(parts.size(), lines.size() * of_line);
  std::vector<float> of_columns(lines.size() * all_of_line);
  columns_->radiance_parts(lines, of_columns);
  for (std::size_t line = 0; line < lines.size(); ++line)
    collect(std::span(of_columns).subspan(line * all_of_line, all_of_line), azimuths,
            parts.subspan(line * of_line, of_line));
}

void SolvedSky::radiance_parts(const SightFan& fan, std::span<float> parts) const {
  const std::size_t suns = fan.sun_zenith_deg.size();
  const std::size_t azimuths = fan.relative_azimuth_deg.size();
  const std::size_t of_sun = this->parts() * azimuths * wavelengths_.size();
  const std::size_t all_of_sun = columns_->parts() * azimuths * columns_->columns();
  SKYLUT_CHECK_EQ(parts.size(), suns * of_sun);
  std::vector<float> of_columns(suns * all_of_sun);
  columns_->radiance_parts(fan, of_columns);
  for (std::size_t sun = 0; sun < suns; ++sun)
    collect(std::span(of_columns).subspan(sun * all_of_sun, all_of_sun), azimuths,
            parts.subspan(sun * of_sun, of_sun));
}

}  // namespace skylut
