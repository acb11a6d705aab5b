#include "skylut/sky/sun_disc.hpp"

#include <algorithm>
#include <cmath>

#include "band_transmittance.hpp"
#include "horizon.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"
#include "skylut/core/quadrature.hpp"
#include "skylut/sky/sun_irradiance.hpp"
#include "skylut/transfer/direct_beam.hpp"
#include "skylut/transfer/refraction.hpp"

namespace skylut {

// In units of the disc's radius, to the right (azimuth clockwise) and up, in Lambert's equal-area projection
// about its centre: r = sin(ρ/2)/sin(ρ0/2) for the angle ρ from the centre, so that dω = (Ω/π) dx dy. Seen
// from the distance of many radii, r² is also 1 - μ² (to 3e-6 of r).
struct SunDisc::Place {
  double x = 0.0;
  double y = 0.0;

  double radius_square() const { return x * x + y * y; }
  double mu() const { return std::sqrt(std::max(0.0, 1.0 - radius_square())); }
};

struct SunDisc::Node {
  Direction direction;  // apparent
  double mu = 0.0;
  double solid_angle_sr = 0.0;  // apparent
};

namespace {

constexpr double kSunAngularRadius_arcsec = 959.63;

// Zenith angles over the disc, between which ln T is a straight line: at most this many, 7.5 arcsec apart.
constexpr int kMostTransmittanceNodes = 257;
constexpr double kPathError = 1e-6;  // of the straight line, in optical depths of the zenith

// A path along sec θ strays from its chord by h²/8 (sec θ)'', which is sec³θ (1 + sin²θ).
int transmittance_nodes(double top_deg, double bottom_deg) {
  const double cosine = std::cos(bottom_deg * kRadiansPerDegree);
  if (cosine < 0.01) return kMostTransmittanceNodes;
  const double curvature = (2.0 - cosine * cosine) / (cosine * cosine * cosine);
  const double pieces =
      (bottom_deg - top_deg) * kRadiansPerDegree * std::sqrt(curvature / (8.0 * kPathError));
  return 2 + static_cast<int>(std::min(pieces, kMostTransmittanceNodes - 2.0));
}

// Of the disc's own sums; the limb's √(1 - r²) is smooth in the angles that are integrated over.
constexpr int kOrder = 48;
constexpr int kLowestOrder = 16;  // for points

}  // namespace

double sun_angular_radius_deg(double distance_au) {
  SKYLUT_CHECK_GE(distance_au, 0.01);
  return std::asin(std::sin(kSunAngularRadius_arcsec / 3600.0 * kRadiansPerDegree) / distance_au) *
         kDegreesPerRadian;
}

double sun_solid_angle_sr(double distance_au) {
  const double half_sine = std::sin(0.5 * sun_angular_radius_deg(distance_au) * kRadiansPerDegree);
  return 4.0 * kPi * half_sine * half_sine;
}

SunDisc::SunDisc(const Context& context, const SkyScene& scene) : wavelengths_(scene.wavelengths) {
  require_one_of_each(scene);
  require_within("altitude", scene.altitudes_km[0], domain::kObserver_km);
  require_within("sun zenith angle", scene.suns[0].zenith_deg, domain::kAnyZenith_deg);
  const Atmosphere& air = *scene.atmosphere;
  const double altitude_km = scene.altitudes_km[0];
  const double aod500 = to_aod500(scene.turbidities[0], air);
  sun_ = scene.suns[0];
  angular_radius_deg_ = sun_angular_radius_deg(scene.sun_distance_au);
  solid_angle_sr_ = sun_solid_angle_sr(scene.sun_distance_au);
  horizon_zenith_deg_ = horizon_zenith_deg(air.shells(), altitude_km);
  bends_ = !air.shells().refractivity.empty();
  last_sun_deg_ = bends_ ? last_sun_zenith_deg(air.shells(), altitude_km) : horizon_zenith_deg_;

  const LimbDarkening darkening = LimbDarkening::load(context);
  mean_above_air_ = extraterrestrial_irradiance(context, scene);
  for (std::size_t i = 0; i < wavelengths_.size(); ++i) {
    darkening_.push_back(darkening.at(wavelengths_[i]));
    mean_above_air_[i] /= solid_angle_sr_;
  }
  colour_weight_ = ColourMatching::load(context).weights(wavelengths_);

  direct_normal_.assign(wavelengths_.size(), 0.0);
  const double top_deg = std::max(0.0, sun_.zenith_deg - angular_radius_deg_);
  const double bottom_deg = std::min(sun_.zenith_deg + angular_radius_deg_, last_sun_deg_);
  if (top_deg >= bottom_deg) return;
  const auto seen_deg = [&](double sun_deg) {
    return std::min(apparent_sun(air.shells(), altitude_km, sun_deg).zenith_deg, horizon_zenith_deg_);
  };
  fill_transmittance(air, altitude_km, aod500, seen_deg(top_deg), seen_deg(bottom_deg));
  // A segment of the unit disc, of π.
  const double y = lowest_y();
  visible_true_sr_ = solid_angle_sr_ * (0.5 - (std::asin(y) + y * std::sqrt(1.0 - y * y)) / kPi);
  if (!bends_) visible_solid_angle_sr_ = visible_true_sr_;
  std::vector<double> radiance(wavelengths_.size());
  for (const Node& node : quadrature(kOrder)) {
    if (bends_) visible_solid_angle_sr_ += node.solid_angle_sr;
    spectrum(node.mu, node.direction.zenith_deg, radiance);
    for (std::size_t i = 0; i < radiance.size(); ++i) direct_normal_[i] += node.solid_angle_sr * radiance[i];
  }
}

void SunDisc::fill_transmittance(const Atmosphere& air, double altitude_km, double aod500, double top_deg,
                                 double bottom_deg) {
  std::vector<std::vector<double>> paths;
  const int nodes = transmittance_nodes(top_deg, bottom_deg);
  for (int n = 0; n < nodes; ++n) {
    zenith_deg_.push_back(linear(top_deg, bottom_deg, n / (nodes - 1.0)));
    const auto path = sight_path_factors(air.shells(), altitude_km, zenith_deg_.back());
    SKYLUT_CHECK(path.has_value());
    paths.push_back(*path);
    if (!bends_) continue;
    true_deg_.push_back(true_sun_zenith_deg(air.shells(), altitude_km, zenith_deg_.back()));
    concentration_.push_back(apparent_sun(air.shells(), altitude_km, true_deg_.back()).concentration);
  }
  transmittance_.assign(zenith_deg_.size() * wavelengths_.size(), 1.0);
  for (std::size_t i = 0; i < wavelengths_.size(); ++i)
    for (const ConstituentExtinction& constituent :
         air.extinctions({wavelengths_[i], wavelengths_.step_nm()}, aod500))
      for (std::size_t n = 0; n < paths.size(); ++n)
        transmittance_[n * wavelengths_.size() + i] *= band_transmittance(constituent, paths[n]);
}

double SunDisc::lowest_y() const {
  const double to_horizon = 0.5 * (last_sun_deg_ - sun_.zenith_deg) * kRadiansPerDegree;
  return std::clamp(-std::sin(to_horizon) / std::sin(0.5 * angular_radius_deg_ * kRadiansPerDegree), -1.0,
                    1.0);
}

// With y = sin β and x = cos β sin α the disc is -π/2 <= α, β <= π/2, dx dy = cos²β cos α dα dβ and μ = cos β
// cos α: whatever is a polynomial of μ is analytic, and Gauss-Legendre nodes do it justice. The horizon cuts
// at one β: it is as good as straight over half a degree (from 30 km it strays by 2e-4 of the radius).
std::vector<SunDisc::Node> SunDisc::quadrature(int order) const {
  if (zenith_deg_.empty()) return {};
  const Quadrature rows = gauss_legendre(order, std::asin(lowest_y()), 0.5 * kPi);
  const Quadrature along = gauss_legendre(order, -0.5 * kPi, 0.5 * kPi);
  std::vector<Node> nodes;
  for (std::size_t row = 0; row < rows.node.size(); ++row)
    for (std::size_t k = 0; k < along.node.size(); ++k) {
      const double half_chord = std::cos(rows.node[row]);
      const Place place{half_chord * std::sin(along.node[k]), std::sin(rows.node[row])};
      const double area =
          rows.weight[row] * along.weight[k] * half_chord * half_chord * std::cos(along.node[k]);
      const Direction sun = direction_of(place);
      nodes.push_back({seen(sun), place.mu(), area * solid_angle_sr_ / kPi * concentration(sun.zenith_deg)});
    }
  return nodes;
}

Direction SunDisc::direction_of(const Place& place) const {
  const double r = std::sqrt(place.radius_square());
  const double rho =
      2.0 * std::asin(std::min(r, 1.0) * std::sin(0.5 * angular_radius_deg_ * kRadiansPerDegree));
  const double to_right = r > 0.0 ? std::sin(rho) * place.x / r : 0.0;
  const double to_top = r > 0.0 ? std::sin(rho) * place.y / r : 0.0;
  const double zenith = sun_.zenith_deg * kRadiansPerDegree;
  const double up = std::cos(rho) * std::cos(zenith) + to_top * std::sin(zenith);
  const double along = std::cos(rho) * std::sin(zenith) - to_top * std::cos(zenith);
  return {std::atan2(std::hypot(along, to_right), up) * kDegreesPerRadian,
          wrapped_azimuth_deg(sun_.azimuth_deg + std::atan2(to_right, along) * kDegreesPerRadian)};
}

Direction SunDisc::seen(const Direction& sun) const {
  if (!bends_) return sun;
  const Bracket between = held_bracket(true_deg_, sun.zenith_deg);
  return {linear(zenith_deg_[between.below], zenith_deg_[between.above], between.part), sun.azimuth_deg};
}

double SunDisc::concentration(double sun_zenith_deg) const {
  if (!bends_) return 1.0;
  const Bracket between = held_bracket(true_deg_, sun_zenith_deg);
  return linear(concentration_[between.below], concentration_[between.above], between.part);
}

double SunDisc::visible_mu(const Direction& direction) const {
  if (zenith_deg_.empty() || direction.zenith_deg > horizon_zenith_deg_) return -1.0;
  Direction sun = direction;
  if (bends_) {
    if (direction.zenith_deg < zenith_deg_.front() || direction.zenith_deg > zenith_deg_.back()) return -1.0;
    const Bracket between = held_bracket(zenith_deg_, direction.zenith_deg);
    sun.zenith_deg = linear(true_deg_[between.below], true_deg_[between.above], between.part);
  }
  const double r =
      std::sin(0.5 * angle_between(sun, sun_)) / std::sin(0.5 * angular_radius_deg_ * kRadiansPerDegree);
  return r <= 1.0 ? Place{r, 0.0}.mu() : -1.0;
}

void SunDisc::spectrum(double mu, double zenith_deg, std::span<double> radiance) const {
  const Bracket between = held_bracket(zenith_deg_, zenith_deg);
  const double* const above = &transmittance_[between.below * wavelengths_.size()];
  const double* const below = &transmittance_[between.above * wavelengths_.size()];
  for (std::size_t i = 0; i < radiance.size(); ++i)
    radiance[i] =
        mean_above_air_[i] * darkening_[i](mu) * log_linear_or_linear(above[i], below[i], between.part);
}

Xyz SunDisc::to_colour(std::span<const double> spectrum) const {
  return weighted_sum<double>(colour_weight_, spectrum);
}

void SunDisc::radiance(std::span<const Direction> directions, std::span<float> radiance) const {
  SKYLUT_CHECK_EQ(radiance.size(), directions.size() * wavelengths_.size());
  std::fill(radiance.begin(), radiance.end(), 0.0f);
  std::vector<double> one(wavelengths_.size());
  for (std::size_t d = 0; d < directions.size(); ++d) {
    const double mu = visible_mu(directions[d]);
    if (mu < 0.0) continue;
    spectrum(mu, directions[d].zenith_deg, one);
    std::transform(one.begin(), one.end(), &radiance[d * one.size()],
                   [](double value) { return static_cast<float>(value); });
  }
}

void SunDisc::colour(std::span<const Direction> directions, std::span<Xyz> colour) const {
  SKYLUT_CHECK_EQ(colour.size(), directions.size());
  std::vector<double> one(wavelengths_.size());
  for (std::size_t d = 0; d < directions.size(); ++d) {
    colour[d] = {};
    const double mu = visible_mu(directions[d]);
    if (mu < 0.0) continue;
    spectrum(mu, directions[d].zenith_deg, one);
    colour[d] = to_colour(one);
  }
}

SunDiscPoints SunDisc::points(double spacing_deg) const {
  require_within("spacing of the disc's points", spacing_deg, domain::kDiscSpacing_deg);
  // Gauss-Legendre nodes on [-π/2, π/2] are less than π²/2/order apart.
  const double order = std::ceil(0.5 * kPi * kPi * angular_radius_deg_ / spacing_deg);
  SunDiscPoints points;
  std::vector<double> sum(wavelengths_.size(), 0.0);
  for (const Node& node : quadrature(std::max(kLowestOrder, static_cast<int>(order)))) {
    points.directions.push_back(node.direction);
    const std::size_t first = points.irradiance.size();
    points.irradiance.resize(first + sum.size());
    spectrum(node.mu, node.direction.zenith_deg, {&points.irradiance[first], sum.size()});
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += points.irradiance[first + i] *= node.solid_angle_sr;
  }
  // What one order of quadrature differs from another by (1e-6) is taken out.
  for (std::size_t i = 0; i < points.irradiance.size(); ++i) {
    const std::size_t wavelength = i % sum.size();
    if (sum[wavelength] > 0.0) points.irradiance[i] *= direct_normal_[wavelength] / sum[wavelength];
  }
  for (std::size_t p = 0; p < points.directions.size(); ++p)
    points.illuminance.push_back(to_colour({&points.irradiance[p * sum.size()], sum.size()}));
  return points;
}

}  // namespace skylut
