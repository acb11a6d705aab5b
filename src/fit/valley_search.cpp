#include "valley_search.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

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

// The sums over the observations that a (B, D) node needs: with g = 1 + a U and the columns h g {1, W, K},
// every inner product is a polynomial in a. h: model scale, t: target.
struct NodeSums {
  // Of h² U^i times 1, W, K, W², WK, K²; i = 0, 1, 2.
  double one[3], W[3], K[3], WW[3], WK[3], KK[3];
  // Of h t U^i times 1, W, K; i = 0, 1.
  double t_one[2], t_W[2], t_K[2];
  double t_t;
};

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
  // Nearly dependent columns (1e-10 of their product): e alone; the polish sorts it out.
  if (determinant > 1e-10 * WW * KK) {
    result.c = (KK * right_W - WK * right_K) / determinant;
    result.e = (WW * right_K - WK * right_W) / determinant;
  } else if (KK > 0.0) {
    result.e = right_K / KK;
  }
  result.cost = 0.5 * (offset - result.c * right_W - result.e * right_K);
  return result;
}

Valley best_at(const NodeSums& sums, double B, double D, const std::vector<double>& gradations) {
  Valley best{std::numeric_limits<double>::infinity(), {}};
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

}  // namespace

std::vector<Valley> search_valleys(const FitProblem& problem, const FitOptions& options, int count) {
  const std::vector<double> rates = rate_nodes(options);
  const std::vector<double> widths = width_nodes(options);
  const std::vector<double> gradations = gradation_nodes();
  const auto n = static_cast<Eigen::Index>(problem.observations.size());
  const auto nB = static_cast<Eigen::Index>(rates.size());
  const auto nD = static_cast<Eigen::Index>(widths.size());

  Eigen::ArrayXd h(n);
  Eigen::ArrayXd t(n);
  Eigen::ArrayXd K(n);
  Eigen::ArrayXXd U(n, nB);
  Eigen::ArrayXXd W(n, nD);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Observation& o = problem.observations[static_cast<std::size_t>(i)];
    h(i) = o.model_scale;
    t(i) = o.target;
    K(i) = o.cos2_excess;
    for (Eigen::Index b = 0; b < nB; ++b)
      U(i, b) = gradation_basis(rates[static_cast<std::size_t>(b)], o.secant_excess);
    for (Eigen::Index d = 0; d < nD; ++d)
      W(i, d) = aureole_basis(widths[static_cast<std::size_t>(d)], o.gamma_rad, problem.sun);
  }

  // Inner products of every U^i with every function of W at once, as matrix products.
  const Eigen::MatrixXd powers[3] = {Eigen::MatrixXd::Ones(n, nB), U.matrix(), U.square().matrix()};
  const Eigen::ArrayXd hh = h * h;
  const Eigen::ArrayXd ht = h * t;
  const Eigen::MatrixXd hhW = (W.colwise() * hh).matrix();
  const Eigen::MatrixXd hhWW = (W.square().colwise() * hh).matrix();
  const Eigen::MatrixXd hhWK = (W.colwise() * (hh * K)).matrix();
  const Eigen::MatrixXd htW = (W.colwise() * ht).matrix();
  Eigen::MatrixXd sum_W[3], sum_WW[3], sum_WK[3], sum_tW[2];
  Eigen::VectorXd sum_one[3], sum_K[3], sum_KK[3], sum_t[2], sum_tK[2];
  for (int i = 0; i < 3; ++i) {
    const Eigen::MatrixXd transposed = powers[i].transpose();
    sum_W[i] = transposed * hhW;
    sum_WW[i] = transposed * hhWW;
    sum_WK[i] = transposed * hhWK;
    sum_one[i] = transposed * hh.matrix();
    sum_K[i] = transposed * (hh * K).matrix();
    sum_KK[i] = transposed * (hh * K * K).matrix();
    if (i == 2) break;
    sum_tW[i] = transposed * htW;
    sum_t[i] = transposed * ht.matrix();
    sum_tK[i] = transposed * (ht * K).matrix();
  }
  const double t_t = t.square().sum();

  std::vector<Valley> grid(static_cast<std::size_t>(nB * nD));
  const auto node = [&](Eigen::Index b, Eigen::Index d) -> Valley& {
    return grid[static_cast<std::size_t>(b * nD + d)];
  };
  for (Eigen::Index b = 0; b < nB; ++b)
    for (Eigen::Index d = 0; d < nD; ++d) {
      NodeSums sums{};
      for (int i = 0; i < 3; ++i) {
        sums.one[i] = sum_one[i](b);
        sums.K[i] = sum_K[i](b);
        sums.KK[i] = sum_KK[i](b);
        sums.W[i] = sum_W[i](b, d);
        sums.WW[i] = sum_WW[i](b, d);
        sums.WK[i] = sum_WK[i](b, d);
        if (i == 2) break;
        sums.t_one[i] = sum_t[i](b);
        sums.t_K[i] = sum_tK[i](b);
        sums.t_W[i] = sum_tW[i](b, d);
      }
      sums.t_t = t_t;
      node(b, d) =
          best_at(sums, rates[static_cast<std::size_t>(b)], widths[static_cast<std::size_t>(d)], gradations);
    }

  std::vector<Valley> valleys;
  for (Eigen::Index b = 0; b < nB; ++b)
    for (Eigen::Index d = 0; d < nD; ++d) {
      // Lowest among the four next nodes; a diagonal valley then offers several starts along its floor.
      const double here = node(b, d).cost;
      const bool lowest =
          (b == 0 || node(b - 1, d).cost >= here) && (b == nB - 1 || node(b + 1, d).cost >= here) &&
          (d == 0 || node(b, d - 1).cost >= here) && (d == nD - 1 || node(b, d + 1).cost >= here);
      if (lowest) valleys.push_back(node(b, d));
    }
  std::stable_sort(valleys.begin(), valleys.end(),
                   [](const Valley& one, const Valley& other) { return one.cost < other.cost; });
  if (valleys.size() > static_cast<std::size_t>(count)) valleys.resize(static_cast<std::size_t>(count));
  return valleys;
}

}  // namespace skylut::fit_detail
