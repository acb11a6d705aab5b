#include "skylut/export/model_light.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

constexpr double kPlanetRadius_km = 6371.0;

double geometric_horizon_deg(double altitude_km) {
  return 90.0 + std::acos(kPlanetRadius_km / (kPlanetRadius_km + altitude_km)) * kDegreesPerRadian;
}

// Those of the directions that lie within a range, and their places.
struct Shown {
  std::vector<Direction> views;
  std::vector<std::size_t> places;

  Shown(std::span<const Direction> directions, const Range& zenith_deg) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      if (!zenith_deg.holds(directions[i].zenith_deg)) continue;
      views.push_back(directions[i]);
      places.push_back(i);
    }
  }
};

}  // namespace

ModelLight::ModelLight(std::shared_ptr<const Sky> sky, const Range& view_zenith_deg, const Direction& sun,
                       double altitude_km)
    : sky_(std::move(sky)),
      view_zenith_deg_(view_zenith_deg),
      sun_(sun),
      horizon_zenith_deg_(std::min(view_zenith_deg.highest, geometric_horizon_deg(altitude_km))),
      wavelengths_(sky_->wavelengths() != nullptr ? *sky_->wavelengths()
                                                  : WavelengthGrid(550.0, 550.0, 1.0)) {}

void ModelLight::radiance(std::span<const Direction> directions, std::span<float> radiance) const {
  const Shown shown(directions, view_zenith_deg_);
  const std::size_t wavelengths = wavelengths_.size();
  std::vector<float> values(shown.views.size() * wavelengths);
  sky_->radiance(shown.views, values);
  std::fill(radiance.begin(), radiance.end(), 0.0f);
  for (std::size_t i = 0; i < shown.places.size(); ++i)
    std::copy_n(&values[i * wavelengths], wavelengths, &radiance[shown.places[i] * wavelengths]);
}

void ModelLight::colour(std::span<const Direction> directions, std::span<Xyz> colour) const {
  const Shown shown(directions, view_zenith_deg_);
  std::vector<Yxy> values(shown.views.size());
  sky_->colour(shown.views, values);
  std::fill(colour.begin(), colour.end(), Xyz{});
  for (std::size_t i = 0; i < shown.places.size(); ++i) colour[shown.places[i]] = to_xyz(values[i]);
}

}  // namespace skylut
