#include "skylut/transfer/sky_radiance.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/transfer/transfer_cost.hpp"
#include "spherical/band_solution.hpp"
#include "spherical/kernel_choice.hpp"
#include "spherical/request_check.hpp"
#include "spherical/work_progress.hpp"

namespace skylut {

namespace {

using namespace transfer;

/// Puts the radiances of one line of sight where they belong.
void keep_radiances(const LineOfSight& line, const Block& block, std::span<const float> radiance,
                    SkyRadiance& result) {
  const auto lanes = static_cast<std::size_t>(block.optics->lanes);
  for (std::size_t pair = 0; pair < line.pairs.size(); ++pair)
    for (std::size_t lane = 0; lane < block.columns.size(); ++lane) {
      const float found = radiance[pair * lanes + lane];
      if (!std::isfinite(found))
        throw WorkError("radiance of column {} is not a number: do its phase functions hold one?",
                        block.columns[lane]);
      result.at(block.columns[lane], line.sights[pair]) = found;
      if (!result.has_stokes()) continue;
      const std::size_t next = line.pairs.size() * lanes;
      result.stokes_q(block.columns[lane], line.sights[pair]) = radiance[next + pair * lanes + lane];
      result.stokes_u(block.columns[lane], line.sights[pair]) = radiance[2 * next + pair * lanes + lane];
    }
}

/// Every block is solved once and answers every line of its band.
std::size_t steps_of(const Work& work, const std::vector<ColumnGroup>& groups,
                     const std::vector<std::vector<LineOfSight>>& lines) {
  const auto lanes = static_cast<std::size_t>(work.kernel.lanes);
  std::size_t blocks = 0;
  for (const ColumnGroup& group : groups) blocks += (group.columns.size() + lanes - 1) / lanes;
  std::size_t steps = 0;
  for (const std::vector<LineOfSight>& own : lines)
    if (!own.empty()) steps += blocks * (1 + own.size());
  return steps;
}

SkyRadiance solve(const Context& context, const Work& work, const std::vector<ColumnGroup>& groups,
                  const std::vector<std::vector<LineOfSight>>& lines) {
  SkyRadiance result(work.columns.size(), work.sights, work.options.stokes);
  TransferReport& report = result.report();
  WorkProgress progress(context, steps_of(work, groups, lines));
  for (std::size_t band = 0; band < work.bands.size(); ++band) {
    if (lines[band].empty()) continue;
    // 1. The grids of these suns, and the columns in blocks.
    BandSolution solution(work, groups, work.bands[band]);
    const std::span<Block> blocks = solution.blocks();
    for (std::size_t first = 0, last; first < blocks.size(); first = last) {
      std::size_t bytes = 0;
      for (last = first; last < blocks.size() && (last == first || bytes < kKeptFields_bytes); ++last)
        bytes += blocks[last].field_bytes(work.kernel.lanes);
      const std::span<Block> batch = blocks.subspan(first, last - first);

      // 2. Multiple scattering: the diffuse field everywhere, block by block.
      progress.run(batch.size(), 1, [&](std::size_t index) { solve_field(context, work, batch[index]); });

      // 3. Lines of sight through it, with the sun's single scattering exactly.
      progress.run(lines[band].size(), batch.size(), [&](std::size_t index) {
        const LineOfSight& line = lines[band][index];
        answer_line_of_sight(solution.common(), line, batch, work.options.stokes,
                             [&](const Block& block, std::span<const float> radiance) {
                               keep_radiances(line, block, radiance, result);
                             });
      });
      for (Block& block : batch) block.field.reset();
    }
    solution.add_to(report);
  }
  report.kernel = work.kernel.name;
  report.lanes = work.kernel.lanes;
  report.cpu_s = progress.cpu_s();
  return result;
}

}  // namespace

std::vector<Sight> SkyRequest::sights() const {
  std::vector<Sight> all;
  for (const double observer : observer_altitudes_km)
    for (const double sun : sun_zeniths_deg)
      for (const RelativeView& view : views) all.push_back({observer, sun, view});
  return all;
}

TransferCost estimate_cost(const Context& context, const Shells& shells,
                           std::span<const OpticalColumn> columns, std::span<const Sight> sights,
                           const TransferOptions& options) {
  check_request(shells, columns, sights, options);
  const Work work(context, shells, columns, sights, options);
  return estimate(work, group_columns(work.merge, options.discretisation, columns),
                  lines_of_sight(shells, work.bands, sights));
}

SkyRadiance solve_sky_radiance(const Context& context, const Shells& shells,
                               std::span<const OpticalColumn> columns, std::span<const Sight> sights,
                               const TransferOptions& options) {
  check_request(shells, columns, sights, options);
  const Work work(context, shells, columns, sights, options);
  const std::vector<ColumnGroup> groups = group_columns(work.merge, options.discretisation, columns);
  const std::vector<std::vector<LineOfSight>> lines = lines_of_sight(shells, work.bands, sights);
  const TransferCost cost = estimate(work, groups, lines);
  refuse_too_much(work, cost);
  try {
    return solve(context, work, groups, lines);
  } catch (const std::bad_alloc&) {
    throw WorkError("radiative transfer ran out of memory: about {:.3g} GB were expected to be enough",
                    cost.memory_bytes() / 1e9);
  }
}

SkyRadiance solve_sky_radiance(const Context& context, const Shells& shells,
                               std::span<const OpticalColumn> columns, const SkyRequest& request,
                               const TransferOptions& options) {
  SkyRadiance result = solve_sky_radiance(context, shells, columns, request.sights(), options);
  result.set_shape(request.sun_zeniths_deg.size(), request.views.size());
  return result;
}

}  // namespace skylut
