#include "skylut/core/quadrature.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

Quadrature gauss_legendre(int count, double lower, double upper) {
  if (count < 1) throw InputError("quadrature with {} nodes: needs at least 1", count);
  const auto size = static_cast<std::size_t>(count);
  Quadrature rule{std::vector<double>(size), std::vector<double>(size)};
  for (int i = 0; i < count; ++i) {
    // Tricomi's guess, then Newton: quadratic convergence, six steps reach round-off.
    double x = -std::cos(kPi * (i + 0.75) / (count + 0.5));
    double derivative = 0.0;
    for (int newton = 0; newton < 6; ++newton) {
      double previous = 0.0;
      double legendre = 1.0;
      for (int l = 1; l <= count; ++l) {
        const double next = ((2.0 * l - 1.0) * x * legendre - (l - 1.0) * previous) / l;
        previous = legendre;
        legendre = next;
      }
      derivative = count * (x * legendre - previous) / (x * x - 1.0);
      x -= legendre / derivative;
    }
    const auto at = static_cast<std::size_t>(i);
    rule.node[at] = 0.5 * (lower + upper) + 0.5 * (upper - lower) * x;
    rule.weight[at] = (upper - lower) / ((1.0 - x * x) * derivative * derivative);
  }
  return rule;
}

}  // namespace skylut
