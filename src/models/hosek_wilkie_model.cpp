#include "skylut/models/hosek_wilkie_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "skylut/core/check.hpp"
#include "skylut/core/interpolation.hpp"
#include "skylut/models/bernstein.hpp"
#include "skylut/models/model_conditions.hpp"

namespace skylut {

namespace {

using nlohmann::ordered_json;

using Basis = std::array<double, HosekWilkieCurves::kDegree + 1>;

double on_curve(const HosekWilkieCurves::Curve& points, const Basis& basis) {
  double sum = 0.0;
  for (std::size_t j = 0; j < points.size(); ++j) sum += basis[j] * points[j];
  return sum;
}

/// The formula of one channel at one node of turbidity and albedo, for one sun.
struct Term {
  double scale;  // weight of the node times the expected radiance
  HosekWilkieCoefficients coefficients;
};

Term term_of(const HosekWilkieCurves& curves, const Basis& basis, double weight) {
  Term term{weight * on_curve(curves.mean, basis), {}};
  for (std::size_t i = 0; i < term.coefficients.size(); ++i)
    term.coefficients[i] = on_curve(curves.coefficients[i], basis);
  return term;
}

class HosekWilkieSky final : public ChannelSky {
 public:
  /// @param terms  [node][channel]
  HosekWilkieSky(std::shared_ptr<const ModelFrame> frame, const Direction& sun, std::vector<Term> terms)
      : ChannelSky(std::move(frame), sun), terms_(std::move(terms)) {}

  void values(const Direction& view, std::span<double> values) const override {
    const double cos_zenith = std::cos(view.zenith_deg * kRadiansPerDegree);
    const double gamma_rad = angle_between(view, sun());
    const double cos_gamma = std::cos(gamma_rad);
    std::fill(values.begin(), values.end(), 0.0);
    for (std::size_t i = 0; i < terms_.size(); ++i)
      values[i % values.size()] +=
          terms_[i].scale * hosek_wilkie(terms_[i].coefficients, cos_zenith, gamma_rad, cos_gamma);
  }

 private:
  std::vector<Term> terms_;
};

std::array<std::pair<std::size_t, double>, 2> neighbours(const std::vector<double>& nodes, double value) {
  const Bracket bracket = held_bracket(nodes, value);
  return {{{bracket.below, 1.0 - bracket.part}, {bracket.above, bracket.part}}};
}

// Nine digits are more than any fit knows, and keep the file small.
double short_number(double value) { return std::strtod(fmt::format("{:.8e}", value).c_str(), nullptr); }

ordered_json curve_json(const HosekWilkieCurves::Curve& curve) {
  ordered_json json = ordered_json::array();
  for (const double point : curve) json.push_back(short_number(point));
  return json;
}

HosekWilkieCurves::Curve read_curve(const JsonReader& json) {
  const std::vector<JsonReader> points = json.elements();
  HosekWilkieCurves::Curve curve{};
  if (points.size() != curve.size()) json.refuse("must hold 6 control points");
  for (std::size_t j = 0; j < curve.size(); ++j) curve[j] = points[j].number();
  return curve;
}

std::vector<double> read_axis(const JsonReader& json) {
  std::vector<double> nodes;
  for (const JsonReader& node : json.elements()) {
    nodes.push_back(node.number());
    if (nodes.size() > 1 && !(nodes.back() > nodes[nodes.size() - 2]))
      node.refuse("must be above the node before");
  }
  return nodes;
}

}  // namespace

HosekWilkieModel::HosekWilkieModel(ModelInfo info, HosekWilkieGrid grid)
    : frame_(std::make_shared<const ModelFrame>(ModelFrame{std::move(info), grid.channels})),
      grid_(std::move(grid)) {
  SKYLUT_CHECK_EQ(grid_.curves.size(), grid_.index(grid_.altitudes_km.size(), 0, 0));
}

std::unique_ptr<const Sky> HosekWilkieModel::at(const SkyConditions& conditions) const {
  require_within_domain(info(), conditions);
  Basis basis{};
  bernstein_basis(hosek_wilkie_curve_parameter(conditions.sun.zenith_deg), basis);
  std::vector<BlendedSky::Part> parts;
  for (const auto& [altitude, by_altitude] : neighbours(grid_.altitudes_km, conditions.altitude_km)) {
    if (by_altitude == 0.0) continue;
    std::vector<Term> terms;
    for (const auto& [turbidity, by_turbidity] : neighbours(grid_.turbidities, conditions.turbidity.value))
      for (const auto& [albedo, by_albedo] : neighbours(grid_.albedos, conditions.albedo)) {
        if (by_turbidity * by_albedo == 0.0) continue;
        for (std::size_t channel = 0; channel < grid_.channels.size(); ++channel)
          terms.push_back(term_of(grid_.curves[grid_.index(altitude, turbidity, albedo, channel)], basis,
                                  by_turbidity * by_albedo));
      }
    parts.push_back(
        {by_altitude, std::make_unique<const HosekWilkieSky>(frame_, conditions.sun, std::move(terms))});
  }
  return std::make_unique<const BlendedSky>(frame_, conditions.sun, std::move(parts));
}

ordered_json HosekWilkieModel::json(const HosekWilkieGrid& grid) {
  ordered_json curves = ordered_json::array();
  for (const HosekWilkieCurves& one : grid.curves) {
    ordered_json json;
    for (std::size_t i = 0; i < one.coefficients.size(); ++i)
      json[kHosekWilkieNames[i]] = curve_json(one.coefficients[i]);
    json["L_M"] = curve_json(one.mean);
    curves.push_back(std::move(json));
  }
  return {{"channels", grid.channels.json()},
          {"altitudes_km", grid.altitudes_km},
          {"turbidities", grid.turbidities},
          {"albedos", grid.albedos},
          {"curves", std::move(curves)}};
}

std::unique_ptr<const SkyModel> HosekWilkieModel::read(const ModelInfo& info, const JsonReader& model) {
  HosekWilkieGrid grid{.altitudes_km = read_axis(model.at("altitudes_km")),
                       .turbidities = read_axis(model.at("turbidities")),
                       .albedos = read_axis(model.at("albedos")),
                       .channels = SkyChannels::read(model.at("channels")),
                       .curves = {}};
  const std::vector<JsonReader> curves = model.at("curves").elements();
  if (curves.size() != grid.index(grid.altitudes_km.size(), 0, 0))
    model.at("curves").refuse("must be one per altitude, turbidity, albedo and channel");
  for (const JsonReader& curve : curves) {
    HosekWilkieCurves& read = grid.curves.emplace_back();
    for (std::size_t i = 0; i < read.coefficients.size(); ++i)
      read.coefficients[i] = read_curve(curve.at(kHosekWilkieNames[i]));
    for (const double g : read.coefficients[7])
      if (!(std::abs(g) < 1.0)) curve.at("H").refuse("must lie within -1 to 1");
    read.mean = read_curve(curve.at("L_M"));
  }
  return std::make_unique<const HosekWilkieModel>(info, std::move(grid));
}

}  // namespace skylut
