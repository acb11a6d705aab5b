#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "skylut/transfer/plane_parallel.hpp"
#include "view_list.hpp"

namespace skylut::plane_parallel {

/// Sums the azimuth series into the result: I and Q in cos mφ, U in sin mφ.
class AzimuthSeries {
 public:
  /// @param result  holds the light scattered once
  AzimuthSeries(const PlaneParallelRequest& request, const ViewList& views, PlaneParallelResult& result)
      : request_(request), views_(views), result_(result) {}

  /// Adds mode m as radiance_at_views() gives it. @return true once the series has converged: when two modes
  /// in a row change no radiance, and no Q and U, by more than 1e-6 of the radiance
  bool add(int mode, const Eigen::MatrixXd& at_bounds, const std::vector<std::size_t>& output_bounds);

 private:
  const PlaneParallelRequest& request_;
  const ViewList& views_;
  PlaneParallelResult& result_;
  int small_in_a_row_ = 0;
};

}  // namespace skylut::plane_parallel
