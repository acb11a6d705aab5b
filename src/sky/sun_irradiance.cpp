#include "skylut/sky/sun_irradiance.hpp"

#include <cmath>

#include "band_columns.hpp"
#include "band_transmittance.hpp"
#include "sky_quadrature.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/transfer/direct_beam.hpp"

namespace skylut {

namespace {

void check(const SkyScene& scene, const SunIrradianceOptions& options) {
  require_one_of_each(scene);
  require_within("altitude", scene.altitudes_km[0], domain::kObserver_km);
  require_within("circumsolar half angle", options.circumsolar_half_angle_deg, domain::kCircumsolar_deg);
  const bool sky = options.diffuse || options.circumsolar_half_angle_deg > 0.0;
  const double sun_deg = scene.suns[0].zenith_deg;
  if (sky && !domain::kSunZenith_deg.holds(sun_deg))
    throw InputError("sun zenith angle {} deg: must lie within {} to {} deg with diffuse light", sun_deg,
                     domain::kSunZenith_deg.lowest, domain::kSunZenith_deg.highest);
  require_within("sun zenith angle", sun_deg, domain::kAnyZenith_deg);
}

void add_direct_beam(const SkyScene& scene, double aod500, SunIrradiance& result) {
  const auto path =
      beam_path_factors(scene.atmosphere->shells(), scene.altitudes_km[0], scene.suns[0].zenith_deg);
  result.beam_arrives = path.has_value();
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i) {
    const std::vector<ConstituentExtinction> constituents =
        scene.atmosphere->extinctions({scene.wavelengths[i], scene.wavelengths.step_nm()}, aod500);
    if (i == 0)
      for (const ConstituentExtinction& constituent : constituents)
        result.transmittance.push_back({constituent.name, {}});
    double product = 1.0;
    for (std::size_t k = 0; k < constituents.size(); ++k) {
      const double transmittance = path ? band_transmittance(constituents[k], *path) : 0.0;
      result.transmittance[k].band_mean.push_back(transmittance);
      product *= transmittance;
    }
    result.direct_normal.push_back(result.extraterrestrial[i] * product);
  }
}

// Sums of the sky's radiance with the weights of each quadrature.
void add_sky(const Context& context, const SkyScene& scene, const SunIrradianceOptions& options,
             const TransferOptions& transfer, SunIrradiance& result) {
  const double sun_deg = scene.suns[0].zenith_deg;
  const SkyQuadrature hemisphere = options.diffuse ? hemisphere_quadrature(sun_deg) : SkyQuadrature{};
  const SkyQuadrature cone = options.circumsolar_half_angle_deg > 0.0
                                 ? circumsolar_quadrature(sun_deg, options.circumsolar_half_angle_deg)
                                 : SkyQuadrature{};
  SkyRequest request{scene.altitudes_km, {sun_deg}, hemisphere.views};
  request.views.insert(request.views.end(), cone.views.begin(), cone.views.end());

  const BandColumns bands(scene);
  const SkyRadiance sky =
      solve_sky_radiance(context, scene.atmosphere->shells(), bands.columns, request, transfer);

  result.instruction_set = sky.report().kernel;

  const auto integrate = [&](const SkyQuadrature& quadrature, std::size_t first, std::vector<double>& total) {
    if (quadrature.views.empty()) return;
    total.assign(scene.wavelengths.size(), 0.0);
    for (std::size_t i = 0; i < scene.wavelengths.size(); ++i)
      for (std::size_t column = bands.first[i]; column < bands.first[i + 1]; ++column) {
        double sum = 0.0;
        for (std::size_t view = 0; view < quadrature.views.size(); ++view)
          sum += quadrature.weight[view] * static_cast<double>(sky.at(column, 0, 0, first + view));
        total[i] += result.extraterrestrial[i] * bands.weights[column] * sum;
      }
  };
  integrate(hemisphere, 0, result.diffuse_horizontal);
  integrate(cone, hemisphere.views.size(), result.circumsolar_normal);
}

}  // namespace

void require_one_of_each(const SkyScene& scene) {
  if (scene.altitudes_km.size() != 1 || scene.turbidities.size() != 1 || scene.suns.size() != 1)
    throw InputError("sun's irradiance of {} altitudes, {} turbidities, {} suns: must be one of each",
                     scene.altitudes_km.size(), scene.turbidities.size(), scene.suns.size());
}

std::vector<double> SunIrradiance::global_horizontal() const {
  const double cosine = std::max(0.0, std::cos(sun.zenith_deg * kRadiansPerDegree));
  std::vector<double> global = diffuse_horizontal;
  for (std::size_t i = 0; i < global.size(); ++i) global[i] += cosine * direct_normal[i];
  return global;
}

SunIrradiance simulate_sun(const Context& context, const SkyScene& scene, const SunIrradianceOptions& options,
                           const TransferOptions& transfer) {
  check(scene, options);
  const double aod500 = to_aod500(scene.turbidities[0], *scene.atmosphere);
  SunIrradiance result;
  result.wavelengths = scene.wavelengths;
  result.sun = scene.suns[0];
  result.luminous_weight = luminous_weights(context, scene.wavelengths);
  result.extraterrestrial = extraterrestrial_irradiance(context, scene);
  add_direct_beam(scene, aod500, result);
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
