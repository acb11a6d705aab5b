#include "skylut/transfer/sky_radiance.hpp"

#include <algorithm>
#include <memory>
#include <mutex>

#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "spherical/block_optics.hpp"
#include "spherical/diffuse_ray.hpp"
#include "spherical/discretisation.hpp"
#include "spherical/kernel_problem.hpp"
#include "spherical/ray_geometry.hpp"
#include "spherical/request_check.hpp"
#include "spherical/sweep_tables.hpp"
#include "spherical/wanted_rays.hpp"

namespace skylut {

namespace {

using namespace transfer;

constexpr int kMostIterations = 200;

/// Diffuse fields kept at a time; a field of the default table takes 7 MB.
constexpr std::size_t kFieldMemory_bytes = std::size_t{256} << 20;

/// Columns that share a discretisation.
struct Group {
  Discretisation grid;
  SweepTables tables;
  std::vector<std::size_t> columns;

  Group(const Medium& medium, const DiscretisationKey& key) : grid(medium, key), tables(grid) {}
};

/// As many columns of a group as the kernel has lanes.
struct Block {
  const Group* group;
  std::span<const std::size_t> columns;
  std::unique_ptr<BlockOptics> optics;
  std::unique_ptr<SolvedBlock> field;

  std::size_t field_bytes(int lanes) const {
    const SweepView& view = group->tables.view();
    return static_cast<std::size_t>(view.sublayers + 1) *
           static_cast<std::size_t>(view.sun_nodes * view.moments) * static_cast<std::size_t>(lanes) *
           sizeof(float);
  }
};

/// Groups in order of first appearance.
std::vector<std::unique_ptr<Group>> group_columns(const Medium& medium,
                                                  std::span<const OpticalColumn> columns) {
  std::vector<DiscretisationKey> keys;
  std::vector<std::unique_ptr<Group>> groups;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const DiscretisationKey key = discretisation_for(medium, columns[column]);
    const auto known = std::find(keys.begin(), keys.end(), key);
    const auto at = static_cast<std::size_t>(known - keys.begin());
    if (known == keys.end()) {
      keys.push_back(key);
      groups.push_back(std::make_unique<Group>(medium, key));
    }
    groups[at]->columns.push_back(column);
  }
  return groups;
}

std::vector<Block> fill_blocks(const std::vector<std::unique_ptr<Group>>& groups, int lanes) {
  std::vector<Block> blocks;
  const auto width = static_cast<std::size_t>(lanes);
  for (const auto& group : groups)
    for (std::size_t first = 0; first < group->columns.size(); first += width) {
      const std::size_t size = std::min(width, group->columns.size() - first);
      blocks.push_back({group.get(), std::span(group->columns).subspan(first, size), nullptr, nullptr});
    }
  return blocks;
}

void solve_field(Block& block, std::span<const OpticalColumn> columns, const Kernel& kernel, int orders) {
  std::vector<const OpticalColumn*> lanes;
  for (const std::size_t column : block.columns) lanes.push_back(&columns[column]);
  block.optics = std::make_unique<BlockOptics>(block.group->grid, lanes, kernel.lanes, orders == 0);
  const IterationLimits limits{orders, kMostIterations,
                               static_cast<float>(block.group->grid.medium.limits.tolerance)};
  block.field.reset(kernel.solve_block(block.group->tables.view(), block.optics->view(), limits));
  if (!block.field)
    throw WorkError("orders of scattering did not converge in {} iterations", kMostIterations);
}

/// Runs of blocks that belong to one group.
std::vector<std::span<const Block>> by_group(std::span<const Block> blocks) {
  std::vector<std::span<const Block>> runs;
  for (std::size_t first = 0, last; first < blocks.size(); first = last) {
    for (last = first + 1; last < blocks.size() && blocks[last].group == blocks[first].group;) ++last;
    runs.push_back(blocks.subspan(first, last - first));
  }
  return runs;
}

/// Radiances of one line of sight for all blocks.
void answer_ray(const Medium& medium, const WantedRay& ray, std::span<const Block> blocks,
                const SkyRequest& request, SkyRadiance& result) {
  const double observer_km = request.observer_altitudes_km[ray.observer];
  const std::vector<SunAzimuth> pairs = ray.pairs(request);
  const RayGeometry geometry(medium, observer_km, ray.view_zenith_deg, pairs);
  const auto runs = by_group(blocks);
  int orders = 0;
  for (const std::span<const Block> run : runs)
    orders = std::max(orders, run.front().group->grid.angles.azimuthal_orders());
  LocalSun local_sun(medium.shells.planet_radius_km, geometry.start(), pairs, medium.sun_interpolation,
                     orders);
  std::vector<float> radiance;
  for (const std::span<const Block> run : runs) {
    const DiffuseRay diffuse(run.front().group->grid, observer_km, ray.view_zenith_deg, local_sun);
    for (const Block& block : run) {
      const auto lanes = static_cast<std::size_t>(block.optics->lanes);
      radiance.resize(pairs.size() * lanes);
      block.field->line_of_sight(geometry.view(), diffuse.view(), geometry.phases(*block.optics).data(),
                                 geometry.peaks(*block.optics).data(), radiance.data());
      for (std::size_t pair = 0; pair < pairs.size(); ++pair)
        for (std::size_t lane = 0; lane < block.columns.size(); ++lane)
          result.at(block.columns[lane], ray.observer, pair / ray.views.size(),
                    ray.views[pair % ray.views.size()]) = radiance[pair * lanes + lane];
    }
  }
}

}  // namespace

SkyRadiance solve_sky_radiance(const Shells& shells, std::span<const OpticalColumn> columns,
                               const SkyRequest& request, const TransferOptions& options) {
  check_request(shells, columns, request);
  SkyRadiance result(columns.size(), request.observer_altitudes_km.size(), request.sun_zeniths_deg.size(),
                     request.views.size());

  // 1. Columns that want the same grids share their geometry; blocks of them share a SIMD register.
  const Kernel& kernel = best_kernel();
  const Medium medium(shells, options.limits);
  const auto groups = group_columns(medium, columns);
  std::vector<Block> blocks = fill_blocks(groups, kernel.lanes);
  const std::vector<WantedRay> rays = wanted_rays(request);

  std::mutex progress_lock;
  std::size_t steps_done = 0;
  const std::size_t steps = blocks.size() * (1 + rays.size());
  const auto report = [&](std::size_t more) {
    if (!options.progress) return;
    const std::scoped_lock lock(progress_lock);
    options.progress(steps_done += more, steps);
  };

  for (std::size_t first = 0, last; first < blocks.size(); first = last) {
    std::size_t bytes = 0;
    for (last = first; last < blocks.size() && (last == first || bytes < kFieldMemory_bytes); ++last)
      bytes += blocks[last].field_bytes(kernel.lanes);
    const std::span batch = std::span(blocks).subspan(first, last - first);

    // 2. Multiple scattering: the diffuse field everywhere under every sun, block by block.
    parallel_for(batch.size(), options.threads, [&](std::size_t index) {
      solve_field(batch[index], columns, kernel, options.orders);
      report(1);
    });

    // 3. Lines of sight through it, with the sun's single scattering exactly.
    parallel_for(rays.size(), options.threads, [&](std::size_t index) {
      answer_ray(medium, rays[index], batch, request, result);
      report(batch.size());
    });
    for (Block& block : batch) block.field.reset();
  }
  return result;
}

}  // namespace skylut
