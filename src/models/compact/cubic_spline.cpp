#include "skylut/models/compact/cubic_spline.hpp"

#include <algorithm>

#include "skylut/core/check.hpp"

namespace skylut::compact {

CubicSpline::CubicSpline(const std::vector<double>& nodes) {
  SKYLUT_CHECK_LE(std::size_t{4}, nodes.size());
  knots_.assign(4, nodes.front());
  knots_.insert(knots_.end(), nodes.begin() + 2, nodes.end() - 2);
  knots_.insert(knots_.end(), 4, nodes.back());
}

SplineTaps CubicSpline::taps(double x) const {
  x = std::clamp(x, knots_.front(), knots_.back());
  const auto last = static_cast<std::ptrdiff_t>(size()) - 1;
  const auto above = std::upper_bound(knots_.begin() + 4, knots_.begin() + last + 1, x) - knots_.begin();
  const auto span = static_cast<std::size_t>(above - 1);  // knots[span] <= x <= knots[span + 1]
  // Cox's and de Boor's recurrence, from the one constant piece up to the four cubics.
  SplineTaps taps{span - 3, {1.0, 0.0, 0.0, 0.0}};
  double left[4];
  double right[4];
  for (std::size_t degree = 1; degree <= 3; ++degree) {
    left[degree] = x - knots_[span + 1 - degree];
    right[degree] = knots_[span + degree] - x;
    double saved = 0.0;
    for (std::size_t r = 0; r < degree; ++r) {
      const double part = taps.weight[r] / (right[r + 1] + left[degree - r]);
      taps.weight[r] = saved + right[r + 1] * part;
      saved = left[degree - r] * part;
    }
    taps.weight[degree] = saved;
  }
  return taps;
}

}  // namespace skylut::compact
