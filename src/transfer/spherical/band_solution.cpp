#include "band_solution.hpp"

#include <algorithm>
#include <cmath>

#include "../geometry/scattering_rotation.hpp"
#include "ray_sources.hpp"
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
         static_cast<std::size_t>(view.sun_nodes * (view.moments + 2 * view.polarised.moments)) *
         static_cast<std::size_t>(lanes) * sizeof(float);
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
                                      (work.options.discretisation.sun_bands ? kBandTolerance : 1.0)),
      .cancelled =
          [](const void* token) { return static_cast<const std::stop_token*>(token)->stop_requested(); },
      .token = &context.cancel};
  block.field.reset(
      work.kernel.solve_block(block.grid->tables.view(), block.optics->view(), limits, block.iteration));
  if (block.iteration.end == IterationReport::kCancelled) throw Cancelled();
  if (!block.field)
    throw WorkError(
        "orders of scattering did not converge in {} iterations: clouds must be thinner, up to an optical "
        "depth of "
        "some 500 (thicker ones look much the same)",
        kMostIterations);
}

namespace {

int most_azimuthal_orders(std::span<const Block> blocks) {
  int orders = 0;
  for (const Block& block : blocks)
    orders = std::max(orders, block.grid->discretisation.angles.azimuthal_orders());
  return orders;
}

}  // namespace

void answer_line_of_sight(const CommonGrid& common, const LineOfSight& line, std::span<const Block> blocks,
                          bool stokes, const KeepRadiance& keep) {
  Ray ray(common.ray_space(), line.observer_km, line.view_zenith_deg, line.pairs,
          most_azimuthal_orders(blocks));
  std::vector<float> rotation;
  for (const SunAzimuth& pair : line.pairs) {
    const ScatteringRotation of_pair =
        scattering_rotation(line.view_zenith_deg, pair.relative_azimuth_deg,
                            common.slant_depth.apparent_sun_deg(line.observer_km, pair.sun_zenith_deg));
    rotation.push_back(static_cast<float>(of_pair.q));
    rotation.push_back(static_cast<float>(of_pair.u));
  }
  std::vector<float> radiance;
  for (const std::span<const Block> run : by_grid(blocks)) {
    const RaySources sources(run.front().grid->discretisation, ray, stokes);
    for (const Block& block : run) {
      const BlockOptics& optics = *block.optics;
      radiance.resize((stokes ? 3 : 1) * line.pairs.size() * static_cast<std::size_t>(optics.lanes));
      const std::vector<float> f12 = stokes ? optics.polarising_phases(ray) : std::vector<float>{};
      const PolarisedScattering polarised{f12.data(), rotation.data()};
      block.field->line_of_sight(ray.view(), sources.view(), optics.phases(ray).data(),
                                 optics.peaks(ray).data(), stokes ? &polarised : nullptr, radiance.data());
      keep(block, radiance);
    }
  }
}

void answer_in_parts(const CommonGrid& common, std::span<const LineOfSight> lines,
                     std::span<const Block> blocks, bool stokes, const KeepParts& keep) {
  std::vector<std::unique_ptr<Ray>> traced;
  std::vector<RayView> rays;
  for (const LineOfSight& line : lines) {
    traced.push_back(std::make_unique<Ray>(common.ray_space(), line.observer_km, line.view_zenith_deg,
                                           line.pairs, most_azimuthal_orders(blocks)));
    rays.push_back(traced.back()->view());
  }
  std::vector<std::vector<float>> parts(lines.size());
  for (const std::span<const Block> run : by_grid(blocks)) {
    std::vector<std::unique_ptr<RaySources>> sources;
    std::vector<RaySourcesView> views;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      sources.push_back(std::make_unique<RaySources>(run.front().grid->discretisation, *traced[i], stokes));
      views.push_back(sources.back()->view());
    }
    for (const Block& block : run) {
      const BlockOptics& optics = *block.optics;
      std::vector<float*> to;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        parts[i].resize((3 * static_cast<std::size_t>(optics.scatterers) + (stokes ? 3 : 1)) *
                        lines[i].pairs.size() * static_cast<std::size_t>(optics.lanes));
        to.push_back(parts[i].data());
      }
      block.field->parts_of_sights(static_cast<int>(lines.size()), rays.data(), views.data(), to.data());
      for (std::size_t i = 0; i < lines.size(); ++i) keep(i, block, parts[i]);
    }
  }
}

}  // namespace skylut::transfer
