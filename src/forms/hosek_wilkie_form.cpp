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
using forms_detail::better_of;
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
                         .weight = std::sqrt(fit_weight(sky.dome, i)) / value});
    }
  }
  return samples;
}

/// The curves of all channels of one node.
struct NodeFit {
  std::vector<Curves::Curve> mean;
  std::vector<FormulaCurves> formula;
};

// The middle channel first and the others from their neighbours' curves.
NodeFit fitted_node(const Training& training, std::size_t channels) {
  NodeFit node{{}, std::vector<FormulaCurves>(channels)};
  for (std::size_t channel = 0; channel < channels; ++channel)
    node.mean.push_back(mean_curve(training, channels, channel));
  const auto fit = [&](std::size_t channel, const FormulaCurves* near) {
    node.formula[channel] =
        fit_formula(HosekWilkieFormula(), samples_of(training, channels, channel, node.mean[channel]),
                    Curves::kDegree, near);
  };
  const std::size_t middle = channels / 2;
  fit(middle, nullptr);
  for (std::size_t channel = middle; channel-- > 0;) fit(channel, &node.formula[channel + 1]);
  for (std::size_t channel = middle + 1; channel < channels; ++channel)
    fit(channel, &node.formula[channel - 1]);
  return node;
}

// A node's channels again, from the curves that the neighbouring load's have: what was lost in a minor
// minimum comes out of it.
void refine(const Training& training, const NodeFit& neighbour, NodeFit& node) {
  for (std::size_t channel = 0; channel < node.formula.size(); ++channel)
    node.formula[channel] = better_of(HosekWilkieFormula(),
                                      samples_of(training, node.formula.size(), channel, node.mean[channel]),
                                      node.formula[channel], neighbour.formula[channel]);
}

Curves curves_of(const NodeFit& node, std::size_t channel) {
  Curves curves;
  curves.mean = node.mean[channel];
  for (std::size_t i = 0; i < curves.coefficients.size(); ++i)
    std::copy_n(node.formula[channel].points.begin() + static_cast<std::ptrdiff_t>(i * curves.mean.size()),
                curves.mean.size(), curves.coefficients[i].begin());
  return curves;
}

/// Every node alone, then beside its neighbours in turbidity as they were.
std::vector<NodeFit> fitted_nodes(const Context& context, std::span<const Training> training,
                                  const HosekWilkieGrid& grid) {
  const std::size_t channels = grid.channels.size();
  std::vector<NodeFit> alone(training.size());
  parallel_for(training.size(), context.threads,
               [&](std::size_t node) { alone[node] = fitted_node(training[node], channels); });
  std::vector<NodeFit> nodes = alone;
  const std::size_t stride = grid.albedos.size();
  parallel_for(training.size(), context.threads, [&](std::size_t node) {
    const std::size_t turbidity = node / stride % grid.turbidities.size();
    if (turbidity > 0) refine(training[node], alone[node - stride], nodes[node]);
    if (turbidity + 1 < grid.turbidities.size()) refine(training[node], alone[node + stride], nodes[node]);
  });
  return nodes;
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
  for (const NodeFit& node : fitted_nodes(context, training, grid))
    for (std::size_t channel = 0; channel < grid.channels.size(); ++channel)
      grid.curves.push_back(curves_of(node, channel));
  return {.form = name(),
          .info = info_of(grid, axes.turbidity_kind),
          .error = {},
          .model = HosekWilkieModel::json(grid)};
}

}  // namespace skylut
