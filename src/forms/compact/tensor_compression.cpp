#include "tensor_compression.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>

#include "skylut/core/check.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/models/compact/coordinates.hpp"

namespace skylut::compact {

namespace {

using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Share of the squared tolerance that the four axes may leave out, each a quarter of it, and rounding.
constexpr double kAxesShare = 0.3;
constexpr double kRoundingShare = 0.3;
/// Columns of the first sketch; doubled where they do not suffice.
constexpr Eigen::Index kFirstSketch = 256;
/// Views onto the ground count less than the sky.
constexpr double kGroundWeight = 0.5;

/// What an error of each number does to a sky's light. [number of the layout]
std::vector<float> number_weights(const Layout& layout) {
  std::vector<float> weights(layout.size(), 0.0f);
  const auto set = [&](std::size_t field, double weight) {
    for (std::size_t m = 0; m < layout.orders(field); ++m)
      weights[layout.at(m, field)] = static_cast<float>(weight);
  };
  set(layout.brightness(), 1.0);
  // Bands are told from Y by their ratios alone; many of them must not drown it.
  const double each = std::sqrt(3.0 / static_cast<double>(layout.channels()));
  for (std::size_t c = 0; c < layout.channels(); ++c) {
    if (c != Layout::kY) set(layout.ratio(Layout::other(c)), 1.2 * each);
    set(layout.molecules(c), 0.35 * each);
    set(layout.haze(c), 0.35 * each);
    for (std::size_t k = 1; k < layout.terms(); ++k) set(layout.term(k, c), 0.2 * each);
    set(layout.ground(c), 0.2 * each);
  }
  return weights;
}

/// Deep in twilight skies are dim, and change more than anywhere else: they may err more. [sun]
std::vector<float> sun_weights(std::span<const double> suns_deg) {
  std::vector<float> weights;
  for (const double sun_deg : suns_deg)
    weights.push_back(static_cast<float>(std::clamp(1.0 - 0.17 * (sun_deg - 90.0), 0.25, 1.0)));
  return weights;
}

/// A tensor of five axes: load, altitude, sun, zenith, number.
struct Tensor {
  std::array<std::size_t, 5> size;
  std::vector<float> values;

  std::size_t before(std::size_t axis) const {
    std::size_t product = 1;
    for (std::size_t i = 0; i < axis; ++i) product *= size[i];
    return product;
  }
  std::size_t after(std::size_t axis) const { return values.size() / (before(axis) * size[axis]); }
};

/// Replaces an axis by as few functions as leave out no more than a sum of squares. The rows of the basis are
/// the axis's nodes.
Matrix reduce(Tensor& tensor, std::size_t axis, double may_leave) {
  const auto n = static_cast<Eigen::Index>(tensor.size[axis]);
  const std::size_t before = tensor.before(axis);
  const auto after = static_cast<Eigen::Index>(tensor.after(axis));
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(n, n);
  const auto slab = [&](std::vector<float>& values, std::size_t b, Eigen::Index rows) {
    return Eigen::Map<Matrix>(values.data() + static_cast<std::ptrdiff_t>(b) * rows * after, rows, after);
  };
  for (std::size_t b = 0; b < before; ++b) {
    const auto block = slab(tensor.values, b, n);
    gram += (block * block.transpose()).cast<double>();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  Eigen::Index kept = n;
  for (double left = 0.0; kept > 1; --kept) {
    left += std::max(eigen.eigenvalues()(n - kept), 0.0);
    if (left > may_leave) break;
  }
  Matrix basis = eigen.eigenvectors().rightCols(kept).rowwise().reverse().cast<float>();
  std::vector<float> reduced(before * static_cast<std::size_t>(kept * after));
  for (std::size_t b = 0; b < before; ++b)
    slab(reduced, b, kept).noalias() = basis.transpose() * slab(tensor.values, b, n);
  tensor.values = std::move(reduced);
  tensor.size[axis] = static_cast<std::size_t>(kept);
  return basis;
}

/// From values at nodes to spline coefficients.
Eigen::MatrixXd prefilter(const CubicSpline& spline, std::span<const double> nodes) {
  const auto n = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const SplineTaps taps = spline.taps(nodes[static_cast<std::size_t>(i)]);
    for (std::size_t k = 0; k < 4; ++k)
      values(i, static_cast<Eigen::Index>(taps.first + k)) += taps.weight[k];
  }
  return values.inverse();
}

/// Prefilters that stand on the diagonal one after another.
Eigen::MatrixXd on_diagonal(std::span<const Eigen::MatrixXd> blocks) {
  Eigen::Index size = 0;
  for (const Eigen::MatrixXd& block : blocks) size += block.rows();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& block : blocks) {
    all.block(at, at, block.rows(), block.cols()) = block;
    at += block.rows();
  }
  return all;
}

Eigen::MatrixXd prefilter_whole_numbers(std::size_t count) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < count; ++i) nodes.push_back(static_cast<double>(i));
  return prefilter(CubicSpline(nodes), nodes);
}

template <class Coordinate>
Eigen::MatrixXd prefilter_of(std::span<const double> nodes, const Coordinate& coordinate) {
  std::vector<double> mapped;
  for (const double node : nodes) mapped.push_back(coordinate(node));
  return prefilter(CubicSpline(mapped), mapped);
}

Basis as_basis(const Matrix& values) {
  return {static_cast<std::size_t>(values.rows()),
          static_cast<std::size_t>(values.cols()),
          {values.data(), values.data() + values.size()}};
}

Basis filtered(const Eigen::MatrixXd& filter, const Matrix& basis) {
  return as_basis((filter * basis.cast<double>()).cast<float>());
}

/// The two cores, conditions by rank and rank by features.
struct Cores {
  Matrix conditions;  // (condition function, rank)
  Matrix features;    // (rank, feature function)
};

/// Shares each rank out evenly, so that both cores are rounded alike.
Cores balanced(Cores cores) {
  for (Eigen::Index r = 0; r < cores.conditions.cols(); ++r) {
    const float of_conditions = cores.conditions.col(r).cwiseAbs().maxCoeff();
    const float of_features = cores.features.row(r).cwiseAbs().maxCoeff();
    const float balance = std::sqrt(of_features / std::max(of_conditions, 1e-30f));
    cores.conditions.col(r) *= balance;
    cores.features.row(r) /= balance;
  }
  return cores;
}

/// An orthonormal basis of what a matrix maps to, near enough for its largest singular values: a random
/// sketch, sharpened by one power iteration. [Halko, Martinsson, Tropp 2011, doi:10.1137/090771806,
/// algorithm 4.4]
Matrix sketched_range(const Eigen::Map<const Matrix>& whole, Eigen::Index columns) {
  std::mt19937_64 random(20050101);
  Matrix signs(whole.cols(), columns);
  for (Eigen::Index i = 0; i < signs.size(); ++i) signs.data()[i] = (random() & 1U) != 0 ? 1.0f : -1.0f;
  const auto orthonormal = [columns](const Matrix& of) -> Matrix {
    const Eigen::HouseholderQR<Matrix> qr(of);
    return qr.householderQ() * Matrix::Identity(of.rows(), columns);
  };
  const Matrix once = orthonormal(whole * signs);
  return orthonormal(whole * orthonormal(whole.transpose() * once));
}

Cores split(const Tensor& core, double may_leave) {
  const auto conditions = static_cast<Eigen::Index>(core.size[0] * core.size[1] * core.size[2]);
  const auto features = static_cast<Eigen::Index>(core.size[3] * core.size[4]);
  const Eigen::Map<const Matrix> whole(core.values.data(), conditions, features);
  const double all = whole.cast<double>().squaredNorm();
  const Eigen::Index most = std::min(conditions, features);
  for (Eigen::Index columns = std::min(kFirstSketch, most);; columns = std::min(2 * columns, most)) {
    const Matrix range = sketched_range(whole, columns);
    const Matrix within = range.transpose() * whole;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        Matrix(within * within.transpose()).cast<double>());
    // The largest last.
    Eigen::Index rank = 0;
    double left = all;
    while (rank < columns && left > may_leave) left -= eigen.eigenvalues()(columns - ++rank);
    if (left > may_leave && columns < most) continue;
    const Matrix vectors = eigen.eigenvectors().rightCols(rank).rowwise().reverse().cast<float>();
    return balanced({range * vectors, vectors.transpose() * within});
  }
}

/// The step that leaves a mean square error of the product's entries, if both factors are rounded to it:
/// every entry of one meets the mean squares of the other.
double rounding_step(const Cores& cores, double may_leave) {
  const double entries =
      static_cast<double>(cores.conditions.rows()) * static_cast<double>(cores.features.cols());
  const double squares =
      static_cast<double>(cores.conditions.squaredNorm()) / static_cast<double>(cores.conditions.rows()) +
      static_cast<double>(cores.features.squaredNorm()) / static_cast<double>(cores.features.cols());
  return std::sqrt(12.0 * may_leave / (entries * squares));
}

}  // namespace

void compress(const TrainingFields& fields, double tolerance, Tables& tables) {
  const Eigen::Map<const Eigen::VectorXf> all(fields.features.data(),
                                              static_cast<Eigen::Index>(fields.features.size()));
  if (!all.allFinite()) throw WorkError("features of compact skies: must be numbers; some are not");
  const Layout layout = tables.layout();
  const std::size_t numbers = layout.size();
  const std::size_t zenith_nodes = fields.zenith.size();
  Tensor tensor{{fields.nodes.aod500.size(), fields.nodes.altitudes_km.size(), fields.nodes.suns_deg.size(),
                 zenith_nodes, numbers},
                fields.features};
  const std::size_t each = zenith_nodes * numbers;
  const std::size_t conditions = tensor.values.size() / each;
  const std::vector<float> of_number = number_weights(layout);
  std::vector<float> weight;
  for (std::size_t node = 0; node < zenith_nodes; ++node) {
    const bool ground = node >= tables.zenith_counts.above + tables.zenith_counts.limb;
    for (const float one : of_number)
      weight.push_back(one * static_cast<float>(ground ? kGroundWeight : 1.0));
  }
  Matrix mean(static_cast<Eigen::Index>(zenith_nodes), static_cast<Eigen::Index>(numbers));
  const Eigen::Map<Matrix> flat(tensor.values.data(), static_cast<Eigen::Index>(conditions),
                                static_cast<Eigen::Index>(each));
  Eigen::Map<Eigen::RowVectorXf>(mean.data(), mean.size()) =
      flat.cast<double>().colwise().mean().cast<float>();
  const std::vector<float> of_sun = sun_weights(fields.nodes.suns_deg);
  for (std::size_t condition = 0; condition < conditions; ++condition)
    for (std::size_t i = 0; i < each; ++i) {
      float& value = tensor.values[condition * each + i];
      value = (value - mean.data()[i]) * weight[i] * of_sun[condition % of_sun.size()];
    }

  const double may_leave =
      tolerance * tolerance * static_cast<double>(conditions) * static_cast<double>(zenith_nodes);
  const double per_axis = may_leave * kAxesShare / 4.0;
  const Matrix zenith = reduce(tensor, 3, per_axis);
  const Matrix load = reduce(tensor, 0, per_axis);
  const Matrix altitude = reduce(tensor, 1, per_axis);
  Matrix sun = reduce(tensor, 2, per_axis);
  for (std::size_t i = 0; i < of_sun.size(); ++i) sun.row(static_cast<Eigen::Index>(i)) /= of_sun[i];
  Cores cores = split(tensor, may_leave * (1.0 - kAxesShare - kRoundingShare));
  tables.step = rounding_step(cores, may_leave * kRoundingShare);

  tables.rank = static_cast<std::size_t>(cores.conditions.cols());
  const Matrix by_rank = cores.conditions.transpose();
  tables.condition_core.assign(by_rank.data(), by_rank.data() + by_rank.size());
  tables.feature_core.assign(cores.features.data(), cores.features.data() + cores.features.size());
  for (std::size_t i = 0; i < tables.feature_core.size(); ++i)
    tables.feature_core[i] /= std::max(of_number[i % numbers], 1e-30f);

  const double least = fields.nodes.aod500[1];
  const std::array load_blocks{Eigen::MatrixXd(Eigen::MatrixXd::Identity(1, 1)),
                               prefilter_of(std::span(fields.nodes.aod500).subspan(1),
                                            [&](double aod) { return load_coordinate(aod, least); })};
  const auto& counts = tables.zenith_counts;
  const std::array zenith_blocks{prefilter_whole_numbers(counts.above), prefilter_whole_numbers(counts.limb),
                                 prefilter_whole_numbers(counts.ground)};
  const Eigen::MatrixXd zenith_filter = on_diagonal(zenith_blocks);
  Matrix unweighted = zenith;
  for (std::size_t node = counts.above + counts.limb; node < zenith_nodes; ++node)
    unweighted.row(static_cast<Eigen::Index>(node)) /= static_cast<float>(kGroundWeight);
  tables.load = filtered(on_diagonal(load_blocks), load);
  tables.altitude = filtered(prefilter_of(fields.nodes.altitudes_km, altitude_coordinate), altitude);
  tables.sun = filtered(prefilter_of(fields.nodes.suns_deg, [](double sun_deg) { return sun_deg; }), sun);
  tables.zenith = filtered(zenith_filter, unweighted);
  const Matrix filtered_mean = (zenith_filter * mean.cast<double>()).cast<float>();
  tables.mean.assign(filtered_mean.data(), filtered_mean.data() + filtered_mean.size());
}

}  // namespace skylut::compact
