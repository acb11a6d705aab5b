#include "interpolation.hpp"

#include <algorithm>
#include <cmath>

namespace skylut::transfer {

namespace {

constexpr int kCells = 512;

}  // namespace

CubicInterpolation::CubicInterpolation(const std::vector<double>& nodes)
    : lowest_(nodes.front()),
      highest_(nodes.back()),
      cells_per_unit_(kCells / (nodes.back() - nodes.front())),
      nodes_(nodes) {
  for (std::size_t first = 0; first + 4 <= nodes.size(); ++first) {
    Stencil stencil{};
    for (std::size_t i = 0; i < 4; ++i) {
      stencil.node[i] = nodes[first + i];
      stencil.inverse_denominator[i] = 1.0;
      for (std::size_t other = 0; other < 4; ++other)
        if (other != i) stencil.inverse_denominator[i] /= nodes[first + i] - nodes[first + other];
    }
    stencil_.push_back(stencil);
  }
  for (int cell = 0; cell <= kCells; ++cell) {
    const auto above = std::upper_bound(nodes.begin(), nodes.end(), lowest_ + cell / cells_per_unit_);
    node_below_.push_back(std::max(0, static_cast<int>(above - nodes.begin()) - 1));
  }
}

InterpolationWeights CubicInterpolation::operator()(double x) const {
  x = std::clamp(x, lowest_, highest_);
  auto below =
      static_cast<std::size_t>(node_below_[static_cast<std::size_t>((x - lowest_) * cells_per_unit_)]);
  while (below + 1 < nodes_.size() && nodes_[below + 1] <= x) ++below;
  InterpolationWeights weights;
  weights.first = std::clamp(static_cast<int>(below) - 1, 0, static_cast<int>(stencil_.size()) - 1);
  const Stencil& stencil = stencil_[static_cast<std::size_t>(weights.first)];
  const double d[4] = {x - stencil.node[0], x - stencil.node[1], x - stencil.node[2], x - stencil.node[3]};
  const double* scale = stencil.inverse_denominator;
  const double outer = d[0] * d[3];
  const double inner = d[1] * d[2];
  weights.weight[0] = static_cast<float>(inner * d[3] * scale[0]);
  weights.weight[1] = static_cast<float>(outer * d[2] * scale[1]);
  weights.weight[2] = static_cast<float>(outer * d[1] * scale[2]);
  weights.weight[3] = static_cast<float>(inner * d[0] * scale[3]);
  return weights;
}

}  // namespace skylut::transfer
