#include "skylut/core/quadrature.hpp"

#include <array>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut {

namespace {

// Nodes worked on together, because the recurrence by itself waits for its own results.
constexpr std::size_t kTile = 16;
using Tile = std::array<double, kTile>;

}  // namespace

Quadrature gauss_legendre(int count, double lower, double upper) {
  if (count < 1) throw InputError("quadrature with {} nodes: needs at least 1", count);
  const auto size = static_cast<std::size_t>(count);
  Quadrature rule{std::vector<double>(size), std::vector<double>(size)};
  // The rule is symmetric: the nodes x <= 0 tell the others.
  const std::size_t half = (size + 1) / 2;
  for (std::size_t first = 0; first < half; first += kTile) {
    // Tricomi's guess, then Newton: quadratic convergence, four steps reach round-off for every count.
    Tile x;
    for (std::size_t i = 0; i < kTile; ++i)
      x[i] = -(1.0 - (count - 1.0) / (8.0 * count * count * count)) *
             std::cos(kPi * (static_cast<double>(first + i) + 0.75) / (count + 0.5));
    Tile derivative{};
    for (int newton = 0; newton < 4; ++newton) {
      Tile previous{};
      Tile legendre;
      legendre.fill(1.0);
      for (int l = 1; l <= count; ++l) {
        const double part = 1.0 / l;
        for (std::size_t i = 0; i < kTile; ++i) {
          const double next = next_legendre(part, x[i], legendre[i], previous[i]);
          previous[i] = legendre[i];
          legendre[i] = next;
        }
      }
      for (std::size_t i = 0; i < kTile; ++i) {
        derivative[i] = count * (x[i] * legendre[i] - previous[i]) / (x[i] * x[i] - 1.0);
        x[i] -= legendre[i] / derivative[i];
      }
    }
    for (std::size_t i = 0; i < kTile && first + i < half; ++i) {
      const std::size_t mirrored = size - 1 - (first + i);
      const double node = mirrored == first + i ? 0.0 : x[i];
      const double weight = (upper - lower) / ((1.0 - node * node) * derivative[i] * derivative[i]);
      rule.node[first + i] = 0.5 * (lower + upper) + 0.5 * (upper - lower) * node;
      rule.node[mirrored] = 0.5 * (lower + upper) - 0.5 * (upper - lower) * node;
      rule.weight[first + i] = rule.weight[mirrored] = weight;
    }
  }
  return rule;
}

}  // namespace skylut
