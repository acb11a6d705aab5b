#include "horizon_peak.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "skylut/core/legendre.hpp"

namespace skylut::transfer {

namespace {

/// Degrees that are summed: details of 0.7°, and four times as many change no radiance by more than 0.05 %.
/// For light from more than 30° above or below the horizon fewer do: only the kernel's tail reaches there.
constexpr int kDegrees = 129;
constexpr int kFarDegrees = 65;
constexpr double kFarCosine = 0.5;

/// C is kept at nodes within 12° of the horizon. It acts whole within 3° of it and fades out to 8°; whole up
/// to 2 km and fades out to 3 km: higher up the air below has filled in the horizon's jump.
constexpr double kKeptCosine = 0.2;
constexpr double kWholeCosine = 0.05;
constexpr double kNoneCosine = 0.14;
constexpr double kWhole_km = 2.0;
constexpr double kNone_km = 3.0;
/// The lowest levels of the sweep from these heights on are kept. In √h, with which the horizon's dip grows,
/// C is smooth between them.
constexpr double kLevels_km[kMostHorizonLevels] = {0.0, 0.02, 0.12, 0.4, 1.1, kNone_km};

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

/// ½ ∫ f d|μ| over the radiance's cubic interpolation among the polar nodes in t = √|μ| as a sum over points,
/// by Gauss-Legendre in t between neighbouring nodes, with points enough for the degrees.
struct NodeQuadrature {
  /// Points between two nodes: they share the four nodes that interpolate.
  struct Interval {
    int first_node;
    std::size_t end;  ///< one past its last point
    bool far;         ///< from the horizon
  };
  std::vector<Interval> interval;
  std::vector<double> cosine;                 ///< [point]
  std::vector<std::array<double, 4>> weight;  ///< [point]: of the four nodes

  explicit NodeQuadrature(const AngularGrid& angles) {
    const std::vector<double> root = roots(angles, angles.polar_nodes());
    const CubicInterpolation among_nodes(root);
    double lower = 0.0;
    for (std::size_t j = 0; j <= root.size(); ++j) {
      const double upper = j < root.size() ? root[j] : 1.0;
      const bool far = lower * lower > kFarCosine;
      const double phase =
          (std::asin(upper * upper) - std::asin(lower * lower)) * (far ? kFarDegrees : kDegrees);
      const Quadrature rule = gauss_legendre(4 + static_cast<int>(0.6 * phase), lower, upper);
      const int first = among_nodes(0.5 * (lower + upper)).first;
      for (std::size_t i = 0; i < rule.node.size(); ++i) {
        cosine.push_back(rule.node[i] * rule.node[i]);
        const InterpolationWeights nodes = among_nodes(rule.node[i]);
        std::array<double, 4>& to = weight.emplace_back();
        for (std::size_t t = 0; t < 4; ++t)
          to[t] = static_cast<double>(nodes.weight[t]) * rule.node[i] * rule.weight[i];  // ½ dμ = t dt
      }
      interval.push_back({first, cosine.size(), far});
      lower = upper;
    }
  }
};

/// Λ_lm at many points for one m and l = m, m + 1, …: the recurrence M2, degree by degree.
class LegendreByDegree {
 public:
  LegendreByDegree(int m, std::span<const double> mu) : m_(m), l_(m), mu_(mu) {
    for (const double x : mu_) current_.push_back(normalised_legendre(m, m, x).front());
    previous_.resize(mu_.size());
  }
  const std::vector<double>& values() const { return current_; }
  /// Goes on at the first `points`.
  void next(std::size_t points) {
    ++l_;
    const double scale = 1.0 / std::sqrt(static_cast<double>(l_ * l_ - m_ * m_));
    const double before = std::sqrt(static_cast<double>((l_ - 1) * (l_ - 1) - m_ * m_)) * scale;
    const double here = (2.0 * l_ - 1.0) * scale;
    for (std::size_t i = 0; i < points; ++i)
      previous_[i] = here * mu_[i] * current_[i] - before * previous_[i];
    current_.swap(previous_);
  }

 private:
  int m_;
  int l_;
  std::span<const double> mu_;
  std::vector<double> current_;
  std::vector<double> previous_;
};

}  // namespace

HorizonNodes::HorizonNodes(const AngularGrid& angles, const ShellGeometry& sublayers,
                           const std::vector<int>& layer_of_sublayer)
    : count_(nodes_near_horizon(angles)), among_nodes_(roots(angles, count_)) {
  const std::vector<double>& levels_km = sublayers.levels_km();
  place_of_level_.resize(levels_km.size(), -1);
  for (const double wanted_km : kLevels_km) {
    const auto above = std::lower_bound(levels_km.begin(), levels_km.end() - 1, wanted_km);
    const auto level = static_cast<std::size_t>(above - levels_km.begin());
    if (place_of_level_[level] >= 0) continue;
    place_of_level_[level] = levels();
    altitude_km_.push_back(*above);
    layer_of_level_.push_back(layer_of_sublayer[std::min(level, layer_of_sublayer.size() - 1)]);
  }
}

HorizonWeights HorizonNodes::at(double mu, double altitude_km) const {
  const double cosine = std::abs(mu);
  if (cosine >= kNoneCosine || altitude_km >= kNone_km) return {};
  const double height_km = std::clamp(altitude_km, 0.0, altitude_km_.back());
  const auto above = std::upper_bound(altitude_km_.begin() + 1, altitude_km_.end() - 1, height_km);
  const double lower_root = std::sqrt(*(above - 1));
  HorizonWeights weights{
      .near = true,
      .hemisphere = mu > 0.0 ? kUp : kDown,
      .nodes = among_nodes_(std::sqrt(cosine)),
      .level = static_cast<int>(above - altitude_km_.begin()) - 1,
      .fraction = static_cast<float>((std::sqrt(height_km) - lower_root) / (std::sqrt(*above) - lower_root))};
  const double left = std::min(1.0, (kNoneCosine - cosine) / (kNoneCosine - kWholeCosine)) *
                      std::min(1.0, (kNone_km - altitude_km) / (kNone_km - kWhole_km));
  for (float& weight : weights.nodes.weight) weight *= static_cast<float>(left);
  return weights;
}

HorizonPeakTables::HorizonPeakTables(const AngularGrid& angles, const HorizonNodes& nodes) : nodes_(nodes) {
  const NodeQuadrature quadrature(angles);
  const std::span<const double> cos_nodes(angles.cos_polar().data(), static_cast<std::size_t>(nodes.count()));
  std::size_t near_intervals = 0;
  while (!quadrature.interval[near_intervals].far) ++near_intervals;
  std::vector<double> analysed(static_cast<std::size_t>(angles.polar_nodes()));
  for (int m = 0; m < angles.azimuthal_orders(); ++m) {
    LegendreByDegree at_points(m, quadrature.cosine);
    LegendreByDegree at_nodes(m, cos_nodes);
    for (int l = m; l < kDegrees; ++l) {
      for (const double value : at_nodes.values())
        synthesis_.push_back(static_cast<float>((2.0 * l + 1.0) * value));
      std::fill(analysed.begin(), analysed.end(), 0.0);
      const std::size_t intervals = l < kFarDegrees ? quadrature.interval.size() : near_intervals;
      std::size_t point = 0;
      for (std::size_t i = 0; i < intervals; ++i) {
        double sum[4] = {};
        for (; point < quadrature.interval[i].end; ++point)
          for (std::size_t t = 0; t < 4; ++t)
            sum[t] += quadrature.weight[point][t] * at_points.values()[point];
        double* const to = analysed.data() + quadrature.interval[i].first_node;
        for (std::size_t t = 0; t < 4; ++t) to[t] += sum[t];
      }
      for (const double value : analysed)
        analysis_.push_back(static_cast<float>(value / angles.azimuth_nodes()));
      at_points.next(point);
      at_nodes.next(cos_nodes.size());
    }
  }
}

HorizonView HorizonPeakTables::view() const {
  return {.nodes = nodes_.count(),
          .degrees = kDegrees,
          .synthesis = synthesis_.data(),
          .analysis = analysis_.data(),
          .levels = nodes_.levels(),
          .place_of_level = nodes_.place_of_level().data(),
          .layer_of_level = nodes_.layer_of_level().data()};
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
