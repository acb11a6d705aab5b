#include "skylut/models/compact/cubic_spline.hpp"

#include <algorithm>

#include "skylut/core/check.hpp"

namespace skylut::compact {

CubicSpline::CubicSpline(const std::vector<double>& nodes) {
  SKYLUT_CHECK_LE(std::size_t{4}, nodes.size());
  knots_.assign(4, nodes.front());
  knots_.insert(knots_.end(), nodes.begin() + 2, nodes.end() - 2);
  knots_.insert(knots_.end(), 4, nodes.back());
  for (std::size_t i = 0; i < nodes.size(); ++i) whole_ = whole_ && nodes[i] == static_cast<double>(i);
  // Each cubic from its values at t = 0, 1/3, 2/3 and 1.
  for (std::size_t span = 3; span < size(); ++span) {
    const double length = knots_[span + 1] - knots_[span];
    Piece piece{knots_[span], 1.0 / length, {}};
    std::array<std::array<double, 4>, 4> at;
    for (std::size_t i = 0; i < 4; ++i)
      at[i] = recurrence(span, knots_[span] + length * static_cast<double>(i) / 3.0);
    for (std::size_t b = 0; b < 4; ++b) {
      const double v0 = at[0][b];
      const double v1 = at[1][b];
      const double v2 = at[2][b];
      const double v3 = at[3][b];
      piece.cubic[0][b] = v0;
      piece.cubic[1][b] = (-11.0 * v0 + 18.0 * v1 - 9.0 * v2 + 2.0 * v3) / 2.0;
      piece.cubic[2][b] = (18.0 * v0 - 45.0 * v1 + 36.0 * v2 - 9.0 * v3) / 2.0;
      piece.cubic[3][b] = (-9.0 * v0 + 27.0 * v1 - 27.0 * v2 + 9.0 * v3) / 2.0;
    }
    piece_.push_back(piece);
  }
}

// Cox's and de Boor's, from the one constant piece up to the four cubics.
std::array<double, 4> CubicSpline::recurrence(std::size_t span, double x) const {
  std::array<double, 4> value{1.0, 0.0, 0.0, 0.0};
  double left[4];
  double right[4];
  for (std::size_t degree = 1; degree <= 3; ++degree) {
    left[degree] = x - knots_[span + 1 - degree];
    right[degree] = knots_[span + degree] - x;
    double saved = 0.0;
    for (std::size_t r = 0; r < degree; ++r) {
      const double part = value[r] / (right[r + 1] + left[degree - r]);
      value[r] = saved + right[r + 1] * part;
      saved = left[degree - r] * part;
    }
    value[degree] = saved;
  }
  return value;
}

std::size_t CubicSpline::interval(double x) const {
  // Of whole numbers the first and the last two share an interval.
  if (whole_) return std::min(static_cast<std::size_t>(std::max(x - 1.0, 0.0)), piece_.size() - 1);
  const auto above = std::upper_bound(piece_.begin() + 1, piece_.end(), x,
                                      [](double value, const Piece& piece) { return value < piece.from; });
  return static_cast<std::size_t>(above - piece_.begin()) - 1;
}

SplineTaps CubicSpline::taps(double x) const {
  x = std::clamp(x, knots_.front(), knots_.back());
  const std::size_t index = interval(x);
  const Piece& piece = piece_[index];
  const double t = (x - piece.from) * piece.inverse_length;
  SplineTaps taps{index, {}};
  const auto& cubic = piece.cubic;
  for (std::size_t b = 0; b < 4; ++b)
    taps.weight[b] = ((cubic[3][b] * t + cubic[2][b]) * t + cubic[1][b]) * t + cubic[0][b];
  return taps;
}

}  // namespace skylut::compact
