#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "skylut/core/check.hpp"
#include "skylut/core/directions.hpp"

namespace skylut {

/// A view as seen from the sun's azimuth, on one side of the sun's vertical plane (the other side is its
/// mirror image). Where azimuth has no meaning (view or sun at the zenith or nadir) it is 0.
RelativeView relative_view(const Direction& view, const Direction& sun);

/// The different things that the transfer must compute so that every view is known under every sun:
/// mirror-symmetric views and suns are computed once and so have identical values.
class ViewSet {
 public:
  ViewSet(std::span<const Direction> views, std::span<const Direction> suns);

  const std::vector<RelativeView>& unique_views() const { return unique_views_; }
  const std::vector<double>& unique_sun_zeniths_deg() const { return unique_sun_zeniths_deg_; }

  /// Index into unique_views() of one view under one sun.
  std::size_t view_index(std::size_t view, std::size_t sun) const {
    SKYLUT_CHECK_LT(view, views_);
    SKYLUT_CHECK_LT(sun, sun_index_.size());
    return view_index_[sun * views_ + view];
  }

  /// Index into unique_sun_zeniths_deg() of one sun.
  std::size_t sun_index(std::size_t sun) const { return sun_index_[sun]; }

 private:
  std::size_t views_;
  std::vector<RelativeView> unique_views_;
  std::vector<double> unique_sun_zeniths_deg_;
  std::vector<std::size_t> view_index_;
  std::vector<std::size_t> sun_index_;
};

}  // namespace skylut
