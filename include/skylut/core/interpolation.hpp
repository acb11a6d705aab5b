#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>

#include "skylut/core/check.hpp"

/// Interpolation among ascending nodes, in one dimension.
namespace skylut {

/// The piece [i, i+1] of two or more ascending nodes that holds x; beyond an end, the piece at that end.
/// @param node_of  takes a node's x from an element of the list
template <class Nodes, class NodeOf = std::identity>
std::size_t piece_of(const Nodes& nodes, double x, NodeOf node_of = {}) {
  SKYLUT_CHECK_GE(std::size(nodes), 2U);
  const auto above = std::upper_bound(
      std::begin(nodes) + 1, std::end(nodes) - 1, x,
      [&](double value, const auto& element) { return value < std::invoke(node_of, element); });
  return static_cast<std::size_t>(above - std::begin(nodes)) - 1;
}

/// Two neighbours around x, and how far from the first to the second it is, [0, 1]. Beyond the ends both are
/// the end node: values are held.
struct Bracket {
  std::size_t below = 0;
  std::size_t above = 0;
  double part = 0.0;
};

/// @param nodes  one or more, ascending
template <class Nodes>
Bracket held_bracket(const Nodes& nodes, double x) {
  SKYLUT_CHECK_GE(std::size(nodes), 1U);
  const std::size_t last = std::size(nodes) - 1;
  if (x <= nodes[0]) return {0, 0, 0.0};
  if (x >= nodes[last]) return {last, last, 0.0};
  const std::size_t i = piece_of(nodes, x);
  return {i, i + 1, (x - nodes[i]) / (nodes[i + 1] - nodes[i])};
}

/// A straight line from `lower` at part 0 to `upper` at part 1.
inline double linear(double lower, double upper, double part) { return lower + part * (upper - lower); }

/// The same for the logarithms of two positive values.
inline double log_linear(double lower, double upper, double part) {
  return lower * std::pow(upper / lower, part);
}

/// Logarithms where both values are positive; a straight line where one of them is 0.
inline double log_linear_or_linear(double lower, double upper, double part) {
  return lower > 0.0 && upper > 0.0 ? log_linear(lower, upper, part) : linear(lower, upper, part);
}

/// Weights of Lagrange's cubic through nodes at -1, 0, 1 and 2, at t.
inline std::array<double, 4> cubic_weights(double t) {
  return {-t * (t - 1.0) * (t - 2.0) / 6.0, (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
          -(t + 1.0) * t * (t - 2.0) / 2.0, (t + 1.0) * t * (t - 1.0) / 6.0};
}

}  // namespace skylut
