#include "multistart.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace skylut::fit_detail {

namespace {

void sort_by_cost(std::vector<Minimum>& ends) {
  std::stable_sort(ends.begin(), ends.end(),
                   [](const Minimum& one, const Minimum& other) { return one.cost < other.cost; });
}

bool same_place(const Minimum& one, const Minimum& other, double nearness) {
  return std::equal(one.at.begin(), one.at.end(), other.at.begin(), [&](double a, double b) {
    return std::abs(a - b) <= nearness * std::max({std::abs(a), std::abs(b), 1e-3});
  });
}

// Of ends in one place the first is kept.
void keep_different(std::vector<Minimum>& ends, double nearness) {
  std::vector<Minimum> kept;
  for (Minimum& end : ends)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Minimum& other) { return same_place(end, other, nearness); }))
      kept.push_back(std::move(end));
  ends = std::move(kept);
}

}  // namespace

std::vector<Minimum> multistart(const Search& search, const std::vector<Start>& starts, int max_iterations,
                                double within) {
  constexpr double kRough = 1e-3;
  constexpr int kRoughIterations = 12;
  constexpr double kRoughlySame = 0.03;
  constexpr double kThorough = 1e-14;
  constexpr double kSame = 1e-3;
  constexpr std::size_t kBest = 2;
  std::vector<Minimum> rough;
  for (const Start& start : starts) {
    Minimum end = search(start, kRough, std::min(kRoughIterations, max_iterations));
    if (std::isfinite(end.cost)) rough.push_back(std::move(end));
  }
  sort_by_cost(rough);
  keep_different(rough, kRoughlySame);
  std::vector<Minimum> ends;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    // A short run stops short of its minimum by more than its tolerance.
    constexpr double kShort = 0.02;
    if (i >= kBest && rough[i].cost > (1.0 + within + kShort) * rough.front().cost) break;
    Minimum end = search(rough[i].at, kThorough, max_iterations);
    end.iterations += rough[i].iterations;
    if (std::isfinite(end.cost)) ends.push_back(std::move(end));
  }
  sort_by_cost(ends);
  keep_different(ends, kSame);
  std::erase_if(ends, [&, least = ends.empty() ? 0.0 : ends.front().cost](const Minimum& end) {
    return end.cost > (1.0 + within) * least;
  });
  return ends;
}

}  // namespace skylut::fit_detail
