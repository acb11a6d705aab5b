#include "branches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "skylut/core/constants.hpp"
#include "skylut/core/directions.hpp"

namespace skylut::table_detail {

namespace {

constexpr double kImpossible = 100.0;  // of a direction whose half is not positive; ln 2 makes 0.5

double relative(const PerezCoefficients& k, const Direction& view, double sun_rad) {
  const double gamma = angle_between(view, {sun_rad * kDegreesPerRadian, 0.0});
  return perez_relative(k, view.zenith_deg * kRadiansPerDegree, gamma, sun_rad);
}

const std::vector<Direction>& dome() {
  static const std::vector<Direction> views = [] {
    std::vector<Direction> all{{0.0, 0.0}};
    for (const double zenith : {10.0, 22.5, 35.0, 45.0, 55.0, 67.5, 78.0, 85.0, 88.0, 89.5, 90.0})
      for (const double azimuth : {0.0, 2.0, 10.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0})
        all.push_back({zenith, azimuth});
    return all;
  }();
  return views;
}

class Chooser {
 public:
  explicit Chooser(const BranchGrid& grid) : grid_(grid), chosen_(grid.branches.size(), 0) {}

  std::vector<std::size_t> choose() {
    constexpr int kMostSweeps = 20;
    bool moved = true;
    for (int sweep = 0; moved && sweep < kMostSweeps; ++sweep) {
      moved = false;
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t node = 0; node < chosen_.size(); ++node)
          if (position(node, axis) == 0) moved = settle_line(node, axis) || moved;
    }
    return chosen_;
  }

 private:
  std::size_t stride(std::size_t axis) const {
    return axis == 2 ? 1 : axis == 1 ? grid_.sizes[2] : grid_.sizes[1] * grid_.sizes[2];
  }
  std::size_t position(std::size_t node, std::size_t axis) const {
    return node / stride(axis) % grid_.sizes[axis];
  }

  double between(std::size_t one, std::size_t branch, std::size_t other, std::size_t other_branch) const {
    return half_misfit(grid_.branches[one][branch].coefficients, grid_.sun_zeniths_rad[position(one, 2)],
                       grid_.branches[other][other_branch].coefficients,
                       grid_.sun_zeniths_rad[position(other, 2)]);
  }

  // A branch's own cost and its halves with the neighbours across the line. Equal halves: the cheaper.
  double own(std::size_t node, std::size_t branch, std::size_t line_axis) const {
    double sum = 1e-3 * grid_.branches[node][branch].excess;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == line_axis) continue;
      const std::size_t at = position(node, axis);
      if (at > 0) sum += between(node, branch, node - stride(axis), chosen_[node - stride(axis)]);
      if (at + 1 < grid_.sizes[axis])
        sum += between(node, branch, node + stride(axis), chosen_[node + stride(axis)]);
    }
    return sum;
  }

  // The best branches along one line, by dynamic programming. Whether any changed for less.
  bool settle_line(std::size_t first, std::size_t axis) {
    const std::size_t length = grid_.sizes[axis];
    std::vector<std::vector<double>> best(length);
    std::vector<std::vector<std::size_t>> from(length);
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t node = first + i * stride(axis);
      for (std::size_t branch = 0; branch < grid_.branches[node].size(); ++branch) {
        double least = i == 0 ? 0.0 : std::numeric_limits<double>::infinity();
        std::size_t least_from = 0;
        if (i > 0)
          for (std::size_t before = 0; before < best[i - 1].size(); ++before) {
            const double sum = best[i - 1][before] + between(node, branch, node - stride(axis), before);
            if (sum < least) {
              least = sum;
              least_from = before;
            }
          }
        best[i].push_back(least + own(node, branch, axis));
        from[i].push_back(least_from);
      }
    }
    const auto last = std::min_element(best.back().begin(), best.back().end());
    if (!(*last < cost_of_line(first, axis) * (1.0 - 1e-9))) return false;
    auto branch = static_cast<std::size_t>(last - best.back().begin());
    for (std::size_t i = length; i-- > 0;) {
      chosen_[first + i * stride(axis)] = branch;
      branch = from[i][branch];
    }
    return true;
  }

  double cost_of_line(std::size_t first, std::size_t axis) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < grid_.sizes[axis]; ++i) {
      const std::size_t node = first + i * stride(axis);
      sum += own(node, chosen_[node], axis);
      if (i > 0) sum += between(node, chosen_[node], node - stride(axis), chosen_[node - stride(axis)]);
    }
    return sum;
  }

  const BranchGrid& grid_;
  std::vector<std::size_t> chosen_;
};

}  // namespace

double half_misfit(const PerezCoefficients& one, double sun_one_rad, const PerezCoefficients& other,
                   double sun_other_rad) {
  const PerezCoefficients half{0.5 * (one.A + other.A), 0.5 * (one.B + other.B), 0.5 * (one.C + other.C),
                               0.5 * (one.D + other.D), 0.5 * (one.E + other.E)};
  const double sun_rad = 0.5 * (sun_one_rad + sun_other_rad);
  double sum = 0.0;
  for (const Direction& view : dome()) {
    const double found = relative(half, view, sun_rad);
    const double below = relative(one, view, sun_one_rad);
    const double above = relative(other, view, sun_other_rad);
    if (found > 0.0 && below > 0.0 && above > 0.0) {
      const double off = std::log(found) - 0.5 * (std::log(below) + std::log(above));
      sum += std::min(off * off, kImpossible);
    } else {
      sum += kImpossible;
    }
  }
  return sum / static_cast<double>(dome().size());
}

std::vector<std::size_t> choose_branches(const BranchGrid& grid) { return Chooser(grid).choose(); }

}  // namespace skylut::table_detail
