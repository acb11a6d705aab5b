#include "skylut/transfer/sky_radiance.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>

#include "spherical/block.hpp"
#include "spherical/block_optics.hpp"
#include "spherical/discretisation.hpp"
#include "spherical/kernel_problem.hpp"
#include "spherical/ray_geometry.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"

namespace skylut {

namespace {

using namespace transfer;

constexpr double kLargestSunZenith_deg = 96.0;

void check(const Shells& shells, std::span<const OpticalColumn> columns, const SkyRequest& request) {
  const std::vector<double>& levels = shells.levels_km;
  if (levels.size() < 2 || levels.front() != 0.0)
    throw InputError("levels_km: needs at least two levels, the first at 0");
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (!(levels[i] > levels[i - 1]))
      throw InputError("levels_km: {} after {}, must ascend", levels[i], levels[i - 1]);
  if (levels.size() > 250) throw InputError("levels_km: {} levels, at most 250", levels.size());
  if (!(shells.planet_radius_km >= 100.0 && std::isfinite(shells.planet_radius_km)))
    throw InputError("planet_radius_km {}: must be at least 100", shells.planet_radius_km);
  for (const OpticalColumn& column : columns) {
    if (column.extinction_depth.size() + 1 != levels.size())
      throw InputError("optical column with {} layers: the levels give {}", column.extinction_depth.size(),
                       levels.size() - 1);
    if (!(column.ground_albedo >= 0.0 && column.ground_albedo <= 1.0))
      throw InputError("ground albedo {}: must lie within 0-1", column.ground_albedo);
  }
  for (const double altitude : request.observer_altitudes_km)
    if (!(altitude >= 0.0 && altitude <= levels.back()))
      throw InputError("observer altitude {} km: must lie within the layers, 0-{} km", altitude,
                       levels.back());
  for (const double sun : request.sun_zeniths_deg)
    if (!(sun >= 0.0 && sun <= kLargestSunZenith_deg))
      throw InputError("sun zenith {} deg: must lie within 0-{}", sun, kLargestSunZenith_deg);
  for (const RelativeView& view : request.views)
    if (!(view.zenith_deg >= 0.0 && view.zenith_deg <= 180.0 && view.relative_azimuth_deg >= 0.0 &&
          view.relative_azimuth_deg <= 180.0))
      throw InputError("view zenith {} deg, relative azimuth {} deg: must lie within 0-180", view.zenith_deg,
                       view.relative_azimuth_deg);
}

/// A line of sight wanted by the request: all views that share observer and zenith angle.
struct WantedRay {
  std::size_t observer;
  double view_zenith_deg;
  std::vector<std::size_t> views;  ///< indices into the request
};

std::vector<WantedRay> wanted_rays(const SkyRequest& request) {
  std::vector<std::size_t> order(request.views.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return request.views[a] < request.views[b]; });
  std::vector<WantedRay> rays;
  for (std::size_t observer = 0; observer < request.observer_altitudes_km.size(); ++observer)
    for (std::size_t i = 0; i < order.size(); ++i) {
      const double zenith = request.views[order[i]].zenith_deg;
      if (i == 0 || zenith != request.views[order[i - 1]].zenith_deg) rays.push_back({observer, zenith, {}});
      rays.back().views.push_back(order[i]);
    }
  return rays;
}

/// Columns with one discretisation, and their lines of sight.
struct Group {
  Discretisation grid;
  SweepTables tables;
  std::vector<std::size_t> columns;

  Group(const Shells& shells, const DiscretisationKey& key, Quality quality)
      : grid(shells, key, quality), tables(grid) {}
};

/// The lines of sight of one block: builds each ray's geometry when the kernel comes to it.
class BlockRays : public RayQueue {
 public:
  BlockRays(const Group& group, const BlockOptics& optics, std::span<const std::size_t> columns,
            const SkyRequest& request, const std::vector<WantedRay>& wanted, SkyRadiance& result)
      : group_(group),
        optics_(optics),
        columns_(columns),
        request_(request),
        wanted_(wanted),
        result_(result) {}

  int rays() const override { return static_cast<int>(wanted_.size()); }
  int most_segments() const override {
    // A ray crosses every sublayer at most twice, and splits none into more than this.
    return 2 * group_.tables.view().sublayers + 8192;
  }
  int most_pairs() const override {
    std::size_t most = 0;
    for (const WantedRay& ray : wanted_)
      most = std::max(most, ray.views.size() * request_.sun_zeniths_deg.size());
    return static_cast<int>(most);
  }
  RayView ray(int index) override {
    const WantedRay& wanted = wanted_[static_cast<std::size_t>(index)];
    pairs_.clear();
    for (const double sun : request_.sun_zeniths_deg)
      for (const std::size_t view : wanted.views)
        pairs_.push_back({sun, request_.views[view].relative_azimuth_deg});
    geometry_ = std::make_unique<RayGeometry>(group_.grid, request_.observer_altitudes_km[wanted.observer],
                                              wanted.view_zenith_deg, pairs_);
    return geometry_->view(group_.grid, optics_, phase_);
  }
  void store(int index, const float* radiance) override {
    const WantedRay& wanted = wanted_[static_cast<std::size_t>(index)];
    const auto lanes = static_cast<std::size_t>(optics_.lanes);
    for (std::size_t sun = 0; sun < request_.sun_zeniths_deg.size(); ++sun)
      for (std::size_t view = 0; view < wanted.views.size(); ++view, radiance += lanes)
        for (std::size_t lane = 0; lane < columns_.size(); ++lane)
          result_.at(columns_[lane], wanted.observer, sun, wanted.views[view]) = radiance[lane];
  }

 private:
  const Group& group_;
  const BlockOptics& optics_;
  std::span<const std::size_t> columns_;
  const SkyRequest& request_;
  const std::vector<WantedRay>& wanted_;
  SkyRadiance& result_;
  std::vector<SunAzimuth> pairs_;
  std::unique_ptr<RayGeometry> geometry_;
  std::vector<float> phase_;
};

/// Groups the columns by discretisation, in order of first appearance.
std::vector<std::unique_ptr<Group>> group_columns(const Shells& shells,
                                                  std::span<const OpticalColumn> columns, Quality quality) {
  std::vector<DiscretisationKey> keys;
  std::vector<std::unique_ptr<Group>> groups;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const DiscretisationKey key = discretisation_for(shells, columns[column], quality);
    const auto known = std::find(keys.begin(), keys.end(), key);
    const auto at = static_cast<std::size_t>(known - keys.begin());
    if (known == keys.end()) {
      keys.push_back(key);
      groups.push_back(std::make_unique<Group>(shells, key, quality));
    }
    groups[at]->columns.push_back(column);
  }
  return groups;
}

}  // namespace

SkyRadiance solve_sky_radiance(const Shells& shells, std::span<const OpticalColumn> columns,
                               const SkyRequest& request, const TransferOptions& options) {
  check(shells, columns, request);
  SkyRadiance result(columns.size(), request.observer_altitudes_km.size(), request.sun_zeniths_deg.size(),
                     request.views.size());
  const std::vector<WantedRay> rays = wanted_rays(request);
  const auto groups = group_columns(shells, columns, options.quality);
  const Kernel& kernel = best_kernel();

  struct Block {
    const Group* group;
    std::span<const std::size_t> columns;
  };
  std::vector<Block> blocks;
  const auto lanes = static_cast<std::size_t>(kernel.lanes);
  for (const auto& group : groups)
    for (std::size_t first = 0; first < group->columns.size(); first += lanes)
      blocks.push_back(
          {group.get(),
           std::span(group->columns).subspan(first, std::min(lanes, group->columns.size() - first))});

  std::mutex progress_lock;
  std::size_t done = 0;
  parallel_for(blocks.size(), options.threads, [&](std::size_t index) {
    const Block& block = blocks[index];
    std::vector<const OpticalColumn*> of_block;
    for (const std::size_t column : block.columns) of_block.push_back(&columns[column]);
    const BlockOptics optics(block.group->grid, of_block, kernel.lanes);
    const OpticsView view{optics.scatterers, optics.extinction_per_km.data(), optics.source_factor.data(),
                          optics.scattering_per_km.data(), optics.ground_albedo.data()};
    BlockRays queue(*block.group, optics, block.columns, request, rays, result);
    const IterationLimits limits{options.orders, 200, static_cast<float>(block.group->grid.limits.tolerance)};
    if (!kernel.run_block(block.group->tables.view(), view, limits, queue))
      throw WorkError("orders of scattering did not converge in {} iterations", limits.max_iterations);
    if (options.progress) {
      const std::scoped_lock lock(progress_lock);
      options.progress(++done, blocks.size());
    }
  });
  return result;
}

}  // namespace skylut
