#include "skylut/sky/sun_irradiance.hpp"

#include <cmath>

#include "sky_quadrature.hpp"
#include "skylut/atmosphere/solar_spectrum.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/transfer/direct_beam.hpp"

namespace skylut {

namespace {

constexpr double kHighestObserver_km = 30.0;
constexpr double kLowestSunWithSky_deg = 96.0;
constexpr double kWidestCone_deg = 10.0;

void check(const SkyScene& scene, const SunIrradianceOptions& options) {
  if (scene.altitudes_km.size() != 1 || scene.turbidities.size() != 1 || scene.suns.size() != 1)
    throw InputError("sun's irradiance of {} altitudes, {} turbidities, {} suns: must be one of each",
                     scene.altitudes_km.size(), scene.turbidities.size(), scene.suns.size());
  if (!(scene.altitudes_km[0] >= 0.0 && scene.altitudes_km[0] <= kHighestObserver_km))
    throw InputError("altitude {} km: must lie within 0 to {} km", scene.altitudes_km[0],
                     kHighestObserver_km);
  const double cone_deg = options.circumsolar_half_angle_deg;
  if (!(cone_deg >= 0.0 && cone_deg <= kWidestCone_deg))
    throw InputError("circumsolar half angle {} deg: must lie within 0 to {} deg", cone_deg, kWidestCone_deg);
  const bool sky = options.diffuse || cone_deg > 0.0;
  const double lowest_sun_deg = sky ? kLowestSunWithSky_deg : 180.0;
  if (!(scene.suns[0].zenith_deg >= 0.0 && scene.suns[0].zenith_deg <= lowest_sun_deg))
    throw InputError("sun zenith angle {} deg: must lie within 0 to {} deg{}", scene.suns[0].zenith_deg,
                     lowest_sun_deg, sky ? " with diffuse light" : "");
}

double band_transmittance(const Constituent& constituent, const std::vector<double>& path_factors) {
  double sum = 0.0;
  for (const AbsorptionTerm& term : constituent.terms)
    sum += term.weight * beam_transmittance(path_factors, term.depth);
  return sum;
}

void add_direct_beam(const Atmosphere& air, const SkyScene& scene, double aod500, SunIrradiance& result) {
  const auto path = beam_path_factors(air.shells(), scene.altitudes_km[0], scene.suns[0].zenith_deg);
  result.beam_arrives = path.has_value();
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i) {
    const std::vector<Constituent> constituents =
        air.constituents(scene.wavelengths[i], scene.wavelengths.step_nm(), aod500);
    if (i == 0)
      for (const Constituent& constituent : constituents)
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
void add_sky(const Atmosphere& air, const SkyScene& scene, double aod500, const SunIrradianceOptions& options,
             const TransferOptions& transfer, SunIrradiance& result) {
  const double sun_deg = scene.suns[0].zenith_deg;
  const SkyQuadrature hemisphere = options.diffuse ? hemisphere_quadrature(sun_deg) : SkyQuadrature{};
  const SkyQuadrature cone = options.circumsolar_half_angle_deg > 0.0
                                 ? circumsolar_quadrature(sun_deg, options.circumsolar_half_angle_deg)
                                 : SkyQuadrature{};
  SkyRequest request{scene.altitudes_km, {sun_deg}, hemisphere.views};
  request.views.insert(request.views.end(), cone.views.begin(), cone.views.end());

  std::vector<OpticalColumn> columns;
  std::vector<double> share;      // of its band
  std::vector<std::size_t> band;  // of each column
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i)
    for (ColumnTerm& term : air.band_columns(scene.wavelengths[i], scene.wavelengths.step_nm(), aod500)) {
      columns.push_back(std::move(term.column));
      share.push_back(term.weight);
      band.push_back(i);
    }
  const SkyRadiance sky = solve_sky_radiance(air.shells(), columns, request, transfer);

  const auto integrate = [&](const SkyQuadrature& quadrature, std::size_t first, std::vector<double>& total) {
    if (quadrature.views.empty()) return;
    total.assign(scene.wavelengths.size(), 0.0);
    for (std::size_t column = 0; column < columns.size(); ++column) {
      double sum = 0.0;
      for (std::size_t view = 0; view < quadrature.views.size(); ++view)
        sum += quadrature.weight[view] * static_cast<double>(sky.at(column, 0, 0, first + view));
      total[band[column]] += result.extraterrestrial[band[column]] * share[column] * sum;
    }
  };
  integrate(hemisphere, 0, result.diffuse_horizontal);
  integrate(cone, hemisphere.views.size(), result.circumsolar_normal);
}

}  // namespace

std::vector<double> SunIrradiance::global_horizontal() const {
  const double cosine = std::max(0.0, std::cos(sun.zenith_deg * kRadiansPerDegree));
  std::vector<double> global = diffuse_horizontal;
  for (std::size_t i = 0; i < global.size(); ++i) global[i] += cosine * direct_normal[i];
  return global;
}

SunIrradiance simulate_sun(const Context& context, const SkyScene& scene, const SunIrradianceOptions& options,
                           const TransferOptions& transfer) {
  check(scene, options);
  const Atmosphere air(context, scene.profile, scene.air);
  const double aod500 = to_aod500(scene.turbidities[0], air);
  const SolarSpectrum spectrum = SolarSpectrum::load(context, scene.solar);
  SunIrradiance result;
  result.wavelengths = scene.wavelengths;
  result.sun = scene.suns[0];
  result.luminous_weight = luminous_weights(context, scene.wavelengths);
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i)
    result.extraterrestrial.push_back(
        spectrum.irradiance_W_m2_nm(scene.wavelengths[i], scene.wavelengths.step_nm()) /
        (scene.sun_distance_au * scene.sun_distance_au));
  add_direct_beam(air, scene, aod500, result);
  TransferOptions on_threads = transfer;
  on_threads.threads = context.threads;
  if (options.diffuse || options.circumsolar_half_angle_deg > 0.0)
    add_sky(air, scene, aod500, options, on_threads, result);
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
