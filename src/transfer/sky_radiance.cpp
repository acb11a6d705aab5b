#include "skylut/transfer/sky_radiance.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <mutex>
#include <new>
#include <thread>

#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/transfer/transfer_cost.hpp"
#include "spherical/block_optics.hpp"
#include "spherical/column_groups.hpp"
#include "spherical/diffuse_ray.hpp"
#include "spherical/discretisation.hpp"
#include "spherical/kernel_choice.hpp"
#include "spherical/lines_of_sight.hpp"
#include "spherical/ray_geometry.hpp"
#include "spherical/request_check.hpp"
#include "spherical/sweep_tables.hpp"
#include "spherical/work_estimate.hpp"

namespace skylut {

namespace {

using namespace transfer;

constexpr int kMostIterations = 200;

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
  std::unique_ptr<SolvedBlock> field;
  IterationReport iteration;

  std::size_t field_bytes(int lanes) const {
    const SweepView& view = grid->tables.view();
    return static_cast<std::size_t>(view.sublayers + 1) *
           static_cast<std::size_t>(view.sun_nodes * view.moments) * static_cast<std::size_t>(lanes) *
           sizeof(float);
  }
};

std::vector<Block> fill_blocks(const std::vector<ColumnGroup>& groups,
                               const std::vector<std::unique_ptr<Grid>>& grids, int lanes) {
  std::vector<Block> blocks;
  const auto width = static_cast<std::size_t>(lanes);
  for (std::size_t group = 0; group < groups.size(); ++group) {
    const std::span<const std::size_t> columns = groups[group].columns;
    for (std::size_t first = 0; first < columns.size(); first += width)
      blocks.push_back({.grid = grids[group].get(),
                        .columns = columns.subspan(first, std::min(width, columns.size() - first)),
                        .optics = nullptr,
                        .field = nullptr,
                        .iteration = {}});
  }
  return blocks;
}

/// Solves the diffuse field of a block of columns.
void solve_field(const Context& context, const Kernel& kernel, std::span<const OpticalColumn> columns,
                 const TransferOptions& options, Block& block) {
  std::vector<const OpticalColumn*> lanes;
  for (const std::size_t column : block.columns) lanes.push_back(&columns[column]);
  block.optics = std::make_unique<BlockOptics>(block.grid->discretisation, lanes, kernel.lanes,
                                               options.scattering_orders == 0);
  const IterationLimits limits{
      .scattering_orders = options.scattering_orders,
      .max_iterations = kMostIterations,
      .tolerance = static_cast<float>(options.discretisation.tolerance),
      .cancelled =
          [](const void* token) { return static_cast<const std::stop_token*>(token)->stop_requested(); },
      .token = &context.cancel};
  block.field.reset(
      kernel.solve_block(block.grid->tables.view(), block.optics->view(), limits, block.iteration));
  if (block.iteration.end == IterationReport::kCancelled) throw Cancelled();
  if (!block.field)
    throw WorkError("orders of scattering did not converge in {} iterations", kMostIterations);
}

/// Runs of blocks that share a grid.
std::vector<std::span<const Block>> by_grid(std::span<const Block> blocks) {
  std::vector<std::span<const Block>> runs;
  for (std::size_t first = 0, last; first < blocks.size(); first = last) {
    for (last = first + 1; last < blocks.size() && blocks[last].grid == blocks[first].grid;) ++last;
    runs.push_back(blocks.subspan(first, last - first));
  }
  return runs;
}

/// Radiances along one line of sight for all blocks.
void solve_line_of_sight(const CommonGrid& common, const LineOfSight& line, std::span<const Block> blocks,
                         const SkyRequest& request, SkyRadiance& result) {
  const double observer_km = request.observer_altitudes_km[line.observer];
  const std::vector<SunAzimuth> pairs = line.pairs(request);
  const RayGeometry geometry(common, observer_km, line.view_zenith_deg, pairs);
  const auto runs = by_grid(blocks);
  int azimuthal_orders = 0;
  for (const std::span<const Block> run : runs)
    azimuthal_orders = std::max(azimuthal_orders, run.front().grid->discretisation.angles.azimuthal_orders());
  LocalSun local_sun(common.shells.planet_radius_km, geometry.start(), pairs, common.sun_interpolation,
                     azimuthal_orders);
  std::vector<float> radiance;
  for (const std::span<const Block> run : runs) {
    const DiffuseRay diffuse(run.front().grid->discretisation, observer_km, line.view_zenith_deg, local_sun);
    for (const Block& block : run) {
      const auto lanes = static_cast<std::size_t>(block.optics->lanes);
      radiance.resize(pairs.size() * lanes);
      block.field->line_of_sight(geometry.view(), diffuse.view(), geometry.phases(*block.optics).data(),
                                 geometry.peaks(*block.optics).data(), radiance.data());
      for (std::size_t pair = 0; pair < pairs.size(); ++pair)
        for (std::size_t lane = 0; lane < block.columns.size(); ++lane) {
          const float found = radiance[pair * lanes + lane];
          if (!std::isfinite(found))
            throw WorkError("radiance of column {} is not a number: do its phase functions hold one?",
                            block.columns[lane]);
          result.at(block.columns[lane], line.observer, pair / line.views.size(),
                    line.views[pair % line.views.size()]) = found;
        }
    }
  }
}

double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

int threads_of(const Context& context) {
  if (context.threads > 0) return context.threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Runs tasks in parallel, counts their CPU time, tells how much is done and stops when asked to.
class Progress {
 public:
  Progress(const Context& context, std::size_t steps) : context_(context), steps_(steps) {}

  template <typename Task>
  void run(std::size_t count, std::size_t steps_each, const Task& task) {
    parallel_for(count, context_.threads, [&](std::size_t index) {
      if (context_.cancel.stop_requested()) throw Cancelled();
      const double start_s = thread_cpu_s();
      task(index);
      const std::scoped_lock lock(lock_);
      cpu_s_ += thread_cpu_s() - start_s;
      done_ += steps_each;
      if (context_.progress) context_.progress("solving the radiative transfer", done_, steps_);
    });
  }

  double cpu_s() const { return cpu_s_; }

 private:
  const Context& context_;
  std::size_t steps_;
  std::mutex lock_;
  std::size_t done_ = 0;
  double cpu_s_ = 0.0;
};

SkyRadiance solve(const Context& context, const Work& work, const std::vector<ColumnGroup>& groups,
                  const std::vector<LineOfSight>& lines) {
  const SkyRequest& request = work.request;
  SkyRadiance result(work.columns.size(), request.observer_altitudes_km.size(),
                     request.sun_zeniths_deg.size(), request.views.size());

  // 1. Columns that want the same grids share their geometry; blocks of them share a SIMD register.
  const CommonGrid common(work.shells, work.options.discretisation);
  std::vector<std::unique_ptr<Grid>> grids;
  for (const ColumnGroup& group : groups) grids.push_back(std::make_unique<Grid>(common, group.key));
  std::vector<Block> blocks = fill_blocks(groups, grids, work.kernel.lanes);

  Progress progress(context, blocks.size() * (1 + lines.size()));
  for (std::size_t first = 0, last; first < blocks.size(); first = last) {
    std::size_t bytes = 0;
    for (last = first; last < blocks.size() && (last == first || bytes < kKeptFields_bytes); ++last)
      bytes += blocks[last].field_bytes(work.kernel.lanes);
    const std::span batch = std::span(blocks).subspan(first, last - first);

    // 2. Multiple scattering: the diffuse field everywhere under every sun, block by block.
    progress.run(batch.size(), 1, [&](std::size_t index) {
      solve_field(context, work.kernel, work.columns, work.options, batch[index]);
    });

    // 3. Lines of sight through it, with the sun's single scattering exactly.
    progress.run(lines.size(), batch.size(), [&](std::size_t index) {
      solve_line_of_sight(common, lines[index], batch, request, result);
    });
    for (Block& block : batch) block.field.reset();
  }

  TransferReport& report = result.report();
  report.kernel = work.kernel.name;
  report.lanes = work.kernel.lanes;
  report.blocks = blocks.size();
  report.cpu_s = progress.cpu_s();
  for (const Block& block : blocks) {
    report.iterations_most = std::max(report.iterations_most, block.iteration.iterations);
    report.error_left = std::max(report.error_left, static_cast<double>(block.iteration.error_left));
  }
  return result;
}

}  // namespace

TransferCost estimate_cost(const Context& context, const Shells& shells,
                           std::span<const OpticalColumn> columns, const SkyRequest& request,
                           const TransferOptions& options) {
  check_request(shells, columns, request, options);
  const LayerMerge merge(shells, !options.discretisation.merge_layers);
  const Work work{shells, merge, columns, request, options, kernel_for(context.simd), threads_of(context)};
  return estimate(work, group_columns(merge, options.discretisation, columns), lines_of_sight(request));
}

SkyRadiance solve_sky_radiance(const Context& context, const Shells& shells,
                               std::span<const OpticalColumn> columns, const SkyRequest& request,
                               const TransferOptions& options) {
  check_request(shells, columns, request, options);
  const LayerMerge merge(shells, !options.discretisation.merge_layers);
  const Work work{shells, merge, columns, request, options, kernel_for(context.simd), threads_of(context)};
  const std::vector<ColumnGroup> groups = group_columns(merge, options.discretisation, columns);
  const std::vector<LineOfSight> lines = lines_of_sight(request);
  const TransferCost cost = estimate(work, groups, lines);
  refuse_too_much(work, cost);
  try {
    return solve(context, work, groups, lines);
  } catch (const std::bad_alloc&) {
    throw WorkError("radiative transfer ran out of memory: about {:.3g} GB were expected to be enough",
                    cost.memory_bytes() / 1e9);
  }
}

}  // namespace skylut
