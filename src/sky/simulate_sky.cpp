#include "skylut/sky/simulate_sky.hpp"

#include "band_columns.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/sky/view_set.hpp"

namespace skylut {

namespace {

void check(const SkyScene& scene) {
  SKYLUT_CHECK(scene.atmosphere != nullptr);
  for (const double altitude_km : scene.altitudes_km)
    require_within("altitude", altitude_km, domain::kObserver_km);
  for (const Direction& sun : scene.suns)
    require_within("sun zenith angle", sun.zenith_deg, domain::kSunZenith_deg);
  for (const Direction& direction : scene.directions)
    require_within("view zenith angle", direction.zenith_deg, domain::kAnyZenith_deg);
  if (scene.altitudes_km.empty() || scene.turbidities.empty() || scene.suns.empty() ||
      scene.directions.empty())
    throw InputError("sky scene: needs at least one altitude, turbidity, sun and direction");
}

// The colour of each direction from the radiances that the map holds.
void add_colours(SkyMap& map, const std::vector<Xyz>& weights) {
  for (std::size_t direction = 0; direction < map.directions.size(); ++direction)
    map.colour.push_back(to_yxy(weighted_sum<float>(weights, map.spectrum(direction))));
}

}  // namespace

std::vector<SkyMap> simulate_sky(const Context& context, const SkyScene& scene,
                                 const TransferOptions& options) {
  check(scene);

  // 1. The atmosphere becomes optical depths: columns for every turbidity and wavelength, more than one
  // where lines absorb.
  const std::vector<double> irradiance = extraterrestrial_irradiance(context, scene);
  const BandColumns bands(scene);

  // 2. Radiative transfer, once for everything: sr⁻¹ per unit solar irradiance.
  const ViewSet views(scene.directions, scene.suns);
  const SkyRadiance sky = solve_sky_radiance(context, scene.atmosphere->shells(), bands.columns,
                                             views.sights(scene.altitudes_km), options);

  // 3. The sun's spectrum makes it radiance, the eye's makes it colour.
  const std::vector<Xyz> weights = ColourMatching::load(context).weights(scene.wavelengths);
  const std::size_t turbidities = scene.turbidities.size();
  const std::size_t suns = scene.suns.size();
  const std::size_t wavelengths = scene.wavelengths.size();
  std::vector<SkyMap> maps(scene.altitudes_km.size() * turbidities * suns);
  parallel_for(maps.size(), context.threads, [&](std::size_t index) {
    const std::size_t sun = index % suns;
    const std::size_t turbidity = index / suns % turbidities;
    const std::size_t observer = index / (suns * turbidities);
    SkyMap& map = maps[index];
    map.altitude_km = scene.altitudes_km[observer];
    map.turbidity = scene.turbidities[turbidity];
    map.sun = scene.suns[sun];
    map.directions = scene.directions;
    map.wavelengths = scene.wavelengths;
    map.instruction_set = sky.report().kernel;
    map.radiance.reserve(map.directions.size() * wavelengths);
    for (std::size_t direction = 0; direction < map.directions.size(); ++direction)
      for (std::size_t i = 0; i < wavelengths; ++i) {
        const std::size_t band = bands.band(turbidity, i);
        double radiance = 0.0;
        for (std::size_t column = bands.first[band]; column < bands.first[band + 1]; ++column)
          radiance +=
              bands.weights[column] *
              static_cast<double>(sky.at(column, observer * views.size() + views.index(direction, sun)));
        map.radiance.push_back(static_cast<float>(irradiance[i] * radiance));
      }
    add_colours(map, weights);
  });
  return maps;
}

}  // namespace skylut
