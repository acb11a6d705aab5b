#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "block_optics.hpp"
#include "column_groups.hpp"
#include "discretisation.hpp"
#include "kernel_problem.hpp"
#include "lines_of_sight.hpp"
#include "sweep_tables.hpp"
#include "work_estimate.hpp"

namespace skylut {
struct Context;
}

namespace skylut::transfer {

/// A discretisation, as geometry and as the kernels see it.
struct Grid {
  Discretisation discretisation;
  SweepTables tables;

  Grid(const CommonGrid& common, const DiscretisationKey& key)
      : discretisation(common, key), tables(discretisation) {}
};

/// As many columns of one discretisation as the kernel has lanes.
struct Block {
  const Grid* grid;
  std::span<const std::size_t> columns;
  std::unique_ptr<BlockOptics> optics;
  std::unique_ptr<SolvedBlock> field;  ///< null before it is solved
  IterationReport iteration;

  std::size_t field_bytes(int lanes) const;
};

/// All columns under the suns of one band: columns that want the same grids share their geometry, and blocks
/// of them share the lanes of a register.
class BandSolution {
 public:
  /// @param groups  must outlive this object
  BandSolution(const Work& work, const std::vector<ColumnGroup>& groups, const SunBand& band);
  BandSolution(const BandSolution&) = delete;
  BandSolution& operator=(const BandSolution&) = delete;

  const CommonGrid& common() const { return common_; }
  std::span<Block> blocks() { return blocks_; }
  std::span<const Block> blocks() const { return blocks_; }

  /// How its blocks were solved.
  void add_to(TransferReport& report) const;

 private:
  CommonGrid common_;
  std::vector<std::unique_ptr<Grid>> grids_;
  std::vector<Block> blocks_;
};

/// Solves the diffuse field of a block of columns.
/// @throws WorkError  when the orders of scattering do not converge
/// @throws Cancelled  when the context asks to stop
void solve_field(const Context& context, const Work& work, Block& block);

/// Takes what one block's columns show along a line of sight.
using KeepRadiance = std::function<void(const Block& block, std::span<const float> radiance)>;
using KeepParts = std::function<void(std::size_t line, const Block& block, std::span<const float> parts)>;

/// Radiances along one line of sight from solved blocks.
/// @param stokes  whether Q and U are wanted, too
/// @param keep    gets them [I, then Q and U][pair][lane], block by block
void answer_line_of_sight(const CommonGrid& common, const LineOfSight& line, std::span<const Block> blocks,
                          bool stokes, const KeepRadiance& keep);

/// The radiances' parts along several lines of sight. @param keep  gets them as SolvedBlock::parts_of_sights
/// gives them, block by block and line by line
void answer_in_parts(const CommonGrid& common, std::span<const LineOfSight> lines,
                     std::span<const Block> blocks, bool stokes, const KeepParts& keep);

}  // namespace skylut::transfer
