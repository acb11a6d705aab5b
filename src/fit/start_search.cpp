#include "start_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "grid_sums.hpp"

namespace skylut::fit_detail {

namespace {

constexpr int kRates = 56;          // nodes in B: 0.13 decades apart over the default bounds
constexpr int kWidths = 48;         // nodes in D below 0
constexpr int kBrightenings = 32;   // nodes in D above 0
constexpr double kFlattest = 0.02;  // smallest |D|: e^{Dγ} is then as good as linear

// Values of -lower … -upper, geometric.
void append_geometric(std::vector<double>& nodes, double from, double to, int count) {
  for (int i = 0; i < count; ++i) nodes.push_back(from * std::pow(to / from, i / (count - 1.0)));
}

std::vector<double> rate_nodes(const FitOptions& options) {
  std::vector<double> nodes;
  append_geometric(nodes, options.B_lower, options.B_upper, kRates);
  return nodes;
}

std::vector<double> width_nodes(const FitOptions& options) {
  std::vector<double> nodes;
  if (options.D_lower < -kFlattest)
    append_geometric(nodes, options.D_lower, std::min(-kFlattest, options.D_upper), kWidths);
  if (options.D_upper > kFlattest)
    append_geometric(nodes, std::max(kFlattest, options.D_lower), options.D_upper, kBrightenings);
  return nodes;
}

// Values of a: the model at the horizon is 1 - a of what it is without gradation.
std::vector<double> gradation_nodes() {
  std::vector<double> nodes{0.0};
  for (const double a : {0.05, 0.1,  0.2,  0.3,   0.4,  0.5, 0.6, 0.7, 0.8,  0.87,
                         0.93, 0.97, 0.99, 0.997, 1.01, 1.1, 1.5, 3.0, 10.0, 100.0})
    nodes.push_back(a);
  for (const double a :
       {0.05, 0.1, 0.2, 0.35, 0.6, 1.0, 1.5, 2.5, 4.0, 7.0, 12.0, 20.0, 40.0, 100.0, 300.0, 1000.0})
    nodes.push_back(-a);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

struct Eliminated {
  double cost = std::numeric_limits<double>::infinity();
  double c = 0.0;
  double e = 0.0;
};

// Least squares in c and e for fixed a: ½ |h g (1 + c W + e K) - t|².
Eliminated eliminate(const NodeSums& s, double a) {
  const auto squared = [a](const double(&sum)[3]) { return sum[0] + a * (2.0 * sum[1] + a * sum[2]); };
  const auto linear = [a](const double(&sum)[2]) { return sum[0] + a * sum[1]; };
  const double WW = squared(s.WW);
  const double KK = squared(s.KK);
  const double WK = squared(s.WK);
  const double one = squared(s.one);
  const double right_W = linear(s.t_W) - squared(s.W);
  const double right_K = linear(s.t_K) - squared(s.K);
  const double offset = one - 2.0 * linear(s.t_one) + s.t_t;
  const double determinant = WW * KK - WK * WK;
  Eliminated result;
  // Nearly dependent columns (1e-10 of their product): e alone; the local search sorts it out.
  if (determinant > 1e-10 * WW * KK) {
    result.c = (KK * right_W - WK * right_K) / determinant;
    result.e = (WW * right_K - WK * right_W) / determinant;
  } else if (KK > 0.0) {
    result.e = right_K / KK;
  }
  result.cost = 0.5 * (offset - result.c * right_W - result.e * right_K);
  return result;
}

GridMinimum best_at(const NodeSums& sums, double B, double D, const std::vector<double>& gradations) {
  GridMinimum best{std::numeric_limits<double>::infinity(), {}};
  std::size_t at = 0;
  for (std::size_t i = 0; i < gradations.size(); ++i) {
    const Eliminated found = eliminate(sums, gradations[i]);
    if (found.cost < best.cost) {
      best = {found.cost, {gradations[i], B, found.c, D, found.e}};
      at = i;
    }
  }
  // Golden section between the neighbours of the best node; each step keeps one of its two points.
  constexpr double kGolden = 0.6180339887498949;
  double low = gradations[at == 0 ? 0 : at - 1];
  double high = gradations[std::min(at + 1, gradations.size() - 1)];
  const auto look_at = [&](double a) {
    const Eliminated found = eliminate(sums, a);
    if (found.cost < best.cost) best = {found.cost, {a, B, found.c, D, found.e}};
    return found.cost;
  };
  double left = high - kGolden * (high - low);
  double right = low + kGolden * (high - low);
  double cost_left = look_at(left);
  double cost_right = look_at(right);
  for (int step = 1; step < 12; ++step)
    if (cost_left < cost_right) {
      high = right;
      right = left;
      cost_right = cost_left;
      left = high - kGolden * (high - low);
      cost_left = look_at(left);
    } else {
      low = left;
      left = right;
      cost_left = cost_right;
      right = low + kGolden * (high - low);
      cost_right = look_at(right);
    }
  return best;
}

/// The least cost at every node, [rate][width].
std::vector<GridMinimum> scan(const GridSums& sums, const std::vector<double>& rates,
                              const std::vector<double>& widths) {
  const std::vector<double> gradations = gradation_nodes();
  std::vector<GridMinimum> grid;
  grid.reserve(rates.size() * widths.size());
  for (std::size_t b = 0; b < rates.size(); ++b)
    for (std::size_t d = 0; d < widths.size(); ++d)
      grid.push_back(best_at(sums.at(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(d)), rates[b],
                             widths[d], gradations));
  return grid;
}

}  // namespace

std::vector<GridMinimum> search_grid(const FitProblem& problem, const FitOptions& options) {
  const std::vector<double> rates = rate_nodes(options);
  const std::vector<double> widths = width_nodes(options);
  const std::vector<GridMinimum> grid = scan(GridSums(problem, rates, widths), rates, widths);
  const std::size_t nB = rates.size();
  const std::size_t nD = widths.size();

  std::vector<GridMinimum> minima;
  for (std::size_t b = 0; b < nB; ++b)
    for (std::size_t d = 0; d < nD; ++d) {
      // Lowest among the four next nodes; a diagonal valley then offers several starts along its floor.
      const std::size_t here = b * nD + d;
      const auto not_above = [&](std::size_t other) { return grid[other].cost >= grid[here].cost; };
      if ((b == 0 || not_above(here - nD)) && (b == nB - 1 || not_above(here + nD)) &&
          (d == 0 || not_above(here - 1)) && (d == nD - 1 || not_above(here + 1)))
        minima.push_back(grid[here]);
    }
  std::stable_sort(minima.begin(), minima.end(),
                   [](const GridMinimum& one, const GridMinimum& other) { return one.cost < other.cost; });
  const auto count = static_cast<std::size_t>(options.starts);
  if (minima.size() > count) minima.resize(count);
  return minima;
}

}  // namespace skylut::fit_detail
