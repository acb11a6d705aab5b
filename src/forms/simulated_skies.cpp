#include "skylut/forms/simulated_skies.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "skylut/core/context.hpp"
#include "skylut/sky/continuous_sky.hpp"

namespace skylut {

namespace {

std::vector<double> each_once(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

SkyAxes axes_of(const SkyScene& scene) {
  SkyAxes axes{.altitudes_km = each_once(scene.altitudes_km),
               .turbidity_kind = scene.turbidities.front().kind,
               .turbidities = {},
               .sun_zeniths_deg = {}};
  for (const Turbidity& turbidity : scene.turbidities) axes.turbidities.push_back(turbidity.value);
  for (const Direction& sun : scene.suns) axes.sun_zeniths_deg.push_back(sun.zenith_deg);
  axes.turbidities = each_once(std::move(axes.turbidities));
  axes.sun_zeniths_deg = each_once(std::move(axes.sun_zeniths_deg));
  return axes;
}

TrainingSky seen(const ContinuousSky& sky, const SoughtSky& request, DomeViews dome) {
  TrainingSky result{request, std::move(dome), {}, {}};
  const std::vector<Direction>& views = result.dome.views;
  result.radiance.resize(views.size() * sky.wavelengths().size());
  sky.radiance(views, result.radiance);
  std::vector<Xyz> colour(views.size());
  sky.colour(views, colour);
  for (const Xyz& one : colour) result.colours.push_back(to_yxy(one));
  return result;
}

}  // namespace

SimulatedSkies::SimulatedSkies(SkyScene scene, TransferOptions options, AirOverGround air_over_ground)
    : scene_(std::move(scene)),
      options_(options),
      air_over_ground_(std::move(air_over_ground)),
      axes_(axes_of(scene_)) {}

std::optional<double> SimulatedSkies::albedo() const {
  return scene_.atmosphere->options().ground_albedo.constant();
}

std::vector<TrainingSky> SimulatedSkies::given(const Context& context, const ViewsUnderSun& views) const {
  std::vector<SoughtSky> requests;
  for (const double altitude_km : axes_.altitudes_km)
    for (const double turbidity : axes_.turbidities)
      for (const double sun_deg : axes_.sun_zeniths_deg)
        requests.push_back({altitude_km, {axes_.turbidity_kind, turbidity}, std::nullopt, {sun_deg, 0.0}});
  return simulated(context, requests, views);
}

std::vector<TrainingSky> SimulatedSkies::simulated(const Context& context,
                                                   std::span<const SoughtSky> requests,
                                                   const ViewsUnderSun& views) const {
  // What is solved together: one ground and load.
  std::map<std::tuple<std::optional<double>, TurbidityKind, double>, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < requests.size(); ++i)
    groups[{requests[i].albedo, requests[i].turbidity.kind, requests[i].turbidity.value}].push_back(i);
  std::vector<TrainingSky> skies(requests.size());
  std::size_t done = 0;
  for (const auto& [load, members] : groups) {
    SkyScene scene = scene_;
    const auto& [albedo, kind, turbidity] = load;
    if (albedo) scene.atmosphere = air_over_ground_(*albedo);
    scene.turbidities = {{kind, turbidity}};
    std::vector<double> suns_deg;
    for (const std::size_t i : members) suns_deg.push_back(requests[i].sun.zenith_deg);
    scene.suns.clear();
    for (const double sun_deg : each_once(std::move(suns_deg))) scene.suns.push_back({sun_deg, 0.0});
    Context quiet = context;
    quiet.progress = {};
    const auto solved = std::make_shared<const SolvedSky>(quiet, scene, options_);
    for (const std::size_t i : members) {
      const SoughtSky& request = requests[i];
      skies[i] = seen(ContinuousSky(quiet, solved, request.altitude_km, request.sun, scene.sun_distance_au),
                      request, views(request.sun));
      if (context.progress) context.progress("simulating", ++done, requests.size());
    }
  }
  return skies;
}

}  // namespace skylut
