#include "interpolation.hpp"

#include <algorithm>

namespace skylut::transfer {

Taps cubic_taps(const std::vector<double>& nodes, double x) {
  x = std::clamp(x, nodes.front(), nodes.back());
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), x);
  const int last_first = static_cast<int>(nodes.size()) - 4;
  Taps taps;
  taps.first = std::clamp(static_cast<int>(above - nodes.begin()) - 2, 0, last_first);
  const double* node = nodes.data() + taps.first;
  for (int i = 0; i < 4; ++i) {
    double weight = 1.0;
    for (int other = 0; other < 4; ++other)
      if (other != i) weight *= (x - node[other]) / (node[i] - node[other]);
    taps.weight[i] = static_cast<float>(weight);
  }
  return taps;
}

}  // namespace skylut::transfer
