#include "skylut/scattering/tabulated_scattering_matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "polarised_tile.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"
#include "skylut/core/legendre.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {

namespace {

constexpr int kDegrees = 2001;
/// Tables are printed with a few digits, and curves between their angles differ.
constexpr double kNormalisation = 0.01;
/// Elements may exceed F11 by their rounding.
constexpr double kPrinted = 1e-3;

void check_angles(const std::vector<double>& theta_deg) {
  if (theta_deg.size() < 4)
    throw InputError("scattering matrix with {} angles: must have at least 4", theta_deg.size());
  if (theta_deg.front() != 0.0 || theta_deg.back() != 180.0)
    throw InputError("scattering matrix from {} to {} degrees: must begin at 0 and end at 180",
                     theta_deg.front(), theta_deg.back());
  for (std::size_t i = 1; i < theta_deg.size(); ++i)
    if (!(theta_deg[i] > theta_deg[i - 1]))
      throw InputError("scattering matrix: angle {} degrees must be greater than {}, the one before",
                       theta_deg[i], theta_deg[i - 1]);
}

/// The element relative to F11.
std::vector<double> relative(const char* name, const std::vector<double>& element,
                             const ScatteringTable& table) {
  if (element.size() != table.theta_deg.size())
    throw InputError("scattering matrix: {} has {} values, must have {}, one for every angle", name,
                     element.size(), table.theta_deg.size());
  std::vector<double> ratio;
  for (std::size_t i = 0; i < element.size(); ++i) {
    ratio.push_back(element[i] / table.f11[i]);
    if (!(std::abs(ratio.back()) <= 1.0 + kPrinted))
      throw InputError("scattering matrix: {} {} at {} degrees must lie within -f11 to f11 = {}", name,
                       element[i], table.theta_deg[i], table.f11[i]);
  }
  return ratio;
}

/// Lagrange's weights of four nodes at x.
std::array<double, 4> weights_at(std::span<const double, 4> node, double x) {
  std::array<double, 4> weight{1.0, 1.0, 1.0, 1.0};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) weight[i] *= (x - node[j]) / (node[i] - node[j]);
  return weight;
}

/// Angles with weights of ½ sinθ dθ, so many in each piece that a wave of the highest degree is resolved.
std::vector<std::pair<double, double>> nodes_between(const std::vector<double>& theta_rad) {
  std::vector<std::pair<double, double>> nodes;
  for (std::size_t i = 1; i < theta_rad.size(); ++i) {
    const double width = theta_rad[i] - theta_rad[i - 1];
    const Quadrature rule =
        gauss_legendre(8 + static_cast<int>(0.6 * kDegrees * width), theta_rad[i - 1], theta_rad[i]);
    for (std::size_t k = 0; k < rule.node.size(); ++k)
      nodes.emplace_back(rule.node[k], 0.5 * rule.weight[k] * std::sin(rule.node[k]));
  }
  return nodes;
}

/// A tile of angles of the integrals; unused places have the weight 0.
struct WeightedTile {
  PolarisedTile::Tile mu{};
  std::array<ScatteringMatrix, PolarisedTile::kSize> at{};
};

void add_tile(const WeightedTile& tile, std::vector<MatrixMoments>& moments) {
  constexpr std::size_t kSize = PolarisedTile::kSize;
  PolarisedTile::Tile before{};
  PolarisedTile::Tile legendre;
  legendre.fill(1.0);
  PolarisedTile functions(tile.mu);
  for (std::size_t l = 0; l < moments.size(); ++l) {
    const double part = 1.0 / (static_cast<double>(l) + 1.0);
    for (std::size_t i = 0; i < kSize; ++i) {
      moments[l].alpha1 += tile.at[i].f11 * legendre[i];
      const double next = next_legendre(part, tile.mu[i], legendre[i], before[i]);
      before[i] = legendre[i];
      legendre[i] = next;
    }
    if (l < 2) continue;
    double sum = 0.0;
    double difference = 0.0;
    for (std::size_t i = 0; i < kSize; ++i) {
      sum += (tile.at[i].f22 + tile.at[i].f33) * functions.same[i];
      difference += (tile.at[i].f22 - tile.at[i].f33) * functions.opposite[i];
      moments[l].beta1 += tile.at[i].f12 * functions.polarising[i];
    }
    moments[l].alpha2 += 0.5 * (sum + difference);
    moments[l].alpha3 += 0.5 * (sum - difference);
    functions.advance(l);
  }
}

ScatteringMatrix scaled(const ScatteringMatrix& matrix, double factor) {
  return {factor * matrix.f11, factor * matrix.f12, factor * matrix.f22, factor * matrix.f33};
}

}  // namespace

TabulatedScatteringMatrix::TabulatedScatteringMatrix(ScatteringTable table) {
  check_angles(table.theta_deg);
  if (table.f11.size() != table.theta_deg.size())
    throw InputError("scattering matrix: f11 has {} values, must have {}, one for every angle",
                     table.f11.size(), table.theta_deg.size());
  for (std::size_t i = 0; i < table.f11.size(); ++i) {
    if (!(table.f11[i] > 0.0 && std::isfinite(table.f11[i])))
      throw InputError("scattering matrix: f11 {} at {} degrees must be greater than 0", table.f11[i],
                       table.theta_deg[i]);
    theta_rad_.push_back(table.theta_deg[i] * kRadiansPerDegree);
    ln_f11_.push_back(std::log(table.f11[i]));
  }
  f12_ = relative("f12", table.f12, table);
  f22_ = relative("f22", table.f22, table);
  f33_ = relative("f33", table.f33, table);

  const std::vector<std::pair<double, double>> nodes = nodes_between(theta_rad_);
  moments_.resize(kDegrees);
  for (std::size_t first = 0; first < nodes.size(); first += PolarisedTile::kSize) {
    WeightedTile tile;
    for (std::size_t i = 0; i < PolarisedTile::kSize && first + i < nodes.size(); ++i) {
      const auto [theta, weight] = nodes[first + i];
      tile.mu[i] = std::cos(theta);
      tile.at[i] = scaled(at_angle(theta), weight);
    }
    add_tile(tile, moments_);
  }
  const double all = moments_[0].alpha1;
  if (!(std::abs(all - 1.0) <= kNormalisation))
    throw InputError(
        "scattering matrix: half the integral of f11 over the cosine of the angle is {:.6g}, must be 1 "
        "(within "
        "{})",
        all, kNormalisation);
  for (double& value : ln_f11_) value -= std::log(all);
  for (MatrixMoments& moment : moments_)
    moment = {moment.alpha1 / all, moment.alpha2 / all, moment.alpha3 / all, moment.beta1 / all};
}

ScatteringMatrix TabulatedScatteringMatrix::at_angle(double theta_rad) const {
  const std::size_t piece = piece_of(theta_rad_, theta_rad);
  const std::size_t first = std::min(piece == 0 ? 0 : piece - 1, theta_rad_.size() - 4);
  const auto weight = weights_at(std::span<const double, 4>(theta_rad_.data() + first, 4), theta_rad);
  const auto between = [&](const std::vector<double>& values) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) sum += weight[i] * values[first + i];
    return sum;
  };
  const double f11 = std::exp(between(ln_f11_));
  return {f11, f11 * std::clamp(between(f12_), -1.0, 1.0), f11 * std::clamp(between(f22_), -1.0, 1.0),
          f11 * std::clamp(between(f33_), -1.0, 1.0)};
}

ScatteringMatrix TabulatedScatteringMatrix::matrix(double cos_scattering_angle) const {
  return at_angle(std::acos(std::clamp(cos_scattering_angle, -1.0, 1.0)));
}

double TabulatedScatteringMatrix::value(double cos_scattering_angle) const {
  return matrix(cos_scattering_angle).f11;
}

double TabulatedScatteringMatrix::moment(int l) const {
  const auto order = static_cast<std::size_t>(l);
  return order < moments_.size() ? moments_[order].alpha1 : 0.0;
}

std::vector<MatrixMoments> TabulatedScatteringMatrix::matrix_moments(int max_l) const {
  std::vector<MatrixMoments> moments = moments_;
  moments.resize(static_cast<std::size_t>(max_l + 1));
  return moments;
}

}  // namespace skylut
