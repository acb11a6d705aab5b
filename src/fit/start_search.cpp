#include "start_search.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "grid_sums.hpp"
#include "skylut/core/check.hpp"
#include "zenith_offset.hpp"

namespace skylut::fit_detail {

namespace {

using Eigen::Index;

constexpr double kDecades = 0.1;    // between nodes in B, and in D
constexpr double kFlattest = 0.02;  // smallest |D|: e^{Dγ} is then as good as linear

// Values of one sign, geometric.
void append_geometric(std::vector<double>& nodes, double from, double to) {
  const int count = 2 + static_cast<int>(std::abs(std::log10(to / from)) / kDecades);
  for (int i = 0; i < count; ++i) nodes.push_back(from * std::pow(to / from, i / (count - 1.0)));
}

std::vector<double> rate_nodes(const FitOptions& options) {
  std::vector<double> nodes;
  append_geometric(nodes, options.B_lower, options.B_upper);
  return nodes;
}

std::vector<double> width_nodes(const FitOptions& options) {
  std::vector<double> nodes;
  if (options.D_lower < -kFlattest)
    append_geometric(nodes, options.D_lower, std::min(-kFlattest, options.D_upper));
  if (options.D_upper > kFlattest)
    append_geometric(nodes, std::max(kFlattest, options.D_lower), options.D_upper);
  SKYLUT_CHECK_LE(nodes.size(), static_cast<std::size_t>(kMostWidths));
  return nodes;
}

/// The nodes of one B: for every D the least cost over a, and where.
struct Row {
  OverWidths cost;
  OverWidths log_level;  // ln(1-a)
};

class RowScan {
 public:
  RowScan(const RateSums& sums, const std::vector<double>& widths, const SunFrame& sun,
          const FitOptions& options)
      : sums_(sums), least_offset_(1.0 / options.largest_scattering) {
    const auto count = static_cast<Index>(widths.size());
    k1_.resize(count);
    for (Index d = 0; d < count; ++d) k1_(d) = ZenithOffset(widths[static_cast<std::size_t>(d)], sun).k1;
    k2_ = sun.cos2_sun_zenith;
    lowest_ = -std::min(std::log(options.largest_gradation), 5.0);
  }

  // Over 1 - a from 1/148, or what the bound leaves, to 1100 by equal factors, then halfway to the
  // neighbours of the best, and a quarter.
  Row scan() const {
    constexpr int kNodes = 14;
    constexpr double kHighest = 7.0;
    const double step = (kHighest - lowest_) / (kNodes - 1);
    const Index count = k1_.size();
    Row best{OverWidths::Constant(count, std::numeric_limits<double>::infinity()), OverWidths::Zero(count)};
    for (int i = 0; i < kNodes; ++i) keep_better(best, OverWidths::Constant(count, lowest_ + step * i));
    for (const double share : {0.5, 0.25, 0.125}) {
      const OverWidths middle = best.log_level;
      keep_better(best, (middle - share * step).max(lowest_));
      keep_better(best, middle + share * step);
    }
    return best;
  }

 private:
  void keep_better(Row& best, const OverWidths& log_level) const {
    const OverWidths cost = least_cost(1.0 - log_level.exp());
    const auto better = (cost < best.cost).eval();
    best.log_level = better.select(log_level, best.log_level);
    best.cost = better.select(cost, best.cost);
  }

  // Least squares in c and e for fixed a: ½ |h g (1 + c W + e K) - t|².
  OverWidths least_cost(const OverWidths& a) const {
    const auto squared = [&a](const auto& sum) -> OverWidths {
      return sum[0] + a * (2.0 * sum[1] + a * sum[2]);
    };
    const auto linear = [&a](const auto& sum) -> OverWidths { return sum[0] + a * sum[1]; };
    const OverWidths WW = squared(sums_.WW);
    const OverWidths KK = squared(sums_.KK);
    const OverWidths WK = squared(sums_.WK);
    const OverWidths right_W = linear(sums_.t_W) - squared(sums_.W);
    const OverWidths right_K = linear(sums_.t_K) - squared(sums_.K);
    const OverWidths offset = squared(sums_.one) - 2.0 * linear(sums_.t_one) + sums_.t_t;
    const OverWidths determinant = WW * KK - WK * WK;
    // Nearly dependent columns (1e-10 of their product): e alone; the local search sorts it out.
    const auto independent = (determinant > 1e-10 * WW * KK).eval();
    const OverWidths inverse = independent.select(1.0 / determinant, 0.0);
    const OverWidths c = (KK * right_W - WK * right_K) * inverse;
    const OverWidths e =
        independent.select((WW * right_K - WK * right_W) * inverse, (KK > 0.0).select(right_K / KK, 0.0));
    OverWidths cost = offset - c * right_W - e * right_K;
    // What it costs to bring p up to its bound.
    const OverWidths lacking = (least_offset_ - 1.0 + c * k1_ + e * k2_).max(0.0);
    const OverWidths stiffness = (k1_.square() * KK - 2.0 * k2_ * k1_ * WK + k2_ * k2_ * WW) * inverse;
    if (least_offset_ > 0.0)
      cost += (lacking > 0.0 && stiffness > 0.0).select(lacking.square() / stiffness, 0.0);
    return 0.5 * cost;
  }

  const RateSums& sums_;
  double least_offset_;
  OverWidths k1_;
  double k2_;
  double lowest_;
};

}  // namespace

std::vector<Start> search_grid(const FitProblem& problem, const FitOptions& options) {
  const std::vector<double> rates = rate_nodes(options);
  const std::vector<double> widths = width_nodes(options);
  const GridSums sums(problem, rates, widths);
  const auto nB = static_cast<Index>(rates.size());
  const auto nD = static_cast<Index>(widths.size());
  std::vector<Row> grid;
  for (Index b = 0; b < nB; ++b) {
    const RateSums of_rate = sums.at(b);
    grid.push_back(RowScan(of_rate, widths, problem.sun, options).scan());
  }

  struct Node {
    double cost;
    Start at;
  };
  std::vector<Node> minima;
  const auto cost = [&grid](Index b, Index d) { return grid[static_cast<std::size_t>(b)].cost(d); };
  for (Index b = 0; b < nB; ++b)
    for (Index d = 0; d < nD; ++d) {
      // Lowest among the four next nodes; a diagonal valley then offers several starts along its floor.
      const double here = cost(b, d);
      if ((b == 0 || cost(b - 1, d) >= here) && (b == nB - 1 || cost(b + 1, d) >= here) &&
          (d == 0 || cost(b, d - 1) >= here) && (d == nD - 1 || cost(b, d + 1) >= here))
        minima.push_back({here,
                          {-std::expm1(grid[static_cast<std::size_t>(b)].log_level(d)),
                           rates[static_cast<std::size_t>(b)], widths[static_cast<std::size_t>(d)]}});
    }
  std::stable_sort(minima.begin(), minima.end(),
                   [](const Node& one, const Node& other) { return one.cost < other.cost; });
  const auto count = static_cast<std::size_t>(options.starts);
  if (minima.size() > count) minima.resize(count);
  std::vector<Start> starts;
  for (Node& node : minima) starts.push_back(std::move(node.at));
  return starts;
}

}  // namespace skylut::fit_detail
