#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "skylut/core/check.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/transfer/sky_radiance.hpp"

namespace skylut {

/// A view as seen from the sun's azimuth, on one side of the sun's vertical plane (the other side is its
/// mirror image). Where azimuth has no meaning (view or sun at the zenith or nadir) it is 0.
RelativeView relative_view(const Direction& view, const Direction& sun);

/// The different things that the transfer must compute so that every view is known under every sun, and no
/// view under another sun: mirror-symmetric views and suns are computed once and so have identical values.
class ViewSet {
 public:
  ViewSet(std::span<const Direction> views, std::span<const Direction> suns);

  /// Different pairs of sun and view as seen from its azimuth.
  std::size_t size() const { return pairs_.size(); }

  /// Index of one view under one sun among the pairs.
  std::size_t index(std::size_t view, std::size_t sun) const {
    SKYLUT_CHECK_LT(view, views_);
    return index_[sun * views_ + view];
  }

  /// All pairs, seen from every altitude: [altitude][pair].
  std::vector<Sight> sights(std::span<const double> altitudes_km) const;

 private:
  struct Pair {
    double sun_zenith_deg;
    RelativeView view;
    auto operator<=>(const Pair&) const = default;
  };
  std::size_t views_;
  std::vector<Pair> pairs_;  // ascending
  std::vector<std::size_t> index_;
};

}  // namespace skylut
