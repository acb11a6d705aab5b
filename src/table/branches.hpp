#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "skylut/models/perez.hpp"

/// Rows of a table are halved, blended and interpolated: of minima that are equally good the one is taken that
/// its neighbours continue. [fit.md F8]
namespace skylut::table_detail {

/// One formula that a node may take, and its cost over the least.
struct Branch {
  PerezCoefficients coefficients;
  double excess = 0.0;  ///< cost/least - 1
};

/// The nodes of one channel: [altitude][turbidity][sun], every axis ascending.
struct BranchGrid {
  std::array<std::size_t, 3> sizes;
  std::vector<double> sun_zeniths_rad;        ///< of the last axis
  std::vector<std::vector<Branch>> branches;  ///< [node], least cost first
};

/// How far the sky of the halved coefficients lies from between the skies of the two rows: mean square of
/// ln F_half - ½ (ln F_1 + ln F_2), each relative to its zenith, over the dome; a large number for every
/// direction in which it is not positive.
double half_misfit(const PerezCoefficients& one, double sun_one_rad, const PerezCoefficients& other,
                   double sun_other_rad);

/// The branch of every node for which all halves of neighbours together lie best: line after line of the grid
/// is settled at once, exactly, the others standing still, until nothing moves.
std::vector<std::size_t> choose_branches(const BranchGrid& grid);

}  // namespace skylut::table_detail
