#include "band_solution.hpp"

#include <algorithm>
#include <cmath>

#include "diffuse_ray.hpp"
#include "local_sun.hpp"
#include "ray_geometry.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"

namespace skylut::transfer {

namespace {

constexpr int kMostIterations = 200;
/// Of the tolerance, where suns are solved in bands: low suns converge last, and take the others along where
/// all are solved together.
constexpr double kBandTolerance = 0.5;

/// Runs of blocks that share a grid.
std::vector<std::span<const Block>> by_grid(std::span<const Block> blocks) {
  std::vector<std::span<const Block>> runs;
  for (std::size_t first = 0, last; first < blocks.size(); first = last) {
    for (last = first + 1; last < blocks.size() && blocks[last].grid == blocks[first].grid;) ++last;
    runs.push_back(blocks.subspan(first, last - first));
  }
  return runs;
}

}  // namespace

std::size_t Block::field_bytes(int lanes) const {
  const SweepView& view = grid->tables.view();
  return static_cast<std::size_t>(view.sublayers + 1) *
         static_cast<std::size_t>(view.sun_nodes * view.moments) * static_cast<std::size_t>(lanes) *
         sizeof(float);
}

BandSolution::BandSolution(const Work& work, const std::vector<ColumnGroup>& groups, const SunBand& band)
    : common_(work.shells, work.options.discretisation, band.nodes_deg) {
  const auto width = static_cast<std::size_t>(work.kernel.lanes);
  for (const ColumnGroup& group : groups) {
    grids_.push_back(std::make_unique<Grid>(common_, group.key));
    const std::span<const std::size_t> columns = group.columns;
    for (std::size_t first = 0; first < columns.size(); first += width)
      blocks_.push_back({.grid = grids_.back().get(),
                         .columns = columns.subspan(first, std::min(width, columns.size() - first)),
                         .optics = nullptr,
                         .field = nullptr,
                         .iteration = {}});
  }
}

void BandSolution::add_to(TransferReport& report) const {
  report.blocks += blocks_.size();
  for (const Block& block : blocks_) {
    report.iterations_most = std::max(report.iterations_most, block.iteration.iterations);
    report.error_left = std::max(report.error_left, static_cast<double>(block.iteration.error_left));
  }
}

void solve_field(const Context& context, const Work& work, Block& block) {
  std::vector<const OpticalColumn*> lanes;
  for (const std::size_t column : block.columns) lanes.push_back(&work.columns[column]);
  block.optics = std::make_unique<BlockOptics>(block.grid->discretisation, lanes, work.kernel.lanes,
                                               work.options.scattering_orders == 0);
  const IterationLimits limits{
      .scattering_orders = work.options.scattering_orders,
      .max_iterations = kMostIterations,
      .tolerance = static_cast<float>(work.options.discretisation.tolerance *
                                      (work.bands.size() > 1 ? kBandTolerance : 1.0)),
      .cancelled =
          [](const void* token) { return static_cast<const std::stop_token*>(token)->stop_requested(); },
      .token = &context.cancel};
  block.field.reset(
      work.kernel.solve_block(block.grid->tables.view(), block.optics->view(), limits, block.iteration));
  if (block.iteration.end == IterationReport::kCancelled) throw Cancelled();
  if (!block.field)
    throw WorkError("orders of scattering did not converge in {} iterations", kMostIterations);
}

void answer_line_of_sight(const CommonGrid& common, const LineOfSight& line, std::span<const Block> blocks,
                          Answer answer,
                          const std::function<void(const Block&, std::span<const float>)>& keep) {
  const RayGeometry geometry(common, line.observer_km, line.view_zenith_deg, line.pairs);
  const auto runs = by_grid(blocks);
  int azimuthal_orders = 0;
  for (const std::span<const Block> run : runs)
    azimuthal_orders = std::max(azimuthal_orders, run.front().grid->discretisation.angles.azimuthal_orders());
  LocalSun local_sun(common.shells.planet_radius_km, geometry.start(), line.pairs, common.sun_interpolation,
                     azimuthal_orders);
  std::vector<float> values;
  for (const std::span<const Block> run : runs) {
    const DiffuseRay diffuse(run.front().grid->discretisation, line.observer_km, line.view_zenith_deg,
                             local_sun);
    for (const Block& block : run) {
      const BlockOptics& optics = *block.optics;
      const std::size_t parts =
          answer == Answer::radiance ? 1 : 3 * static_cast<std::size_t>(optics.scatterers) + 1;
      values.resize(parts * line.pairs.size() * static_cast<std::size_t>(optics.lanes));
      if (answer == Answer::radiance)
        block.field->line_of_sight(geometry.view(), diffuse.view(), geometry.phases(optics).data(),
                                   geometry.peaks(optics).data(), values.data());
      else
        block.field->parts_of_sight(geometry.view(), diffuse.view(), values.data());
      keep(block, values);
    }
  }
}

}  // namespace skylut::transfer
