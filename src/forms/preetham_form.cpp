#include <algorithm>
#include <cmath>

#include "form_list.hpp"
#include "formula_fit.hpp"
#include "preetham_zenith.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/forms/model_error.hpp"
#include "skylut/models/preetham1999.hpp"
#include "skylut/models/preetham_model.hpp"

namespace skylut {

namespace {

using nlohmann::ordered_json;

// Preetham et al. 1999 §4: twelve suns, turbidities 2 to 6, 343 directions. They do not say which suns; these
// crowd where the zenith changes fastest and end where their Y_z, which no longer falls, parts from any sky.
constexpr std::array kSuns_deg{0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 65.0, 70.0, 75.0, 80.0, 85.0};
constexpr std::array kTurbidities{2.0, 3.0, 4.0, 5.0, 6.0};

DomeViews preetham_views(const Direction&) {
  DomeViews dome{directions_preetham343(), {}};
  dome.solid_angle.assign(dome.views.size(), 2.0 * kPi / static_cast<double>(dome.views.size()));
  return dome;
}

// The five coefficients of one channel, linear in T. The fit's axis is T from the lowest to the highest,
// along which a curve of degree 1 is a straight line between its two points.
PreethamMatrices::Perez fitted_perez(std::span<const TrainingSky> skies, double Yxy::*channel,
                                     bool relative) {
  constexpr double kFirst = kTurbidities.front();
  constexpr double kSpan = kTurbidities.back() - kTurbidities.front();
  std::vector<forms_detail::FormulaSample> samples;
  for (const TrainingSky& sky : skies) {
    const double zenith = sky.colours.front().*channel;
    for (std::size_t i = 0; i < sky.colours.size(); ++i) {
      const Direction& view = sky.dome.views[i];
      const double gamma_rad = angle_between(view, sky.conditions.sun);
      const double value = sky.colours[i].*channel;
      samples.push_back({.view = {std::cos(view.zenith_deg * kRadiansPerDegree), gamma_rad,
                                  std::cos(gamma_rad), sky.conditions.sun.zenith_deg * kRadiansPerDegree},
                         .along = (sky.conditions.turbidity.value - kFirst) / kSpan,
                         .scale = zenith,
                         .target = value,
                         .weight = relative ? 1.0 / value : 1.0});
    }
  }
  const forms_detail::FormulaCurves fitted =
      forms_detail::fit_formula(forms_detail::PerezRatio(), samples, 1);
  PreethamMatrices::Perez linear;
  for (std::size_t i = 0; i < linear.size(); ++i) {
    linear[i].slope = (fitted.points[2 * i + 1] - fitted.points[2 * i]) / kSpan;
    linear[i].offset = fitted.points[2 * i] - linear[i].slope * kFirst;
  }
  return linear;
}

PreethamMatrices fitted_matrices(const Context& context, std::span<const TrainingSky> skies) {
  PreethamMatrices matrices;
  parallel_for(3, context.threads, [&](std::size_t channel) {
    if (channel == 0) matrices.Y = fitted_perez(skies, &Yxy::Y, true);
    if (channel == 1) matrices.x = fitted_perez(skies, &Yxy::x, false);
    if (channel == 2) matrices.y = fitted_perez(skies, &Yxy::y, false);
  });
  std::vector<forms_detail::ZenithSample> zeniths;
  for (const TrainingSky& sky : skies) {
    const Yxy& top = sky.colours.front();
    zeniths.push_back({sky.conditions.turbidity.value,
                       sky.conditions.sun.zenith_deg * kRadiansPerDegree,
                       {1e-3 * top.Y, top.x, top.y}});
  }
  forms_detail::fit_zenith(zeniths, matrices);
  return matrices;
}

double rounded(double value) { return std::stod(fmt::format("{:.4g}", value)); }

// Root mean square over skies of the same turbidity or sun.
ordered_json mean_error(std::span<const SkyError> errors,
                        const std::function<bool(const SoughtSky&)>& counts) {
  double n = 0.0;
  SkyError sum;
  for (const SkyError& error : errors) {
    if (!counts(error.conditions)) continue;
    n += 1.0;
    sum.rms_Y_rel += error.rms_Y_rel * error.rms_Y_rel;
    sum.mean_Y_rel += error.mean_Y_rel;
    sum.rms_x += error.rms_x * error.rms_x;
    sum.rms_y += error.rms_y * error.rms_y;
  }
  return {{"rms_Y_rel", rounded(std::sqrt(sum.rms_Y_rel / n))},
          {"mean_Y_rel", rounded(sum.mean_Y_rel / n)},
          {"rms_x", rounded(std::sqrt(sum.rms_x / n))},
          {"rms_y", rounded(std::sqrt(sum.rms_y / n))}};
}

/// Both models against the skies of the fit, by turbidity and by sun: "how wrong is Preetham?"
ordered_json beside_published(const SkyModel& regenerated, std::span<const TrainingSky> skies) {
  const std::vector<SkyError> ours = sky_errors(regenerated, skies);
  const std::vector<SkyError> theirs = sky_errors(Preetham1999(), skies);
  const auto both = [&](const std::function<bool(const SoughtSky&)>& counts) {
    return ordered_json{{"regenerated", mean_error(ours, counts)}, {"published", mean_error(theirs, counts)}};
  };
  ordered_json json{{"by_turbidity", ordered_json::array()}, {"by_sun", ordered_json::array()}};
  for (const double T : kTurbidities) {
    ordered_json one{{"turbidity", T}};
    one.update(both([T](const SoughtSky& sky) { return sky.turbidity.value == T; }));
    json["by_turbidity"].push_back(std::move(one));
  }
  for (const double sun_deg : kSuns_deg) {
    ordered_json one{{"sun_zenith_deg", sun_deg}};
    one.update(both([sun_deg](const SoughtSky& sky) { return sky.sun.zenith_deg == sun_deg; }));
    json["by_sun"].push_back(std::move(one));
  }
  return json;
}

ModelInfo info_of(const SkyAxes& axes) {
  ModelInfo info;
  info.title = "Preetham, Shirley and Smits's form (1999) fitted to skylut's skies";
  info.quantities = "Y, x, y";
  info.altitude_km = {axes.altitudes_km.front(), axes.altitudes_km.back(), "km"};
  info.turbidity_kind = TurbidityKind::preetham_t;
  info.turbidity = {kTurbidities.front(), kTurbidities.back(), ""};
  info.sun_zenith_deg = {kSuns_deg.front(), kSuns_deg.back(), "deg"};
  info.view_zenith_deg = {0.0, 90.0, "deg"};
  return info;
}

}  // namespace

ModelFile PreethamForm::fit(const Context& context, const SkySupply& supply, const FormOptions&) const {
  std::vector<SoughtSky> requests;
  for (const double altitude_km : supply.axes().altitudes_km)
    for (const double T : kTurbidities)
      for (const double sun_deg : kSuns_deg)
        requests.push_back({altitude_km, {TurbidityKind::preetham_t, T}, std::nullopt, {sun_deg, 0.0}});
  const std::vector<TrainingSky> skies = supply.simulated(context, requests, preetham_views);
  constexpr std::size_t kPerLevel = kTurbidities.size() * kSuns_deg.size();
  std::vector<PreethamLevel> levels;
  for (const double altitude_km : supply.axes().altitudes_km)
    levels.push_back({altitude_km, fitted_matrices(context, std::span(skies).subspan(
                                                                levels.size() * kPerLevel, kPerLevel))});
  ModelFile file{.form = name(),
                 .info = info_of(supply.axes()),
                 .error = ordered_json::object(),
                 .model = PreethamModel::json(levels)};
  // Theirs is for observers on the ground.
  if (levels.front().altitude_km == 0.0)
    file.error["beside_published"] = beside_published(*make_model(file), std::span(skies).first(kPerLevel));
  return file;
}

}  // namespace skylut
