#include "skylut/sky/simulate_sky.hpp"

#include "skylut/atmosphere/solar_spectrum.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/sky/view_set.hpp"

namespace skylut {

namespace {

constexpr double kHighestObserver_km = 30.0;
constexpr double kLowestSunZenith_deg = 96.0;

void require_within(const char* what, double value, double lowest, double highest, const char* unit) {
  if (!(value >= lowest && value <= highest))
    throw InputError("{} {} {}: must lie within {} to {} {}", what, value, unit, lowest, highest, unit);
}

void check(const SkyScene& scene) {
  for (const double altitude_km : scene.altitudes_km)
    require_within("altitude", altitude_km, 0.0, kHighestObserver_km, "km");
  for (const Direction& sun : scene.suns)
    require_within("sun zenith angle", sun.zenith_deg, 0.0, kLowestSunZenith_deg, "deg");
  for (const Direction& direction : scene.directions)
    require_within("view zenith angle", direction.zenith_deg, 0.0, 180.0, "deg");
  if (scene.altitudes_km.empty() || scene.turbidities.empty() || scene.suns.empty() ||
      scene.directions.empty())
    throw InputError("sky scene: needs at least one altitude, turbidity, sun and direction");
}

// The solver's lanes: of the first turbidity every wavelength with all its terms, then of the next.
struct Lanes {
  std::vector<OpticalColumn> columns;
  std::vector<double> weights;     // of each column
  std::vector<std::size_t> first;  // column of each turbidity and wavelength, and the end
};

Lanes lanes_of(const Atmosphere& air, const SkyScene& scene) {
  Lanes lanes;
  for (const Turbidity& turbidity : scene.turbidities) {
    const double aod500 = to_aod500(turbidity, air);
    for (std::size_t i = 0; i < scene.wavelengths.size(); ++i) {
      lanes.first.push_back(lanes.columns.size());
      for (ColumnTerm& term : air.band_columns(scene.wavelengths[i], scene.wavelengths.step_nm(), aod500)) {
        lanes.columns.push_back(std::move(term.column));
        lanes.weights.push_back(term.weight);
      }
    }
  }
  lanes.first.push_back(lanes.columns.size());
  return lanes;
}

// W m⁻² nm⁻¹ on a plane normal to the beam at the top of the atmosphere, per wavelength.
std::vector<double> solar_irradiance(const Context& context, const SkyScene& scene) {
  const SolarSpectrum sun = SolarSpectrum::load(context, scene.solar);
  std::vector<double> irradiance;
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i)
    irradiance.push_back(sun.irradiance_W_m2_nm(scene.wavelengths[i], scene.wavelengths.step_nm()) /
                         (scene.sun_distance_au * scene.sun_distance_au));
  return irradiance;
}

// The colour of each direction from the radiances that the map holds.
void add_colours(SkyMap& map, const std::vector<Xyz>& weights) {
  for (std::size_t direction = 0; direction < map.directions.size(); ++direction) {
    const std::span<const float> spectrum = map.spectrum(direction);
    Xyz sum;
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
      const double radiance = spectrum[i];
      sum.X += weights[i].X * radiance;
      sum.Y += weights[i].Y * radiance;
      sum.Z += weights[i].Z * radiance;
    }
    map.colour.push_back(to_yxy(sum));
  }
}

}  // namespace

std::vector<SkyMap> simulate_sky(const Context& context, const SkyScene& scene,
                                 const TransferOptions& options) {
  check(scene);

  // 1. The atmosphere becomes optical depths: columns for every turbidity and wavelength, more than one
  // where lines absorb.
  const Atmosphere air(context, scene.profile, scene.air);
  const Lanes lanes = lanes_of(air, scene);

  const std::vector<double> irradiance = solar_irradiance(context, scene);  // refuses what it cannot do early

  // 2. Radiative transfer, once for everything: sr⁻¹ per unit solar irradiance.
  const ViewSet views(scene.directions, scene.suns);
  const SkyRequest request{scene.altitudes_km, views.unique_sun_zeniths_deg(), views.unique_views()};
  TransferOptions transfer = options;
  transfer.threads = context.threads;
  const SkyRadiance sky = solve_sky_radiance(air.shells(), lanes.columns, request, transfer);

  // 3. The sun's spectrum makes it radiance, the eye's makes it colour.
  const std::vector<Xyz> weights = ColourMatching::load(context).weights(scene.wavelengths);
  const std::size_t loads = scene.turbidities.size();
  const std::size_t suns = scene.suns.size();
  const std::size_t wavelengths = scene.wavelengths.size();
  std::vector<SkyMap> maps(scene.altitudes_km.size() * loads * suns);
  parallel_for(maps.size(), context.threads, [&](std::size_t index) {
    const std::size_t sun = index % suns;
    const std::size_t load = index / suns % loads;
    const std::size_t observer = index / (suns * loads);
    SkyMap& map = maps[index];
    map.altitude_km = scene.altitudes_km[observer];
    map.turbidity = scene.turbidities[load];
    map.sun = scene.suns[sun];
    map.directions = scene.directions;
    map.wavelengths = scene.wavelengths;
    map.radiance.reserve(map.directions.size() * wavelengths);
    for (std::size_t direction = 0; direction < map.directions.size(); ++direction)
      for (std::size_t i = 0; i < wavelengths; ++i) {
        const std::size_t band = load * wavelengths + i;
        double radiance = 0.0;
        for (std::size_t lane = lanes.first[band]; lane < lanes.first[band + 1]; ++lane)
          radiance += lanes.weights[lane] *
                      sky.at(lane, observer, views.sun_index(sun), views.view_index(direction, sun));
        map.radiance.push_back(static_cast<float>(irradiance[i] * radiance));
      }
    add_colours(map, weights);
  });
  return maps;
}

}  // namespace skylut
