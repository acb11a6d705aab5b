#include "work_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>

#include "common_grid.hpp"
#include "horizon_peak.hpp"
#include "kernel_choice.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"

namespace skylut::transfer {

namespace {

/// Share of the machine's memory that is used unasked: the rest is for the caller and for what the estimate
/// leaves out.
constexpr double kShareOfMemory = 0.75;
constexpr double kMostBlock_cpu_s = 1800.0;

/// Seconds per multiplication of a register by a number; measured on 2 GHz machines with AVX2 and AVX-512.
constexpr double kMultiplication_s = 0.35e-9;

/// The iteration needs some ten rounds in clear air and more where light is scattered often before it gets
/// out, but for DiffusionCorrection.
double iterations_for(double scattering_depth) { return std::min(15.0, 9.0 + 3.0 * scattering_depth); }

double count_of(const auto& list) { return static_cast<double>(list.size()); }

/// The sizes of one discretisation, in doubles: they are asked before anybody knows that they are sane.
struct Sizes {
  double sublayers;
  double sun_nodes;
  double polar;
  double azimuths;
  double moments;
  double polarised_moments;  ///< of Q and U together
  double legendre_terms;
  double azimuthal_orders;
  double chord_nodes;
  double horizon_levels;  ///< at which the radiance of both hemispheres is kept; 0: of no column

  double directions() const { return polar * azimuths; }
};

Sizes sizes_of(const Work& work, const SunBand& band, const DiscretisationKey& key) {
  const AngularResolution& angles = key.angles;
  Sizes sizes{};
  const auto [sublayers, thickest_km] = sublayer_sizes(work.merge.shells(), key);
  sizes.sublayers = sublayers + 3.0;
  sizes.sun_nodes = count_of(band.nodes_deg);
  sizes.polar = angles.polar_nodes;
  sizes.azimuths = angles.azimuth_nodes;
  sizes.legendre_terms = angles.max_l + 1;
  sizes.azimuthal_orders = angles.max_m + 1;
  sizes.horizon_levels = key.cuts_peak ? kMostHorizonLevels : 0.0;
  for (int m = 0; m <= angles.max_m; ++m) sizes.moments += angles.max_l + 1 - m;
  for (int m = 0; m <= std::min(angles.max_m, key.polarised_degree); ++m)
    sizes.polarised_moments += 2.0 * std::max(0, key.polarised_degree + 1 - std::max(m, 2));
  // A sublayer of thickness d has chords up to the cosine √(2d/R) at its upper side; the nodes are even in
  // √μ.
  const double cosine = std::sqrt(2.0 * thickest_km / work.shells.planet_radius_km);
  sizes.chord_nodes = std::min(sizes.polar, 1.0 + std::ceil(sizes.polar * std::sqrt(std::min(1.0, cosine))));
  return sizes;
}

double stencil_bytes(const Work& work, const Sizes& sizes) {
  const double layers = count_of(work.shells.levels_km) - 1.0;
  return 2.0 * sizes.sublayers *
             (sizes.sun_nodes * sizes.directions() * sizeof(InterpolationWeights) +
              sizes.polar * sizeof(PolarStep)) +
         (2.0 * sizes.sublayers + layers + 1.0) * sizes.sun_nodes * sizeof(SlantDepthWeights);
}

/// Bytes of one number in every lane.
double lanes_bytes(const Kernel& kernel) {
  return kernel.lanes * static_cast<double>(kernel.lanes == 1 ? sizeof(double) : sizeof(float));
}

/// What stays of a block once it is solved: moments, depths towards the sun, optics, what half of the polar
/// nodes lack at the horizon.
double kept_bytes(const Work& work, const Sizes& sizes) {
  const double layers = count_of(work.shells.levels_km) - 1.0;
  const double scatterers = 2.0;
  return lanes_bytes(work.kernel) *
         ((sizes.sublayers + 1.0) * sizes.sun_nodes * (sizes.moments + sizes.polarised_moments) +
          2.0 * SlantDepthGrid::points(layers) + layers * (2.0 * sizes.legendre_terms + 4.0 + scatterers) +
          sizes.horizon_levels * sizes.sun_nodes * sizes.polar * sizes.azimuthal_orders);
}

/// What is there besides while it is solved.
double scratch_bytes(const Work& work, const Sizes& sizes) {
  const double fields = work.options.scattering_orders > 0 ? 3.0 : 1.0;
  const double stokes = sizes.polarised_moments > 0.0 ? 3.0 : 1.0;
  return lanes_bytes(work.kernel) * sizes.sun_nodes *
         ((sizes.sublayers + 1.0) *
              (fields * (sizes.moments + sizes.polarised_moments) +
               stokes * sizes.chord_nodes * sizes.azimuths + 6.0 + 2.0 * sizes.legendre_terms) +
          3.0 * stokes * sizes.directions() +
          sizes.horizon_levels * 2.0 * sizes.polar * sizes.azimuthal_orders);
}

double block_cpu_s(const Work& work, const Sizes& sizes, double scattering_depth) {
  const double transform = sizes.moments * sizes.polar +
                           sizes.polar * sizes.azimuths * 0.5 * sizes.azimuthal_orders + sizes.moments;
  const double stokes = sizes.polarised_moments > 0.0 ? 3.0 : 1.0;
  const double per_node =
      6.0 * (transform + sizes.polarised_moments * sizes.polar) + 20.0 * stokes * sizes.directions();
  const double rounds = work.options.scattering_orders > 0 ? work.options.scattering_orders - 1.0
                                                           : iterations_for(scattering_depth);
  const double width = std::max(1.0, lanes_bytes(work.kernel) / 64.0);
  return rounds * (sizes.sublayers + 1.0) * sizes.sun_nodes * per_node * kMultiplication_s * width;
}

double scattering_depth(const OpticalColumn& column) {
  double sum = 0.0;
  for (const Scatterer& scatterer : column.scatterers)
    for (const double depth : scatterer.scattering_depth) sum += depth * (1.0 - scatterer.phase->moment(1));
  return sum;
}

/// Length of a line of sight to the top of the atmosphere or the ground, km.
double length_km(const Shells& shells, double observer_km, double view_zenith_deg) {
  const double planet = shells.planet_radius_km;
  const double along = (planet + observer_km) * std::cos(view_zenith_deg * kRadiansPerDegree);
  const auto square = [&](double altitude_km) {
    return (altitude_km - observer_km) * (2.0 * planet + altitude_km + observer_km) + along * along;
  };
  if (along < 0.0 && square(0.0) >= 0.0) return -along - std::sqrt(square(0.0));
  return std::sqrt(std::max(0.0, square(shells.levels_km.back()))) - along;
}

/// Arrays of the line of sight that needs most, for one thread.
double ray_bytes(const Work& work, const std::vector<LineOfSight>& lines, const Sizes& sizes) {
  const DiscretisationOptions& options = work.options.discretisation;
  const double top_km = work.shells.levels_km.back();
  // SunlitRay cuts by the sunbeam's lowest altitude, evenly up to 16 km and by shares beyond.
  const double grazing_parts =
      (std::min(top_km, 16.0) + 16.0 * std::log(std::max(1.0, top_km / 16.0))) / options.sunbeam_step_km;
  double most = 0.0;
  for (const LineOfSight& line : lines) {
    const double points =
        2.0 * (count_of(work.shells.levels_km) + sizes.sublayers) +
        length_km(work.shells, line.observer_km, line.view_zenith_deg) / options.ray_step_km;
    const double pairs = count_of(line.pairs);
    const double per_pair = points * (sizeof(InterpolationWeights) + sizes.azimuthal_orders * sizeof(float)) +
                            (points + grazing_parts) * (sizeof(LitPart) + sizeof(SlantDepthWeights)) +
                            8.0 * lanes_bytes(work.kernel);
    most = std::max(most, pairs * per_pair + points * (sizes.moments * sizeof(float) + sizeof(RayPoint) +
                                                       sizes.legendre_terms * lanes_bytes(work.kernel)));
  }
  return most;
}

std::string amount(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.3g} GB", bytes / 1e9);
}

std::string duration(double seconds) {
  return seconds < 7200.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                          : fmt::format("{:.3g} h", seconds / 3600.0);
}

double largest_depth(std::span<const OpticalColumn> columns) {
  double largest = 0.0;
  for (const OpticalColumn& column : columns)
    largest = std::max(largest,
                       std::accumulate(column.extinction_depth.begin(), column.extinction_depth.end(), 0.0));
  return largest;
}

/// `share` of x, rounded down to two digits.
double what_fits(double x, double share) {
  const double fits = x * std::max(0.0, share);
  if (!(fits > 0.0)) return 0.0;
  const double digit = std::pow(10.0, std::floor(std::log10(fits)) - 1.0);
  return std::floor(fits / digit) * digit;
}

}  // namespace

Work::Work(const Context& context, const Shells& shells_, std::span<const OpticalColumn> columns_,
           std::span<const Sight> sights_, const TransferOptions& options_)
    : shells(shells_),
      merge(shells, !options_.discretisation.merge_layers),
      columns(columns_),
      sights(sights_.size()),
      options(options_),
      kernel(kernel_for(context.simd)),
      threads(context.threads > 0 ? context.threads
                                  : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
      bands(sun_bands(options.discretisation)) {}

TransferCost estimate(const Work& work, const std::vector<ColumnGroup>& groups,
                      const std::vector<std::vector<LineOfSight>>& lines) {
  TransferCost cost;
  const double layers = count_of(work.shells.levels_km) - 1.0;
  const double depths_bytes = SlantDepthGrid::points(layers) * layers * sizeof(float);
  cost.results_bytes = count_of(work.columns) * static_cast<double>(work.sights) * sizeof(float);
  double largest_kept = 0.0;
  double largest_scratch = 0.0;
  double largest_ray = 0.0;
  for (std::size_t band = 0; band < work.bands.size(); ++band) {
    if (lines[band].empty()) continue;
    double geometry = depths_bytes;
    double kept = 0.0;
    std::size_t band_blocks = 0;
    for (const ColumnGroup& group : groups) {
      const Sizes sizes = sizes_of(work, work.bands[band], group.key);
      const auto lanes = static_cast<std::size_t>(work.kernel.lanes);
      const std::size_t blocks = (group.columns.size() + lanes - 1) / lanes;
      double depth = 0.0;
      for (const std::size_t column : group.columns)
        depth = std::max(depth, scattering_depth(work.columns[column]));
      const double cpu_s = block_cpu_s(work, sizes, depth);
      band_blocks += blocks;
      cost.most_sublayers = std::max(cost.most_sublayers, sizes.sublayers);
      geometry += stencil_bytes(work, sizes);
      cost.largest_block_cpu_s = std::max(cost.largest_block_cpu_s, cpu_s);
      // A line of sight costs about as much as one level of the field under five sun nodes for each point,
      // and little more for every pair of sun and azimuth.
      double pairs = 0.0;
      for (const LineOfSight& line : lines[band]) pairs += count_of(line.pairs);
      cost.cpu_s +=
          static_cast<double>(blocks) *
          (cpu_s + (sizes.sublayers + layers) *
                       (10.0 * sizes.moments * count_of(lines[band]) + 30.0 * pairs) * kMultiplication_s);
      kept += static_cast<double>(blocks) * kept_bytes(work, sizes);
      largest_kept = std::max(largest_kept, kept_bytes(work, sizes));
      largest_scratch = std::max(largest_scratch, scratch_bytes(work, sizes));
      largest_ray = std::max(largest_ray, ray_bytes(work, lines[band], sizes));
    }
    cost.blocks += band_blocks;
    // One band after the other.
    cost.geometry_bytes = std::max(cost.geometry_bytes, geometry);
    cost.largest_field_bytes = largest_kept + largest_scratch;
    const double at_a_time =
        std::min(kept, static_cast<double>(kKeptFields_bytes) + largest_kept) +
        std::min(static_cast<double>(work.threads), static_cast<double>(band_blocks)) * largest_scratch;
    cost.fields_bytes = std::max(cost.fields_bytes, at_a_time);
    cost.all_fields_bytes += kept;
    cost.rays_bytes = std::max(
        cost.rays_bytes, std::min(static_cast<double>(work.threads), count_of(lines[band])) * largest_ray);
  }
  return cost;
}

void refuse_too_much(const Work& work, const TransferCost& cost) {
  const double asked = work.options.most_memory_bytes;
  const double memory = asked > 0.0 ? asked : kShareOfMemory * machine_memory_bytes();
  const double need = cost.memory_bytes();
  const std::string there = asked > 0.0 ? fmt::format("{} may be used", amount(memory))
                                        : fmt::format("{} of this machine's {} may be used", amount(memory),
                                                      amount(machine_memory_bytes()));
  const double sublayers = cost.geometry_bytes + cost.fields_bytes;
  const double depth = largest_depth(work.columns);
  if (need > memory) {
    if (sublayers >= cost.rays_bytes && sublayers >= cost.results_bytes) {
      // The sublayers of a thick layer grow more slowly than its depth.
      const double share = std::max(0.0, memory - cost.rays_bytes - cost.results_bytes) / sublayers;
      const double fits = what_fits(depth, share * share * share);
      throw InputError(
          "optical depth {:.4g} in {} levels: its {:.3g} sublayers need about {} of memory, {}; an optical "
          "depth "
          "of about {} would fit, or a coarser quality",
          depth, work.shells.levels_km.size(), cost.most_sublayers, amount(need), there, fits);
    }
    const double share = (memory - sublayers) / (cost.rays_bytes + cost.results_bytes);
    throw InputError(
        "{} columns in {} lines of sight need about {} of memory, {}; about {} of the lines of sight would "
        "fit "
        "at a time",
        work.columns.size(), work.sights, amount(need), there,
        what_fits(static_cast<double>(work.sights), share));
  }
  if (cost.largest_block_cpu_s > kMostBlock_cpu_s)
    throw InputError(
        "optical depth {:.4g} in {} levels: its {:.3g} sublayers would take about {} of CPU time, at most "
        "{}; an "
        "optical depth of about {} would, or a coarser quality",
        depth, work.shells.levels_km.size(), cost.most_sublayers, duration(cost.largest_block_cpu_s),
        duration(kMostBlock_cpu_s), what_fits(depth, kMostBlock_cpu_s / cost.largest_block_cpu_s));
}

}  // namespace skylut::transfer
