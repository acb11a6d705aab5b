#include "branches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "half_skies.hpp"

namespace skylut::table_detail {

namespace {

constexpr std::size_t kAxes = 3;

/// The misfits of all halves between neighbours.
class Halves {
 public:
  explicit Halves(const BranchGrid& grid) : grid_(grid) {
    for (const double sun : grid.sun_zeniths_rad) suns_.emplace_back(sun);
    for (std::size_t sun = 1; sun < grid.sun_zeniths_rad.size(); ++sun)
      between_suns_.emplace_back(0.5 * (grid.sun_zeniths_rad[sun - 1] + grid.sun_zeniths_rad[sun]));
    for (std::size_t node = 0; node < grid.branches.size(); ++node) {
      auto& skies = logarithms_.emplace_back();
      for (const Branch& branch : grid.branches[node]) {
        skies.push_back(suns_[position(node, 2)].relative(branch.coefficients));
        for (double& value : skies.back()) value = std::log(value);
      }
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      for (std::size_t node = 0; node < grid.branches.size(); ++node)
        tables_[axis].push_back(is_last(node, axis) ? std::vector<double>() : table(node, axis));
  }

  std::size_t stride(std::size_t axis) const {
    return axis == 2 ? 1 : axis == 1 ? grid_.sizes[2] : grid_.sizes[1] * grid_.sizes[2];
  }
  std::size_t position(std::size_t node, std::size_t axis) const {
    return node / stride(axis) % grid_.sizes[axis];
  }
  bool is_last(std::size_t node, std::size_t axis) const {
    return position(node, axis) + 1 == grid_.sizes[axis];
  }

  /// Between a node's branch and one of the next node's along an axis.
  double at(std::size_t node, std::size_t branch, std::size_t axis, std::size_t next_branch) const {
    return tables_[axis][node][branch * grid_.branches[node + stride(axis)].size() + next_branch];
  }

 private:
  std::vector<double> table(std::size_t node, std::size_t axis) const {
    const std::size_t next = node + stride(axis);
    const std::size_t sun = position(node, 2);
    const FormulaDome& dome = axis == 2 ? between_suns_[sun] : suns_[sun];
    std::vector<double> misfits;
    for (std::size_t one = 0; one < grid_.branches[node].size(); ++one)
      for (std::size_t other = 0; other < grid_.branches[next].size(); ++other)
        misfits.push_back(half_misfit(dome, grid_.branches[node][one].coefficients, logarithms_[node][one],
                                      grid_.branches[next][other].coefficients, logarithms_[next][other],
                                      grid_.limit));
    return misfits;
  }

  const BranchGrid& grid_;
  std::vector<FormulaDome> suns_;
  std::vector<FormulaDome> between_suns_;
  std::vector<std::vector<std::vector<double>>> logarithms_;    // [node][branch][direction]
  std::array<std::vector<std::vector<double>>, kAxes> tables_;  // [axis][node][branch × next branch]
};

class Chooser {
 public:
  explicit Chooser(const BranchGrid& grid) : grid_(grid), halves_(grid), chosen_(grid.branches.size(), 0) {}

  ChosenBranches choose() {
    const std::vector<std::size_t> from_least = settled();
    const double cost_from_least = cost();
    grow();
    settled();
    if (!(cost() < cost_from_least * (1.0 - 1e-9))) chosen_ = from_least;
    return {chosen_, beside_impossible()};
  }

 private:
  const std::vector<std::size_t>& settled() {
    constexpr int kMostSweeps = 20;
    bool moved = true;
    for (int sweep = 0; moved && sweep < kMostSweeps; ++sweep) {
      moved = false;
      for (std::size_t axis = 0; axis < kAxes; ++axis)
        for (std::size_t node = 0; node < chosen_.size(); ++node)
          if (halves_.position(node, axis) == 0) moved = settle_line(node, axis) || moved;
    }
    return chosen_;
  }

  // Branches that hang together from the node on that has the least choice: always the neighbour of a settled
  // node that has the least, by its halves with the settled. Lines alone do not turn a whole grid that stands
  // in another valley than a single node.
  void grow() {
    std::vector<bool> is_settled(chosen_.size(), false);
    std::vector<bool> is_next(chosen_.size(), false);
    const auto choice = [&](std::size_t node) { return grid_.branches[node].size(); };
    std::size_t node = 0;
    for (std::size_t other = 1; other < chosen_.size(); ++other)
      if (choice(other) < choice(node)) node = other;
    for (std::size_t count = 0; count < chosen_.size(); ++count) {
      std::vector<double> sums;
      for (const Branch& branch : grid_.branches[node]) sums.push_back(loss(branch));
      for_neighbours(node, [&](std::size_t other, std::size_t axis) {
        is_next[other] = true;
        for (std::size_t branch = 0; is_settled[other] && branch < sums.size(); ++branch)
          sums[branch] += other < node ? halves_.at(other, chosen_[other], axis, branch)
                                       : halves_.at(node, branch, axis, chosen_[other]);
      });
      chosen_[node] = static_cast<std::size_t>(std::min_element(sums.begin(), sums.end()) - sums.begin());
      is_settled[node] = true;
      bool found = false;
      for (std::size_t other = 0; other < chosen_.size(); ++other)
        if (is_next[other] && !is_settled[other] && (!found || choice(other) < choice(node))) {
          node = other;
          found = true;
        }
    }
  }

  template <class Use>
  void for_neighbours(std::size_t node, const Use& use) const {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (halves_.position(node, axis) > 0) use(node - halves_.stride(axis), axis);
      if (!halves_.is_last(node, axis)) use(node + halves_.stride(axis), axis);
    }
  }

  // All halves and losses.
  double cost() const {
    double sum = 0.0;
    for (std::size_t node = 0; node < chosen_.size(); ++node) {
      sum += loss(grid_.branches[node][chosen_[node]]);
      for (std::size_t axis = 0; axis < kAxes; ++axis)
        if (!halves_.is_last(node, axis))
          sum += halves_.at(node, chosen_[node], axis, chosen_[node + halves_.stride(axis)]);
    }
    return sum;
  }

  // What a branch loses by itself. Of equal halves the cheaper branch; one that is not as good only for
  // halves that are impossible otherwise.
  static double loss(const Branch& branch) {
    return branch.as_good ? 1e-3 * branch.excess : 5.0 + branch.excess;
  }

  // That and its halves with the neighbours across the line.
  double own(std::size_t node, std::size_t branch, std::size_t line_axis) const {
    double sum = loss(grid_.branches[node][branch]);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (axis == line_axis) continue;
      const std::size_t before = node - halves_.stride(axis);
      if (halves_.position(node, axis) > 0) sum += halves_.at(before, chosen_[before], axis, branch);
      if (!halves_.is_last(node, axis))
        sum += halves_.at(node, branch, axis, chosen_[node + halves_.stride(axis)]);
    }
    return sum;
  }

  // The best branches along one line, by dynamic programming. Whether any changed for less.
  bool settle_line(std::size_t first, std::size_t axis) {
    const std::size_t length = grid_.sizes[axis];
    const std::size_t stride = halves_.stride(axis);
    std::vector<std::vector<double>> best(length);
    std::vector<std::vector<std::size_t>> from(length);
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t node = first + i * stride;
      for (std::size_t branch = 0; branch < grid_.branches[node].size(); ++branch) {
        double least = i == 0 ? 0.0 : std::numeric_limits<double>::infinity();
        std::size_t least_from = 0;
        for (std::size_t before = 0; i > 0 && before < best[i - 1].size(); ++before) {
          const double sum = best[i - 1][before] + halves_.at(node - stride, before, axis, branch);
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
      chosen_[first + i * stride] = branch;
      branch = from[i][branch];
    }
    return true;
  }

  double cost_of_line(std::size_t first, std::size_t axis) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < grid_.sizes[axis]; ++i) {
      const std::size_t node = first + i * halves_.stride(axis);
      sum += own(node, chosen_[node], axis);
      if (!halves_.is_last(node, axis))
        sum += halves_.at(node, chosen_[node], axis, chosen_[node + halves_.stride(axis)]);
    }
    return sum;
  }

  std::vector<bool> beside_impossible() const {
    std::vector<bool> beside(chosen_.size(), false);
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      for (std::size_t node = 0; node < chosen_.size(); ++node) {
        if (halves_.is_last(node, axis)) continue;
        const std::size_t next = node + halves_.stride(axis);
        if (halves_.at(node, chosen_[node], axis, chosen_[next]) >= kImpossibleHalf)
          beside[node] = beside[next] = true;
      }
    return beside;
  }

  const BranchGrid& grid_;
  Halves halves_;
  std::vector<std::size_t> chosen_;
};

}  // namespace

ChosenBranches choose_branches(const BranchGrid& grid) { return Chooser(grid).choose(); }

}  // namespace skylut::table_detail
