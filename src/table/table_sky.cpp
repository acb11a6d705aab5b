#include "skylut/table/table_sky.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "skylut/colour/cie1931.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/core/quadrature.hpp"
#include "skylut/fit/dome_directions.hpp"
#include "skylut/sky/exact_sky.hpp"
#include "skylut/sky/solved_sky.hpp"
#include "skylut/sky/view_set.hpp"

namespace skylut {

namespace {

/// Suns from which everything looks the same: one zenith angle, and the fits' directions at the same places
/// relative to the sun.
struct SunGroup {
  double zenith_deg;
  std::vector<RelativeView> fitted;  // none: a dome's
  std::vector<std::size_t> suns;     // of the scene
};

std::vector<SunGroup> sun_groups(const std::vector<Direction>& suns,
                                 const std::vector<Direction>& directions) {
  std::vector<SunGroup> groups;
  for (std::size_t sun = 0; sun < suns.size(); ++sun) {
    std::vector<RelativeView> fitted;
    for (const Direction& direction : directions) fitted.push_back(relative_view(direction, suns[sun]));
    std::sort(fitted.begin(), fitted.end());
    auto group = std::find_if(groups.begin(), groups.end(), [&](const SunGroup& known) {
      return known.zenith_deg == suns[sun].zenith_deg && known.fitted == fitted;
    });
    if (group == groups.end()) group = groups.insert(group, {suns[sun].zenith_deg, std::move(fitted), {}});
    group->suns.push_back(sun);
  }
  return groups;
}

/// One sky, with the sun in the north: azimuths are those from the sun.
class Observer {
 public:
  Observer(const TableSampling& sampling, const SkyLight& sky) : sampling_(sampling), sky_(sky) {
    seen_.geometric_horizon_deg = sky.horizon_zenith_deg();
    if (sampling.to_horizon) seen_.dome_ends_deg = sky.horizon_zenith_deg();
  }

  TableSky look(const SunGroup& group) {
    seen_.sun = sky_.sun();
    if (sampling_.directions.empty())
      seen_.fitted = sampled(dome_directions(seen_.sun, seen_.dome_ends_deg));
    else
      seen_.fitted = {group.fitted, colours(group.fitted), {}};
    seen_.check = sampled(dome_check_directions(seen_.sun, seen_.dome_ends_deg));
    add_light_below();
    return seen_;
  }

 private:
  std::vector<Yxy> colours(const std::vector<RelativeView>& views) const {
    std::vector<Direction> directions;
    for (const RelativeView& view : views) directions.push_back({view.zenith_deg, view.relative_azimuth_deg});
    std::vector<Xyz> found(views.size());
    sky_.colour(directions, found);
    std::vector<Yxy> colours;
    for (const Xyz& colour : found) colours.push_back(to_yxy(colour));
    return colours;
  }

  SampledSky sampled(const DomeDirections& dome) const {
    SampledSky sky;
    for (const Direction& direction : dome.directions)
      sky.views.push_back(relative_view(direction, sky_.sun()));
    sky.colour = colours(sky.views);
    sky.solid_angles_sr = dome.solid_angles_sr;
    return sky;
  }

  // Below 90° by Gauss's rule in the zenith angle and even steps in azimuth; above as the check has it.
  void add_light_below() {
    constexpr int kZeniths = 8;
    constexpr double kAzimuthStep_deg = 15.0;
    if (seen_.geometric_horizon_deg <= 90.0) return;
    const Quadrature rule = gauss_legendre(kZeniths, 90.0, seen_.geometric_horizon_deg);
    std::vector<RelativeView> views;
    std::vector<double> weights;
    for (std::size_t i = 0; i < rule.node.size(); ++i)
      for (double azimuth = 0.5 * kAzimuthStep_deg; azimuth < 180.0; azimuth += kAzimuthStep_deg) {
        views.push_back({rule.node[i], azimuth});
        weights.push_back(rule.weight[i] * std::sin(rule.node[i] * kRadiansPerDegree));
      }
    const std::vector<Yxy> found = colours(views);
    double sum = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      sum += weights[i] * found[i].Y;
      all += weights[i];
    }
    seen_.Y_below_cd_m2 = sum / all;
    const double below =
        seen_.Y_below_cd_m2 * 2.0 * kPi * -std::cos(seen_.geometric_horizon_deg * kRadiansPerDegree);
    const double above = light_above();
    seen_.light_below = below / (above + below);
  }

  double light_above() const {
    const SampledSky sky = sampling_.to_horizon ? sampled(dome_check_directions(seen_.sun)) : seen_.check;
    double light = 0.0;
    for (std::size_t i = 0; i < sky.views.size(); ++i) light += sky.solid_angles_sr[i] * sky.colour[i].Y;
    return light;
  }

  const TableSampling& sampling_;
  const SkyLight& sky_;
  TableSky seen_;
};

SkyMap map_of(const SkyScene& scene, const SolvedSky& solved, const SkyLight& sky,
              const std::vector<Direction>& directions) {
  SkyMap map;
  map.sun = sky.sun();
  map.directions = directions;
  map.wavelengths = scene.wavelengths;
  map.instruction_set = solved.report().kernel;
  map.radiance.resize(directions.size() * scene.wavelengths.size());
  sky.radiance(directions, map.radiance);
  for (std::size_t i = 0; i < directions.size(); ++i)
    map.colour.push_back(to_yxy(weighted_sum<float>(solved.colour_weights(), map.spectrum(i))));
  return map;
}

void check(const SkyScene& scene) {
  if (scene.altitudes_km.empty() || scene.turbidities.empty() || scene.suns.empty())
    throw InputError("table of skies: needs at least one altitude, turbidity and sun");
}

}  // namespace

TableSkies simulate_table_skies(const Context& context, const SkyScene& scene, const TransferOptions& options,
                                const TableSampling& sampling) {
  check(scene);
  const std::vector<SunGroup> groups = sun_groups(scene.suns, sampling.directions);
  const std::size_t suns = scene.suns.size();
  const std::size_t turbidities = scene.turbidities.size();
  TableSkies table;
  table.skies.resize(scene.altitudes_km.size() * turbidities * suns);
  if (!sampling.map_directions.empty()) table.maps.resize(table.skies.size());
  for (std::size_t turbidity = 0; turbidity < turbidities; ++turbidity) {
    SkyScene of_turbidity = scene;
    of_turbidity.turbidities = {scene.turbidities[turbidity]};
    const auto solved = std::make_shared<const SolvedSky>(context, of_turbidity, options);
    table.instruction_set = solved->report().kernel;
    parallel_for(scene.altitudes_km.size() * groups.size(), context.threads, [&](std::size_t task) {
      if (context.cancel.stop_requested()) throw Cancelled();
      const std::size_t altitude = task / groups.size();
      const SunGroup& group = groups[task % groups.size()];
      const double altitude_km = scene.altitudes_km[altitude];
      const auto place = [&](std::size_t sun) { return (altitude * turbidities + turbidity) * suns + sun; };
      const ExactSky sky(solved, altitude_km, {group.zenith_deg, 0.0}, scene.sun_distance_au);
      TableSky seen = Observer(sampling, sky).look(group);
      seen.altitude_km = altitude_km;
      seen.turbidity = scene.turbidities[turbidity];
      for (const std::size_t sun : group.suns) {
        table.skies[place(sun)] = seen;
        table.skies[place(sun)].sun = scene.suns[sun];
        if (table.maps.empty()) continue;
        SkyMap& map = table.maps[place(sun)];
        map = map_of(scene, *solved, ExactSky(solved, altitude_km, scene.suns[sun], scene.sun_distance_au),
                     sampling.map_directions);
        map.altitude_km = altitude_km;
        map.turbidity = scene.turbidities[turbidity];
      }
    });
  }
  return table;
}

}  // namespace skylut
