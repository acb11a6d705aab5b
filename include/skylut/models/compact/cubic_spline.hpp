#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace skylut::compact {

/// The four coefficients that a cubic spline has at one place, and their weights.
struct SplineTaps {
  std::size_t first = 0;
  double weight[4] = {};
};

/// The space of cubic splines with given nodes, whose first and last two intervals share a cubic each
/// ("not-a-knot"): as many B-splines as nodes. [de Boor, A Practical Guide to Splines, 2001, ch. IX and XIII]
class CubicSpline {
 public:
  CubicSpline() = default;
  /// @param nodes  ascending, at least 4
  explicit CubicSpline(const std::vector<double>& nodes);

  std::size_t size() const { return knots_.empty() ? 0 : knots_.size() - 4; }

  /// @param x  moved into the range of the nodes
  SplineTaps taps(double x) const;

 private:
  /// The four B-splines of one interval as cubics of its own coordinate t from 0 to 1, [power][B-spline].
  struct Piece {
    double from;
    double inverse_length;
    std::array<std::array<double, 4>, 4> cubic;
  };
  std::array<double, 4> recurrence(std::size_t span, double x) const;
  std::size_t interval(double x) const;

  std::vector<double> knots_;
  std::vector<Piece> piece_;
  bool whole_ = true;  // the nodes are 0, 1, 2, …
};

}  // namespace skylut::compact
