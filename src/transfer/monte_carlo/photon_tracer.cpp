#include "photon_tracer.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::monte_carlo {
namespace {

/// Photons lighter than this, relative to where they started, play Russian roulette: one in ten goes on,
/// ten times heavier. Unbiased, and paths in dark media end.
constexpr double kRouletteWeight = 0.05;
constexpr double kRouletteSurvival = 0.1;

/// A photon that by chance flies almost into the sun finds the forward peak at its next collision: a rare,
/// large contribution. So where some phase function has a peak, this share of new directions is drawn about
/// the direction of the sun, by that phase function, and each direction weighted by law / (mixture drawn
/// from): the weight is then small just where the find is large (detector directional importance sampling,
/// Buras & Mayer 2011, JQSRT 112, 434, reduced to its first step).
constexpr double kShareTowardsSun = 0.2;
constexpr double kPeak = 5.0;

}  // namespace

PhotonTracer::PhotonTracer(const Shells& shells, const OpticalColumn& column, const Vector& to_sun,
                           int orders)
    : shells_(shells, column), to_sun_(to_sun), orders_(orders), ground_albedo_(column.ground_albedo) {
  for (const Scatterer& scatterer : column.scatterers) samplers_.emplace_back(*scatterer.phase);
  for (std::size_t layer = 0; layer < column.extinction_depth.size(); ++layer) {
    std::vector<double> shares;
    for (const Scatterer& scatterer : column.scatterers)
      shares.push_back(column.extinction_depth[layer] > 0.0
                           ? scatterer.scattering_depth[layer] / column.extinction_depth[layer]
                           : 0.0);
    albedo_.push_back(std::move(shares));
  }
  for (std::size_t s = 0; s < samplers_.size(); ++s)
    if (samplers_[s].value(1.0) > samplers_[most_peaked_].value(1.0)) most_peaked_ = s;
  if (!samplers_.empty() && samplers_[most_peaked_].value(1.0) > kPeak) share_towards_sun_ = kShareTowardsSun;
}

template <typename Path>
void PhotonTracer::find_sunlight(const PhotonPosition& place, const Vector& direction, Path& path) const {
  const double transmitted = std::exp(-shells_.depth_to_top(place, to_sun_));
  if (transmitted == 0.0) return;
  // Backwards: light from the sun turns by the same angle as the photon that goes towards it.
  const double cos_angle = std::fmin(1.0, std::fmax(-1.0, dot(direction, to_sun_)));
  typename Path::Law scattered{};
  for (std::size_t s = 0; s < samplers_.size(); ++s)
    if (albedo_[place.layer][s] > 0.0)
      Path::add(scattered, albedo_[place.layer][s], Path::law(samplers_[s].phase(), cos_angle));
  path.find_scattered(direction, to_sun_, scattered, transmitted);
}

double PhotonTracer::sunlight_reflected(const PhotonPosition& place) const {
  const double cos_sun = dot(normalised(place.position), to_sun_);
  if (cos_sun <= 0.0) return 0.0;
  return ground_albedo_ / kPi * cos_sun * std::exp(-shells_.depth_to_top(place, to_sun_));
}

PhotonTracer::Scattering PhotonTracer::scatter(const PhotonPosition& place, const Vector& direction,
                                               RandomStream& random) const {
  const std::vector<double>& shares = albedo_[place.layer];
  double albedo = 0.0;
  for (double share : shares) albedo += share;
  if (albedo == 0.0) return {};
  double rest = random.uniform() * albedo;
  std::size_t chosen = shares.size();
  for (std::size_t s = 0; s < shares.size(); ++s) {
    if (shares[s] == 0.0) continue;
    chosen = s;
    if (rest < shares[s]) break;
    rest -= shares[s];
  }
  const PhaseSampler& sampler = samplers_[chosen];
  const double azimuth = 2.0 * kPi * random.uniform();
  if (share_towards_sun_ == 0.0) {
    const double cos_angle = sampler.draw(random);
    return {albedo, chosen, turned(direction, cos_angle, azimuth), cos_angle, sampler.density(cos_angle)};
  }
  const PhaseSampler& peaked = samplers_[most_peaked_];
  const bool towards_sun = random.uniform() < share_towards_sun_;
  const Vector drawn = towards_sun ? turned(to_sun_, peaked.draw(random), azimuth)
                                   : turned(direction, sampler.draw(random), azimuth);
  const double cos_angle = dot(drawn, direction);
  const double density = (1.0 - share_towards_sun_) * sampler.density(cos_angle) +
                         share_towards_sun_ * peaked.density(dot(drawn, to_sun_));
  return {albedo, chosen, drawn, cos_angle, density};
}

double PhotonTracer::reflect(const PhotonPosition& place, Vector& direction, RandomStream& random) const {
  // Lambert: the square of the cosine of the zenith angle is uniform; densities are per 2π of azimuth.
  const Vector up = normalised(place.position);
  const double azimuth = 2.0 * kPi * random.uniform();
  const bool towards_sun = random.uniform() < share_towards_sun_;
  direction = towards_sun ? turned(to_sun_, samplers_[most_peaked_].draw(random), azimuth)
                          : turned(up, std::sqrt(1.0 - random.uniform()), azimuth);
  if (share_towards_sun_ == 0.0) return ground_albedo_;
  const double law = 2.0 * std::fmax(0.0, dot(direction, up));
  const double density = (1.0 - share_towards_sun_) * law +
                         share_towards_sun_ * samplers_[most_peaked_].density(dot(direction, to_sun_));
  return ground_albedo_ * law / density;
}

WalkEnd PhotonTracer::fly(PhotonPosition& place, const Vector& direction, RandomStream& random) const {
  double left = -std::log(1.0 - random.uniform());
  double flown = 0.0;
  std::size_t in_layer = place.layer;
  const WalkEnd end = shells_.walk(place, direction, [&](std::size_t layer, double start, double length) {
    const double extinction = shells_.extinction_per_km(layer);
    in_layer = layer;
    if (left < extinction * length) {
      flown = start + left / extinction;
      return false;
    }
    left -= extinction * length;
    flown = start + length;
    return true;
  });
  place = {along(place.position, direction, flown), in_layer};
  return end;
}

template <typename Path>
typename Path::Found PhotonTracer::trace(const FirstCollision::Draw& first, Vector direction, Path path,
                                         RandomStream& random) const {
  PhotonPosition place = first.place;
  bool at_ground = first.ground;
  for (int order = 1;; ++order) {
    if (at_ground)
      path.find_reflected(sunlight_reflected(place));
    else
      find_sunlight(place, direction, path);
    if (order == orders_) break;
    if (at_ground) {
      const double factor = reflect(place, direction, random);
      path.reflect(direction, factor);
    } else {
      const Scattering drawn = scatter(place, direction, random);
      if (drawn.albedo == 0.0) break;
      path.scatter(direction, drawn.direction, drawn.albedo,
                   Path::law(samplers_[drawn.scatterer].phase(), drawn.cos_angle), drawn.density);
      direction = drawn.direction;
    }
    if (path.weight() == 0.0) break;
    if (std::abs(path.weight()) < kRouletteWeight) {
      if (random.uniform() >= kRouletteSurvival) break;
      path.divide_weight(kRouletteSurvival);
    }
    const WalkEnd end = fly(place, direction, random);
    if (end == WalkEnd::top) break;
    at_ground = end == WalkEnd::ground;
  }
  return path.found(first.weight);
}

template double PhotonTracer::trace(const FirstCollision::Draw&, Vector, IntensityPath, RandomStream&) const;
template Stokes PhotonTracer::trace(const FirstCollision::Draw&, Vector, StokesPath, RandomStream&) const;

}  // namespace skylut::monte_carlo
