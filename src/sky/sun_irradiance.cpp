#include "skylut/sky/sun_irradiance.hpp"

#include <cmath>
#include <memory>

#include "band_transmittance.hpp"
#include "horizon.hpp"
#include "plane_quadrature.hpp"
#include "sky_quadrature.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/sky/continuous_sky.hpp"
#include "skylut/sky/exact_sky.hpp"
#include "skylut/sky/sky_irradiance.hpp"
#include "skylut/transfer/direct_beam.hpp"
#include "skylut/transfer/refraction.hpp"

namespace skylut {

namespace {

void check(const SkyScene& scene, const SunIrradianceOptions& options) {
  require_one_of_each(scene);
  require_within("altitude", scene.altitudes_km[0], domain::kObserver_km);
  require_within("circumsolar half angle", options.circumsolar_half_angle_deg, domain::kCircumsolar_deg);
  if (options.plane) require_within("tilt of the plane", options.plane->tilt_deg, domain::kTilt_deg);
  const bool sky = options.diffuse || options.circumsolar_half_angle_deg > 0.0;
  const double sun_deg = scene.suns[0].zenith_deg;
  if (sky && !domain::kSunZenith_deg.holds(sun_deg))
    throw InputError("sun zenith angle {} deg: must lie within {} to {} deg with diffuse light", sun_deg,
                     domain::kSunZenith_deg.lowest, domain::kSunZenith_deg.highest);
  require_within("sun zenith angle", sun_deg, domain::kAnyZenith_deg);
}

void add_direct_beam(const SkyScene& scene, double aod500, SunIrradiance& result) {
  const double altitude_km = scene.altitudes_km[0];
  const double sun_deg = scene.suns[0].zenith_deg;
  const bool bends = !scene.atmosphere->shells().refractivity.empty();
  std::optional<std::vector<double>> path =
      beam_path_factors(scene.atmosphere->shells(), altitude_km, sun_deg);
  double concentration = 1.0;
  result.beam_arrives = path.has_value();
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i) {
    if (bends) {
      const Shells shells = scene.atmosphere->shells_at(scene.wavelengths[i]);
      path = beam_path_factors(shells, altitude_km, sun_deg);
      concentration = apparent_sun(shells, altitude_km, sun_deg).concentration;
    }
    const std::vector<ConstituentExtinction> constituents =
        scene.atmosphere->extinctions({scene.wavelengths[i], scene.wavelengths.step_nm()}, aod500);
    if (i == 0)
      for (const ConstituentExtinction& constituent : constituents)
        result.transmittance.push_back({constituent.name, {}});
    double product = concentration;
    for (std::size_t k = 0; k < constituents.size(); ++k) {
      const double transmittance = path ? band_transmittance(constituents[k], *path) : 0.0;
      result.transmittance[k].band_mean.push_back(transmittance);
      product *= transmittance;
    }
    result.direct_normal.push_back(result.extraterrestrial[i] * product);
  }
}

void add_beam_on_plane(const SunIrradianceOptions& options, SunIrradiance& result) {
  result.plane = options.plane;
  if (!options.plane) return;
  const double cosine = std::max(0.0, cos_incidence(*options.plane, result.seen_sun));
  for (const double normal : result.direct_normal) result.plane_direct.push_back(cosine * normal);
}

// Another integral over the sky, and where it goes.
struct SkyIntegral {
  SkyQuadrature quadrature;
  std::vector<double>* total;
};

std::vector<SkyIntegral> integrals(const SkyScene& scene, const SunIrradianceOptions& options,
                                   SunIrradiance& result) {
  const Direction& sun = result.seen_sun;
  std::vector<SkyIntegral> list;
  if (options.circumsolar_half_angle_deg > 0.0)
    list.push_back({circumsolar_quadrature(sun.zenith_deg, options.circumsolar_half_angle_deg),
                    &result.circumsolar_normal});
  if (options.diffuse && options.plane) {
    const double horizon_deg = horizon_zenith_deg(scene.atmosphere->shells(), scene.altitudes_km[0]);
    list.push_back({plane_quadrature(*options.plane, PlanePart::sky, sun, horizon_deg), &result.plane_sky});
    list.push_back(
        {plane_quadrature(*options.plane, PlanePart::ground, sun, horizon_deg), &result.plane_ground});
  }
  return list;
}

void add_sky(const Context& context, const SkyScene& scene, const SunIrradianceOptions& options,
             const TransferOptions& transfer, SunIrradiance& result) {
  const auto solved = std::make_shared<const SolvedSky>(context, scene, transfer);
  result.instruction_set = solved->report().kernel;
  std::unique_ptr<const SkyLight> sky;
  if (options.exact)
    sky = std::make_unique<ExactSky>(solved, scene.altitudes_km[0], scene.suns[0]);
  else
    sky = std::make_unique<ContinuousSky>(context, solved, scene.altitudes_km[0], scene.suns[0]);
  if (options.diffuse) result.diffuse_horizontal = diffuse_horizontal(*sky);
  for (const SkyIntegral& integral : integrals(scene, options, result))
    *integral.total = integrate(*sky, integral.quadrature);
}

}  // namespace

void require_one_of_each(const SkyScene& scene) {
  if (scene.altitudes_km.size() != 1 || scene.turbidities.size() != 1 || scene.suns.size() != 1)
    throw InputError("sun's irradiance of {} altitudes, {} turbidities, {} suns: must be one of each",
                     scene.altitudes_km.size(), scene.turbidities.size(), scene.suns.size());
}

std::vector<double> SunIrradiance::global_horizontal() const {
  const double cosine = std::max(0.0, std::cos(seen_sun.zenith_deg * kRadiansPerDegree));
  std::vector<double> global = diffuse_horizontal;
  for (std::size_t i = 0; i < global.size(); ++i) global[i] += cosine * direct_normal[i];
  return global;
}

std::vector<double> SunIrradiance::plane_global() const {
  std::vector<double> global = plane_sky;
  for (std::size_t i = 0; i < global.size(); ++i) global[i] += plane_direct[i] + plane_ground[i];
  return global;
}

SunIrradiance simulate_sun(const Context& context, const SkyScene& scene, const SunIrradianceOptions& options,
                           const TransferOptions& transfer) {
  check(scene, options);
  const double aod500 = to_aod500(scene.turbidities[0], *scene.atmosphere);
  SunIrradiance result;
  result.wavelengths = scene.wavelengths;
  result.sun = scene.suns[0];
  result.seen_sun = {
      apparent_sun(scene.atmosphere->shells(), scene.altitudes_km[0], result.sun.zenith_deg).zenith_deg,
      result.sun.azimuth_deg};
  result.luminous_weight = luminous_weights(context, scene.wavelengths);
  result.extraterrestrial = extraterrestrial_irradiance(context, scene);
  add_direct_beam(scene, aod500, result);
  add_beam_on_plane(options, result);
  if (options.diffuse || options.circumsolar_half_angle_deg > 0.0)
    add_sky(context, scene, options, transfer, result);
  return result;
}

double broadband_W_m2(const std::vector<double>& irradiance, const WavelengthGrid& wavelengths) {
  double sum = 0.0;
  for (const double value : irradiance) sum += value * wavelengths.step_nm();
  return sum;
}

std::vector<double> luminous_weights(const Context& context, const WavelengthGrid& wavelengths) {
  std::vector<double> weights;
  for (const Xyz& weight : ColourMatching::load(context).weights(wavelengths)) weights.push_back(weight.Y);
  return weights;
}

double illuminance_lux(const std::vector<double>& irradiance, const std::vector<double>& luminous_weight) {
  SKYLUT_CHECK_LE(irradiance.size(), luminous_weight.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < irradiance.size(); ++i) sum += luminous_weight[i] * irradiance[i];
  return sum;
}

}  // namespace skylut
