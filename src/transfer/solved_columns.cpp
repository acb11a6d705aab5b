#include "skylut/transfer/solved_columns.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "skylut/core/check.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "spherical/band_solution.hpp"
#include "spherical/request_check.hpp"
#include "spherical/work_progress.hpp"

namespace skylut {

using namespace transfer;

namespace {

/// One sight for every sun, of which nothing but the suns counts: for the check and the estimate.
std::vector<Sight> one_sight_each(std::span<const double> sun_zeniths_deg) {
  std::vector<Sight> sights;
  for (const double sun_deg : sun_zeniths_deg) sights.push_back({0.0, sun_deg, {0.0, 0.0}});
  return sights;
}

float checked(float value, std::size_t column) {
  if (!std::isfinite(value))
    throw WorkError("radiance of column {} is not a number: do its phase functions hold one?", column);
  return value;
}

}  // namespace

struct SolvedColumns::Solution {
  Shells shells;
  std::vector<OpticalColumn> columns;
  TransferOptions options;
  Work work;
  std::vector<ColumnGroup> groups;
  std::vector<std::unique_ptr<BandSolution>> bands;  // null: not asked for
  std::size_t scatterers = 0;
  struct Place {
    const BlockOptics* optics = nullptr;
    int lane = 0;
  };
  std::vector<Place> place;  // [column], in one of the bands
  TransferReport report;

  Solution(const Context& context, Shells shells_, std::vector<OpticalColumn> columns_,
           std::span<const Sight> sights, const TransferOptions& options_)
      : shells(std::move(shells_)),
        columns(std::move(columns_)),
        options(options_),
        work(context, shells, columns, sights, options),
        groups(group_columns(work.merge, options.discretisation, columns)),
        bands(work.bands.size()) {
    for (const OpticalColumn& column : columns) scatterers = std::max(scatterers, column.scatterers.size());
    TransferCost cost = estimate(work, groups, lines_of_sight(shells, work.bands, sights));
    cost.fields_bytes = std::max(cost.fields_bytes, cost.all_fields_bytes);  // all of them are kept
    refuse_too_much(work, cost);
    try {
      solve(context, sights);
    } catch (const std::bad_alloc&) {
      throw WorkError("radiative transfer ran out of memory: about {:.3g} GB were expected to be enough",
                      cost.memory_bytes() / 1e9);
    }
  }

  void solve(const Context& context, std::span<const Sight> sights) {
    std::vector<Block*> blocks;
    for (const Sight& sight : sights) {
      std::unique_ptr<BandSolution>& band = bands[band_of(work.bands, sight.sun_zenith_deg)];
      if (band) continue;
      band =
          std::make_unique<BandSolution>(work, groups, work.bands[band_of(work.bands, sight.sun_zenith_deg)]);
      for (Block& block : band->blocks()) blocks.push_back(&block);
    }
    WorkProgress progress(context, blocks.size());
    progress.run(blocks.size(), 1, [&](std::size_t index) { solve_field(context, work, *blocks[index]); });
    place.resize(columns.size());
    for (const Block* block : blocks)
      for (std::size_t lane = 0; lane < block->columns.size(); ++lane)
        place[block->columns[lane]] = {block->optics.get(), static_cast<int>(lane)};
    for (const std::unique_ptr<BandSolution>& band : bands)
      if (band) band->add_to(report);
    report.kernel = work.kernel.name;
    report.lanes = work.kernel.lanes;
    report.cpu_s = progress.cpu_s();
  }

  /// Puts a block's parts of some of a line's pairs where they belong.
  /// @param values  [part of the block][pair][lane]
  /// @param to      [part][pair of these][column]
  void sort(const Block& block, std::span<const float> values, std::size_t pairs, std::size_t first_pair,
            std::size_t count, std::span<float> to) const {
    const auto lanes = static_cast<std::size_t>(block.optics->lanes);
    const auto own = static_cast<std::size_t>(block.optics->scatterers);
    const auto copy = [&](std::size_t from_part, std::size_t to_part) {
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t lane = 0; lane < block.columns.size(); ++lane)
          to[(to_part * count + i) * columns.size() + block.columns[lane]] =
              checked(values[(from_part * pairs + first_pair + i) * lanes + lane], block.columns[lane]);
    };
    for (std::size_t kind = 0; kind < 3; ++kind)
      for (std::size_t s = 0; s < own; ++s) copy(kind * own + s, kind * scatterers + s);
    copy(3 * own, 3 * scatterers);
    if (!options.stokes) return;
    copy(3 * own + 1, 3 * scatterers + 1);
    copy(3 * own + 2, 3 * scatterers + 2);
  }

  /// The band that answers, and its line of sight.
  std::pair<const BandSolution*, LineOfSight> question(const SightLine& line) const {
    check_place(shells, line.observer_altitude_km, 0.0);  // not from outside
    LineOfSight asked{line.observer_altitude_km, line.view_zenith_deg, {}, {}};
    for (const double azimuth_deg : line.relative_azimuth_deg) {
      check_sight({line.observer_altitude_km, line.sun_zenith_deg, {line.view_zenith_deg, azimuth_deg}},
                  shells.levels_km.back());
      asked.pairs.push_back({line.sun_zenith_deg, azimuth_deg});
    }
    const BandSolution* band = bands[band_of(work.bands, line.sun_zenith_deg)].get();
    if (band == nullptr)
      throw InputError("sun zenith {} deg: no sun close to it was solved", line.sun_zenith_deg);
    return {band, std::move(asked)};
  }
};

SolvedColumns::SolvedColumns(const Context& context, Shells shells, std::vector<OpticalColumn> columns,
                             std::span<const double> sun_zeniths_deg, const TransferOptions& options) {
  const std::vector<Sight> sights = one_sight_each(sun_zeniths_deg);
  check_request(shells, columns, sights, options);
  solution_ =
      std::make_unique<const Solution>(context, std::move(shells), std::move(columns), sights, options);
}

SolvedColumns::~SolvedColumns() = default;
SolvedColumns::SolvedColumns(SolvedColumns&&) noexcept = default;
SolvedColumns& SolvedColumns::operator=(SolvedColumns&&) noexcept = default;

std::size_t SolvedColumns::columns() const { return solution_->columns.size(); }
std::size_t SolvedColumns::scatterers() const { return solution_->scatterers; }
std::size_t SolvedColumns::parts() const {
  return 3 * solution_->scatterers + (solution_->options.stokes ? 3 : 1);
}
const Shells& SolvedColumns::shells() const { return solution_->shells; }
const TransferReport& SolvedColumns::report() const { return solution_->report; }

void SolvedColumns::radiance(const SightLine& line, std::span<float> radiance) const {
  const std::size_t azimuths = line.relative_azimuth_deg.size();
  SKYLUT_CHECK_EQ(radiance.size(), columns() * azimuths);
  const auto [band, asked] = solution_->question(line);
  answer_line_of_sight(band->common(), asked, band->blocks(), false,
                       [&](const Block& block, std::span<const float> values) {
                         const auto lanes = static_cast<std::size_t>(block.optics->lanes);
                         for (std::size_t lane = 0; lane < block.columns.size(); ++lane)
                           for (std::size_t i = 0; i < azimuths; ++i)
                             radiance[block.columns[lane] * azimuths + i] =
                                 checked(values[i * lanes + lane], block.columns[lane]);
                       });
}

void SolvedColumns::radiance_parts(std::span<const SightLine> lines, std::span<float> parts) const {
  if (lines.empty()) return;
  const std::size_t azimuths = lines.front().relative_azimuth_deg.size();
  const std::size_t size = this->parts() * azimuths * columns();
  SKYLUT_CHECK_EQ(parts.size(), lines.size() * size);
  std::vector<LineOfSight> asked;
  const BandSolution* band = nullptr;
  for (const SightLine& line : lines) {
    SKYLUT_CHECK_EQ(line.relative_azimuth_deg.size(), azimuths);
    SKYLUT_CHECK_EQ(line.sun_zenith_deg, lines.front().sun_zenith_deg);
    auto [of_line, question] = solution_->question(line);
    band = of_line;
    asked.push_back(std::move(question));
  }
  std::fill(parts.begin(), parts.end(), 0.0f);
  answer_in_parts(band->common(), asked, band->blocks(), solution_->options.stokes,
                  [&](std::size_t line, const Block& block, std::span<const float> values) {
                    solution_->sort(block, values, azimuths, 0, azimuths, parts.subspan(line * size, size));
                  });
}

void SolvedColumns::radiance_parts(const SightFan& fan, std::span<float> parts) const {
  const std::size_t azimuths = fan.relative_azimuth_deg.size();
  const std::size_t size = this->parts() * azimuths * columns();
  SKYLUT_CHECK_EQ(parts.size(), fan.sun_zenith_deg.size() * size);
  std::fill(parts.begin(), parts.end(), 0.0f);
  // Runs of suns in one band are asked together.
  for (std::size_t first = 0, last; first < fan.sun_zenith_deg.size(); first = last) {
    const auto question = [&](std::size_t sun) {
      return solution_->question(
          {fan.observer_altitude_km, fan.view_zenith_deg, fan.sun_zenith_deg[sun], fan.relative_azimuth_deg});
    };
    auto [band, asked] = question(first);
    for (last = first + 1; last < fan.sun_zenith_deg.size(); ++last) {
      auto [next_band, next] = question(last);
      if (next_band != band) break;
      asked.pairs.insert(asked.pairs.end(), next.pairs.begin(), next.pairs.end());
    }
    const std::size_t pairs = asked.pairs.size();
    answer_in_parts(band->common(), {&asked, 1}, band->blocks(), solution_->options.stokes,
                    [&](std::size_t, const Block& block, std::span<const float> values) {
                      for (std::size_t sun = first; sun < last; ++sun)
                        solution_->sort(block, values, pairs, (sun - first) * azimuths, azimuths,
                                        parts.subspan(sun * size, size));
                    });
  }
}

void SolvedColumns::part_factors(std::size_t column, double cos_scattering_angle,
                                 std::span<double> factors) const {
  SKYLUT_CHECK_EQ(factors.size(), parts());
  const Solution::Place& place = solution_->place[column];
  place.optics->part_factors(place.lane, cos_scattering_angle, factors);
}

}  // namespace skylut
