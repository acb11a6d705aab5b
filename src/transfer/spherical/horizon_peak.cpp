#include "horizon_peak.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/legendre.hpp"

namespace skylut::transfer {

namespace {

/// Degrees that are summed: details of 0.35°, beyond which less than a twentieth of a peak is left.
constexpr int kDegrees = 257;

/// C is kept at nodes within 17° of the horizon, applied within 4° and faded out to 12°.
constexpr double kKeptCosine = 0.3;
constexpr double kWholeCosine = 0.07;
constexpr double kNoneCosine = 0.2;

std::vector<double> roots(const AngularGrid& angles, int count) {
  std::vector<double> root;
  for (int j = 0; j < count; ++j) root.push_back(std::sqrt(angles.cos_polar()[static_cast<std::size_t>(j)]));
  return root;
}

int nodes_near_horizon(const AngularGrid& angles) {
  const auto& cosine = angles.cos_polar();
  const auto beyond = std::upper_bound(cosine.begin(), cosine.end(), kKeptCosine);
  return std::max(4, static_cast<int>(beyond - cosine.begin()));
}

/// A point of the quadrature over |μ| in [0, 1] with the interpolation that gives the radiance there.
struct QuadraturePoint {
  double cosine;
  InterpolationWeights nodes;  // times ½ dμ
};

/// Gauss-Legendre in √|μ| between neighbouring nodes, with as many points as resolve kDegrees.
std::vector<QuadraturePoint> quadrature_between_nodes(const AngularGrid& angles) {
  const std::vector<double> root = roots(angles, angles.polar_nodes());
  const CubicInterpolation among_nodes(root);
  std::vector<QuadraturePoint> points;
  double lower = 0.0;
  for (std::size_t j = 0; j <= root.size(); ++j) {
    const double upper = j < root.size() ? root[j] : 1.0;
    const double angle = std::asin(upper * upper) - std::asin(lower * lower);
    const Quadrature rule = gauss_legendre(6 + static_cast<int>(0.6 * kDegrees * angle), lower, upper);
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      QuadraturePoint point{rule.node[i] * rule.node[i], among_nodes(rule.node[i])};
      for (float& weight : point.nodes.weight)
        weight *= static_cast<float>(rule.node[i] * rule.weight[i]);  // ½ dμ = t dt
      points.push_back(point);
    }
    lower = upper;
  }
  return points;
}

/// Λ_lm at many points for one m and l = m, m + 1, …: the recurrence M2, degree by degree.
class LegendreByDegree {
 public:
  LegendreByDegree(int m, std::vector<double> mu) : m_(m), l_(m), mu_(std::move(mu)) {
    for (const double x : mu_) current_.push_back(normalised_legendre(m, m, x).front());
    previous_.resize(mu_.size());
  }
  const std::vector<double>& values() const { return current_; }
  void next() {
    ++l_;
    const double below = std::sqrt(static_cast<double>((l_ - 1) * (l_ - 1) - m_ * m_));
    const double scale = 1.0 / std::sqrt(static_cast<double>(l_ * l_ - m_ * m_));
    for (std::size_t i = 0; i < mu_.size(); ++i)
      previous_[i] = scale * ((2.0 * l_ - 1.0) * mu_[i] * current_[i] - below * previous_[i]);
    current_.swap(previous_);
  }

 private:
  int m_;
  int l_;
  std::vector<double> mu_;
  std::vector<double> current_;
  std::vector<double> previous_;
};

}  // namespace

HorizonNodes::HorizonNodes(const AngularGrid& angles)
    : count_(nodes_near_horizon(angles)), among_nodes_(roots(angles, count_)) {}

HorizonWeights HorizonNodes::at(double mu) const {
  const double cosine = std::abs(mu);
  if (cosine >= kNoneCosine) return {};
  HorizonWeights weights{mu > 0.0 ? kUp : kDown, true, among_nodes_(std::sqrt(cosine))};
  const double left = std::min(1.0, (kNoneCosine - cosine) / (kNoneCosine - kWholeCosine));
  for (float& weight : weights.nodes.weight) weight *= static_cast<float>(left);
  return weights;
}

HorizonPeakTables::HorizonPeakTables(const AngularGrid& angles, int nodes) : nodes_(nodes) {
  const std::vector<QuadraturePoint> points = quadrature_between_nodes(angles);
  std::vector<double> at_points;
  for (const QuadraturePoint& point : points) at_points.push_back(point.cosine);
  const std::vector<double> at_nodes(angles.cos_polar().begin(), angles.cos_polar().begin() + nodes);
  std::vector<double> analysed(static_cast<std::size_t>(angles.polar_nodes()));
  for (int m = 0; m < angles.azimuthal_orders(); ++m) {
    LegendreByDegree points_lambda(m, at_points);
    LegendreByDegree nodes_lambda(m, at_nodes);
    for (int l = m; l < kDegrees; ++l) {
      for (const double value : nodes_lambda.values())
        synthesis_.push_back(static_cast<float>((2.0 * l + 1.0) * value));
      std::fill(analysed.begin(), analysed.end(), 0.0);
      for (std::size_t i = 0; i < points.size(); ++i) {
        double* to = analysed.data() + points[i].nodes.first;
        for (int t = 0; t < 4; ++t)
          to[t] += static_cast<double>(points[i].nodes.weight[t]) * points_lambda.values()[i];
      }
      for (const double value : analysed)
        analysis_.push_back(static_cast<float>(value / angles.azimuth_nodes()));
      points_lambda.next();
      nodes_lambda.next();
    }
  }
}

HorizonView HorizonPeakTables::view() const {
  return {.nodes = nodes_, .degrees = kDegrees, .synthesis = synthesis_.data(), .analysis = analysis_.data()};
}

HorizonPeaks::HorizonPeaks(std::span<const OpticalColumn> columns, int max_l) {
  const std::size_t lanes = columns.size();
  std::vector<std::vector<const Scatterer*>> peaked(lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    for (const Scatterer& scatterer : columns[lane].scatterers)
      if (scatterer.phase->moment(max_l + 1) > kLeastHorizonPeak) peaked[lane].push_back(&scatterer);
    peaks = std::max(peaks, static_cast<int>(peaked[lane].size()));
  }
  const auto count = static_cast<std::size_t>(peaks);
  const std::size_t layers = columns.front().extinction_depth.size();
  moment.resize(count * kDegrees * lanes);
  share.resize(layers * count * lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane)
    for (std::size_t peak = 0; peak < peaked[lane].size(); ++peak) {
      const PhaseFunction& phase = *peaked[lane][peak]->phase;
      const double whole = phase.moment(max_l + 1);
      for (int l = 0; l < kDegrees; ++l)
        moment[(peak * kDegrees + static_cast<std::size_t>(l)) * lanes + lane] =
            l <= max_l ? 1.0f : static_cast<float>(phase.moment(l) / whole);
      for (std::size_t layer = 0; layer < layers; ++layer) {
        double sum = 0.0;
        for (const Scatterer* other : peaked[lane])
          sum += other->phase->moment(max_l + 1) * other->scattering_depth[layer];
        const double own = whole * peaked[lane][peak]->scattering_depth[layer];
        share[(layer * count + peak) * lanes + lane] = sum > 0.0 ? static_cast<float>(own / sum) : 0.0f;
      }
    }
}

}  // namespace skylut::transfer
