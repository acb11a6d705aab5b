#include "skylut/table/table_sky.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/fit/dome_directions.hpp"
#include "skylut/sky/dome_sky.hpp"
#include "skylut/sky/simulate_sky.hpp"
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

/// Skies that are held at a time, about a megabyte each.
constexpr std::size_t kSunsAtOnce = 32;

bool by_lines(const TableSampling& sampling) { return sampling.exact || !sampling.directions.empty(); }

/// One sky, with the sun in the north: azimuths are those from the sun.
class Observer {
 public:
  Observer(const TableSampling& sampling, const DomeSky& sky)
      : sampling_(sampling),
        sky_(sky),
        light_(by_lines(sampling) ? static_cast<const SkyLight&>(sky.exact()) : sky) {
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
    light_.colour(directions, found);
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

  void add_light_below() {
    if (seen_.geometric_horizon_deg <= 90.0) return;
    seen_.Y_below_cd_m2 = sky_.luminance_below();
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
  const DomeSky& sky_;
  const SkyLight& light_;  // the same, or its lines of sight
  TableSky seen_;
};

std::vector<TableSky> seen_under(const Context& context, const std::shared_ptr<const SolvedSky>& solved,
                                 const TableSampling& sampling, double altitude_km, double sun_distance_au,
                                 std::span<const SunGroup> groups) {
  std::vector<double> zeniths_deg;
  for (const SunGroup& group : groups) zeniths_deg.push_back(group.zenith_deg);
  const std::vector<DomeSky> skies =
      DomeSky::under_suns(context, solved, altitude_km, zeniths_deg, sun_distance_au);
  std::vector<TableSky> seen(groups.size());
  parallel_for(groups.size(), context.threads, [&](std::size_t i) {
    if (context.cancel.stop_requested()) throw Cancelled();
    seen[i] = Observer(sampling, skies[i]).look(groups[i]);
    seen[i].altitude_km = altitude_km;
  });
  return seen;
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
  if (!sampling.map_directions.empty()) {  // the very maps of skylut map, to the last bit
    SkyScene of_maps = scene;
    of_maps.directions = sampling.map_directions;
    table.maps = simulate_sky(context, of_maps, options);
  }
  // Domes are seen under all suns at once, which one band has. Without bands a sky is nearer to the truth by
  // up to 0.1 %.
  TransferOptions of_domes = options;
  if (!by_lines(sampling)) of_domes.discretisation.sun_bands = false;
  for (std::size_t turbidity = 0; turbidity < turbidities; ++turbidity) {
    SkyScene of_turbidity = scene;
    of_turbidity.turbidities = {scene.turbidities[turbidity]};
    const auto solved = std::make_shared<const SolvedSky>(context, of_turbidity, of_domes);
    table.instruction_set = solved->report().kernel;
    for (std::size_t altitude = 0; altitude < scene.altitudes_km.size(); ++altitude)
      for (std::size_t first = 0; first < groups.size(); first += kSunsAtOnce) {
        const std::span<const SunGroup> these =
            std::span(groups).subspan(first, std::min(kSunsAtOnce, groups.size() - first));
        const std::vector<TableSky> seen =
            seen_under(context, solved, sampling, scene.altitudes_km[altitude], scene.sun_distance_au, these);
        for (std::size_t i = 0; i < these.size(); ++i)
          for (const std::size_t sun : these[i].suns) {
            TableSky& sky = table.skies[(altitude * turbidities + turbidity) * suns + sun];
            sky = seen[i];
            sky.turbidity = scene.turbidities[turbidity];
            sky.sun = scene.suns[sun];
          }
      }
  }
  return table;
}

}  // namespace skylut
