#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "channel_samples.hpp"
#include "form_list.hpp"
#include "formula_fit.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/models/bernstein.hpp"
#include "skylut/models/hosek_wilkie_model.hpp"

namespace skylut {

namespace {

using forms_detail::band_channels;
using forms_detail::channel_values;
using forms_detail::fit_formula;
using forms_detail::FormulaCurves;
using forms_detail::FormulaSample;
using forms_detail::HosekWilkieFormula;
using Curves = HosekWilkieCurves;

// The suns of the fit, dense where the sky changes fastest.
constexpr std::array kSuns_deg{90.0, 89.5, 89.0, 88.0, 87.0, 85.5, 84.0, 82.0, 79.5, 76.0,
                               72.0, 66.0, 60.0, 52.0, 44.0, 34.0, 24.0, 14.0, 6.0,  0.0};

/// Skies of one altitude, turbidity and albedo under all suns, and their values.
struct Training {
  std::span<const TrainingSky> skies;
  std::vector<std::vector<double>> values;  ///< [sun], as channel_values
};

double mean_of(const TrainingSky& sky, const std::vector<double>& values, std::size_t channels,
               std::size_t channel) {
  double sum = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < sky.dome.views.size(); ++i) {
    sum += sky.dome.solid_angle[i] * values[i * channels + channel];
    all += sky.dome.solid_angle[i];
  }
  return sum / all;
}

// The expected radiance: its curve by least squares of the relative differences.
Curves::Curve mean_curve(const Training& training, std::size_t channels, std::size_t channel) {
  constexpr Eigen::Index kPoints = Curves::kDegree + 1;
  const auto suns = static_cast<Eigen::Index>(training.skies.size());
  Eigen::MatrixXd matrix(suns, kPoints);
  for (Eigen::Index sun = 0; sun < suns; ++sun) {
    const TrainingSky& sky = training.skies[static_cast<std::size_t>(sun)];
    Curves::Curve basis{};
    bernstein_basis(hosek_wilkie_curve_parameter(sky.conditions.sun.zenith_deg), basis);
    const double mean = mean_of(sky, training.values[static_cast<std::size_t>(sun)], channels, channel);
    for (Eigen::Index j = 0; j < kPoints; ++j) matrix(sun, j) = basis[static_cast<std::size_t>(j)] / mean;
  }
  const Eigen::VectorXd points = matrix.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(suns));
  Curves::Curve curve{};
  for (std::size_t j = 0; j < curve.size(); ++j) curve[j] = points[static_cast<Eigen::Index>(j)];
  return curve;
}

std::vector<FormulaSample> samples_of(const Training& training, std::size_t channels, std::size_t channel,
                                      const Curves::Curve& mean) {
  std::vector<FormulaSample> samples;
  for (std::size_t sun = 0; sun < training.skies.size(); ++sun) {
    const TrainingSky& sky = training.skies[sun];
    const double along = hosek_wilkie_curve_parameter(sky.conditions.sun.zenith_deg);
    Curves::Curve basis{};
    bernstein_basis(along, basis);
    double scale = 0.0;
    for (std::size_t j = 0; j < basis.size(); ++j) scale += basis[j] * mean[j];
    for (std::size_t i = 0; i < sky.dome.views.size(); ++i) {
      const Direction& view = sky.dome.views[i];
      const double gamma_rad = angle_between(view, sky.conditions.sun);
      const double value = training.values[sun][i * channels + channel];
      samples.push_back({.view = {std::cos(view.zenith_deg * kRadiansPerDegree), gamma_rad,
                                  std::cos(gamma_rad), sky.conditions.sun.zenith_deg * kRadiansPerDegree},
                         .along = along,
                         .scale = scale,
                         .target = value,
                         .weight = std::sqrt(sky.dome.solid_angle[i]) / value});
    }
  }
  return samples;
}

// All channels of one node, the middle one first and the others from their neighbours' curves.
void fit_node(const Training& training, std::span<Curves> curves) {
  const std::size_t middle = curves.size() / 2;
  std::vector<FormulaCurves> fitted(curves.size());
  const auto fit = [&](std::size_t channel, const FormulaCurves* near) {
    Curves& result = curves[channel];
    result.mean = mean_curve(training, curves.size(), channel);
    fitted[channel] =
        fit_formula(HosekWilkieFormula(), samples_of(training, curves.size(), channel, result.mean),
                    Curves::kDegree, near);
    for (std::size_t i = 0; i < result.coefficients.size(); ++i)
      std::copy_n(fitted[channel].points.begin() + static_cast<std::ptrdiff_t>(i * result.mean.size()),
                  result.mean.size(), result.coefficients[i].begin());
  };
  fit(middle, nullptr);
  for (std::size_t channel = middle; channel-- > 0;) fit(channel, &fitted[channel + 1]);
  for (std::size_t channel = middle + 1; channel < curves.size(); ++channel)
    fit(channel, &fitted[channel - 1]);
}

std::vector<SoughtSky> requests_of(const SkyAxes& axes, const std::vector<double>& albedos) {
  std::vector<SoughtSky> requests;
  for (const double altitude_km : axes.altitudes_km)
    for (const double turbidity : axes.turbidities)
      for (const double albedo : albedos)
        for (const double sun_deg : kSuns_deg)
          requests.push_back({altitude_km, {axes.turbidity_kind, turbidity}, albedo, {sun_deg, 0.0}});
  return requests;
}

ModelInfo info_of(const HosekWilkieGrid& grid, TurbidityKind kind) {
  ModelInfo info;
  info.title = "Hosek and Wilkie's formula (2012) fitted to skylut's skies";
  info.quantities = grid.channels.quantities();
  info.altitude_km = {grid.altitudes_km.front(), grid.altitudes_km.back(), "km"};
  info.turbidity_kind = kind;
  info.turbidity = {grid.turbidities.front(), grid.turbidities.back(), ""};
  info.albedo = {grid.albedos.front(), grid.albedos.back(), ""};
  info.sun_zenith_deg = {0.0, 90.0, "deg"};
  info.view_zenith_deg = {0.0, 90.0, "deg"};
  return info;
}

}  // namespace

ModelFile HosekWilkieForm::fit(const Context& context, const SkySupply& supply,
                               const FormOptions& options) const {
  const SkyAxes& axes = supply.axes();
  const std::vector<TrainingSky> skies =
      supply.simulated(context, requests_of(axes, options.albedos), fitting_views);
  HosekWilkieGrid grid{.altitudes_km = axes.altitudes_km,
                       .turbidities = axes.turbidities,
                       .albedos = options.albedos,
                       .channels = {.kind = SkyChannels::Kind::Xyz},
                       .curves = {}};
  if (options.spectral) grid.channels = band_channels(context, supply, options.bands, skies);
  std::vector<Training> training;
  for (std::size_t first = 0; first < skies.size(); first += kSuns_deg.size()) {
    Training& node = training.emplace_back();
    node.skies = std::span(skies).subspan(first, kSuns_deg.size());
    for (const TrainingSky& sky : node.skies)
      node.values.push_back(channel_values(sky, grid.channels, supply.wavelengths()));
  }
  const std::size_t channels = grid.channels.size();
  grid.curves.resize(training.size() * channels);
  parallel_for(training.size(), context.threads, [&](std::size_t node) {
    fit_node(training[node], std::span(grid.curves).subspan(node * channels, channels));
  });
  return {.form = name(),
          .info = info_of(grid, axes.turbidity_kind),
          .error = {},
          .model = HosekWilkieModel::json(grid)};
}

}  // namespace skylut
