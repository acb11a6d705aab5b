#include "skylut/sky/exact_sky.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "horizon.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/sky/view_set.hpp"

namespace skylut {

ExactSky::ExactSky(std::shared_ptr<const SolvedSky> solved, double altitude_km, const Direction& sun,
                   double sun_distance_au)
    : solved_(std::move(solved)),
      altitude_km_(altitude_km),
      sun_(sun),
      horizon_zenith_deg_(skylut::horizon_zenith_deg(solved_->shells(), altitude_km)),
      scale_(1.0 / (sun_distance_au * sun_distance_au)) {
  require_within("altitude", altitude_km, domain::kObserver_km);
  require_within("sun zenith angle", sun.zenith_deg, domain::kSunZenith_deg);
  if (!(sun_distance_au > 0.0)) throw InputError("sun's distance {} au: must be > 0", sun_distance_au);
}

void ExactSky::radiance(std::span<const Direction> directions, std::span<float> radiance) const {
  const std::size_t width = wavelengths().size();
  SKYLUT_CHECK_EQ(radiance.size(), directions.size() * width);
  struct Line {
    std::vector<double> azimuths_deg;
    std::vector<std::size_t> directions;
  };
  std::map<double, Line> lines;  // by zenith angle
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const RelativeView view = relative_view(directions[i], sun_);
    lines[view.zenith_deg].azimuths_deg.push_back(view.relative_azimuth_deg);
    lines[view.zenith_deg].directions.push_back(i);
  }
  std::vector<float> found;
  for (const auto& [zenith_deg, line] : lines) {
    found.resize(line.directions.size() * width);
    solved_->radiance({altitude_km_, zenith_deg, sun_.zenith_deg, line.azimuths_deg}, found);
    for (std::size_t i = 0; i < line.directions.size(); ++i)
      for (std::size_t k = 0; k < width; ++k)
        radiance[line.directions[i] * width + k] = static_cast<float>(scale_) * found[i * width + k];
  }
}

void ExactSky::colour(std::span<const Direction> directions, std::span<Xyz> colour) const {
  const std::size_t width = wavelengths().size();
  std::vector<float> spectra(directions.size() * width);
  radiance(directions, spectra);
  for (std::size_t i = 0; i < directions.size(); ++i)
    colour[i] = weighted_sum<float>(solved_->colour_weights(), std::span(spectra).subspan(i * width, width));
}

}  // namespace skylut
