#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "skylut/models/perez.hpp"

/// Rows of a table are halved, blended and interpolated: of minima that are equally good the one is taken
/// that its neighbours continue. [fit.md F8]
namespace skylut::table_detail {

/// One formula that a node may take.
struct Branch {
  PerezCoefficients coefficients;
  double excess = 0.0;  ///< cost/least - 1
  bool as_good = true;  ///< within what counts as equally good; others are for where nothing else will do
};

/// The nodes of one channel: [altitude][turbidity][sun], every axis ascending.
struct BranchGrid {
  std::array<std::size_t, 3> sizes{};
  std::vector<double> sun_zeniths_rad;        ///< of the last axis
  std::vector<std::vector<Branch>> branches;  ///< [node], least cost first
  /// How far ln F of a half may lie from between its rows anywhere, if it is to be the sky of some
  /// conditions.
  double limit = 1.0;
};

struct ChosenBranches {
  std::vector<std::size_t> branch;      ///< [node]
  std::vector<bool> beside_impossible;  ///< [node] a half with a neighbour is the sky of no conditions
};

/// The branch of every node for which all halves of neighbours together lie best: line after line of the grid
/// is settled at once, exactly, the others standing still, until nothing moves.
ChosenBranches choose_branches(const BranchGrid& grid);

}  // namespace skylut::table_detail
