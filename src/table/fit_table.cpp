#include "skylut/table/fit_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <mutex>
#include <set>
#include <utility>

#include "branches.hpp"
#include "row_errors.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/fit/dome_directions.hpp"

namespace skylut {

namespace {

using table_detail::Branch;
using table_detail::BranchGrid;

constexpr double kCandelaPerKilocandela = 1000.0;

struct Channel {
  double Yxy::*colour;
  ResidualKind residual;
};
constexpr std::array<Channel, 3> kChannels{{{&Yxy::Y, ResidualKind::relative},
                                            {&Yxy::x, ResidualKind::absolute},
                                            {&Yxy::y, ResidualKind::absolute}}};

/// Row's conditions, for messages.
std::string row_name(std::size_t row, const TableSky& sky) {
  return fmt::format("row {} (altitude {} km, turbidity {}, sun {}:{})", row + 1, sky.altitude_km,
                     sky.turbidity.value, sky.sun.zenith_deg, sky.sun.azimuth_deg);
}

std::vector<double> weights_of(const TableSky& sky, SampleWeights weights) {
  std::vector<double> zenith_rad;
  for (const RelativeView& view : sky.fitted.views)
    zenith_rad.push_back(table_detail::formula_view(sky, view).zenith_rad);
  return sample_weights(zenith_rad, sky.fitted.solid_angles_sr, weights);
}

std::size_t zenith_of(const TableSky& sky) {
  const auto found = std::find_if(sky.fitted.views.begin(), sky.fitted.views.end(),
                                  [](const RelativeView& view) { return view.zenith_deg <= 1e-6; });
  if (found == sky.fitted.views.end())
    throw InputError("sky without a zenith direction: one of the {} directions must have zenith angle 0",
                     sky.fitted.views.size());
  return static_cast<std::size_t>(found - sky.fitted.views.begin());
}

/// What one sky is fitted to, and what the fits found.
struct FittedSky {
  const TableSky* sky = nullptr;
  double sun_zenith_rad = 0.0;
  Yxy zenith;
  std::array<std::vector<SkySample>, 3> samples;
  std::array<std::vector<PerezMinimum>, 3> minima;

  FittedSky() = default;
  FittedSky(const TableSky& from, SampleWeights kind)
      : sky(&from),
        sun_zenith_rad(from.sun.zenith_deg * kRadiansPerDegree),
        zenith(from.fitted.colour[zenith_of(from)]) {
    const std::vector<double> weights = weights_of(from, kind);
    for (std::size_t i = 0; i < from.fitted.views.size(); ++i)
      if (!(from.fitted.colour[i].Y > 0.0))
        throw InputError("sky direction {}: Y = {}: must be a number greater than 0", i,
                         from.fitted.colour[i].Y);
    for (std::size_t i = 0; i < from.fitted.views.size(); ++i) {
      const SkyDirection at = table_detail::formula_view(from, from.fitted.views[i]);
      for (std::size_t c = 0; c < kChannels.size(); ++c)
        samples[c].push_back(
            {at.zenith_rad, at.gamma_rad, from.fitted.colour[i].*kChannels[c].colour, weights[i]});
    }
  }

  FitOptions options_of(std::size_t channel, const TableFitOptions& options) const {
    FitOptions fit = options.fit;
    fit.residual = kChannels[channel].residual;
    const double largest_gamma = std::min(sun_zenith_rad + 0.5 * kPi, kPi);
    fit.D_upper = std::min(fit.D_upper, std::log(options.largest_exponential) / largest_gamma);
    return fit;
  }

  void fit(const TableFitOptions& options) {
    for (std::size_t c = 0; c < kChannels.size(); ++c)
      minima[c] = perez_minima(samples[c], sun_zenith_rad, zenith.*kChannels[c].colour,
                               options_of(c, options), options.branch_tolerance);
  }

  /// Other formulas than the minima: the best of slices of D and of B, in the valley that the least minimum
  /// lies in or outside it.
  void add_slices(std::size_t channel, const TableFitOptions& options) {
    const FitOptions whole = options_of(channel, options);
    std::vector<PerezMinimum>& known = minima[channel];
    const auto add_best_of = [&](FitOptions slice) {
      constexpr int kStarts = 4;
      slice.starts = kStarts;
      PerezMinimum best =
          perez_minima(samples[channel], sun_zenith_rad, zenith.*kChannels[channel].colour, slice, 0.0)
              .front();
      if (best.termination == Termination::converged) known.push_back(std::move(best));
    };
    const auto for_slices = [](std::initializer_list<double> inner, double lower, double upper,
                               const auto& use) {
      double from = lower;
      for (const double edge : inner) {
        if (edge <= from || edge >= upper) continue;
        use(from, edge);
        from = edge;
      }
      use(from, upper);
    };
    for_slices({-20.0, -10.0, -6.0, -4.0, -3.0, -2.0, -1.5, -1.0, -0.75, -0.5, -0.3, 0.3,
                0.5,   0.75,  1.0,  1.5,  2.0,  2.5,  3.0,  3.5,  4.0,   5.0,  6.0},
               whole.D_lower, whole.D_upper, [&](double from, double to) {
                 FitOptions slice = whole;
                 slice.D_lower = from;
                 slice.D_upper = to;
                 add_best_of(slice);
               });
    for_slices({-5.0, -3.0, -2.0, -1.4, -1.0, -0.7, -0.5, -0.35, -0.25, -0.17, -0.12, -0.08, -0.06, -0.04,
                -0.03, -0.02},
               whole.B_lower, whole.B_upper, [&](double from, double to) {
                 FitOptions slice = whole;
                 slice.B_lower = from;
                 slice.B_upper = to;
                 add_best_of(slice);
               });
  }

  FitReport report(std::size_t channel, std::size_t branch, const TableFitOptions& options) const {
    return perez_report(samples[channel], sun_zenith_rad, zenith.*kChannels[channel].colour,
                        options_of(channel, options), minima[channel][branch]);
  }
};

/// Which of the skies are fitted, and which fit every row gets.
struct Distinct {
  std::vector<std::size_t> skies;  // the first of every kind
  std::vector<std::size_t> of_row;
};

Distinct distinct(std::span<const TableSky> skies) {
  Distinct found;
  for (std::size_t row = 0; row < skies.size(); ++row) {
    const auto known = std::find_if(found.skies.begin(), found.skies.end(), [&](std::size_t other) {
      return skies[other].altitude_km == skies[row].altitude_km &&
             skies[other].turbidity.value == skies[row].turbidity.value &&
             skies[other].sun.zenith_deg == skies[row].sun.zenith_deg &&
             skies[other].fitted.views == skies[row].fitted.views;
    });
    found.of_row.push_back(static_cast<std::size_t>(known - found.skies.begin()));
    if (known == found.skies.end()) found.skies.push_back(row);
  }
  return found;
}

/// Places of fitted skies in the grid of all altitudes, turbidities and sun zenith angles; empty if a
/// combination is missing or there twice.
struct GridPlaces {
  BranchGrid grid;
  std::vector<std::size_t> sky;  // [node]
};

std::size_t index_in(const std::set<double>& axis, double value) {
  return static_cast<std::size_t>(std::distance(axis.begin(), axis.find(value)));
}

GridPlaces grid_of(const std::vector<FittedSky>& fitted) {
  std::set<double> altitudes, turbidities, suns;
  for (const FittedSky& one : fitted) {
    altitudes.insert(one.sky->altitude_km);
    turbidities.insert(one.sky->turbidity.value);
    suns.insert(one.sun_zenith_rad);
  }
  GridPlaces places;
  places.grid.sizes = {altitudes.size(), turbidities.size(), suns.size()};
  places.grid.sun_zeniths_rad.assign(suns.begin(), suns.end());
  const std::size_t nodes = altitudes.size() * turbidities.size() * suns.size();
  if (nodes != fitted.size()) return {};
  places.sky.assign(nodes, fitted.size());
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const std::size_t node = (index_in(altitudes, fitted[i].sky->altitude_km) * turbidities.size() +
                              index_in(turbidities, fitted[i].sky->turbidity.value)) *
                                 suns.size() +
                             index_in(suns, fitted[i].sun_zenith_rad);
    if (places.sky[node] != fitted.size()) return {};
    places.sky[node] = i;
  }
  return places;
}

/// The places' grid with the minima that the skies have now.
BranchGrid grid_with_branches(const GridPlaces& places, const std::vector<FittedSky>& fitted,
                              std::size_t channel, double tolerance) {
  // Of ln F: a luminance that is positive, a chromaticity off by a fifth.
  constexpr std::array<double, 3> kLimits{20.0, 0.4, 0.4};
  BranchGrid grid = places.grid;
  grid.limit = kLimits[channel];
  for (const std::size_t sky : places.sky) {
    std::vector<Branch>& branches = grid.branches.emplace_back();
    const std::vector<PerezMinimum>& minima = fitted[sky].minima[channel];
    for (const PerezMinimum& minimum : minima) {
      const double excess = minimum.cost / minima.front().cost - 1.0;
      branches.push_back({minimum.coefficients, excess, excess <= tolerance});
    }
  }
  return grid;
}

/// The branch of every fitted sky's channel. Where the minima leave a half that no sky has, other formulas
/// are looked at too. [fit.md F8]
std::vector<std::size_t> branches_of(const Context& context, const GridPlaces& places,
                                     std::vector<FittedSky>& fitted, std::size_t channel,
                                     const TableFitOptions& options) {
  std::vector<std::size_t> chosen(fitted.size(), 0);
  if (places.sky.empty()) return chosen;
  BranchGrid grid = grid_with_branches(places, fitted, channel, options.branch_tolerance);
  table_detail::ChosenBranches at = table_detail::choose_branches(grid);
  std::vector<std::size_t> bad;
  for (std::size_t node = 0; node < places.sky.size(); ++node)
    if (at.beside_impossible[node]) bad.push_back(places.sky[node]);
  if (!bad.empty()) {
    parallel_for(bad.size(), context.threads,
                 [&](std::size_t task) { fitted[bad[task]].add_slices(channel, options); });
    grid = grid_with_branches(places, fitted, channel, options.branch_tolerance);
    at = table_detail::choose_branches(grid);
  }
  for (std::size_t node = 0; node < places.sky.size(); ++node) chosen[places.sky[node]] = at.branch[node];
  return chosen;
}

TableEntry table_entry(const TableSky& sky, const SkyFit& fit) {
  TableEntry entry;
  entry.altitude_km = sky.altitude_km;
  entry.turbidity = sky.turbidity.value;
  entry.sun = sky.sun;
  entry.Y = fit.Y.coefficients;
  entry.x = fit.x.coefficients;
  entry.y = fit.y.coefficients;
  entry.zenith = {fit.zenith.Y / kCandelaPerKilocandela, fit.zenith.x, fit.zenith.y};
  entry.horizon_zenith_deg = sky.dome_ends_deg;
  for (const auto& [notes, report] : {std::pair{&entry.notes_Y, &fit.Y}, std::pair{&entry.notes_x, &fit.x},
                                      std::pair{&entry.notes_y, &fit.y}}) {
    std::array<bool, 5> undetermined{};
    std::transform(report->determined.begin(), report->determined.end(), undetermined.begin(),
                   std::logical_not<>());
    notes->undetermined = table_detail::flags_text(undetermined);
    notes->at_bound = table_detail::flags_text(report->at_bound);
  }
  entry.Y_below_90_kcd_m2 = sky.Y_below_cd_m2 / kCandelaPerKilocandela;
  entry.light_below_90 = sky.light_below;
  table_detail::add_errors(entry, sky);
  return entry;
}

std::string described(const GridPlaces& places) {
  if (places.sky.empty()) return "none: every row is fitted alone";
  return fmt::format("all {} altitudes x {} turbidities x {} sun zenith angles together",
                     places.grid.sizes[0], places.grid.sizes[1], places.grid.sizes[2]);
}

}  // namespace

TableFitOptions TableFitOptions::half_floats() {
  TableFitOptions options;
  // A = (g - 1) e^{-B} with g = 1 + A e^B stays below 7 e^9 = 5.7e4; C and E stay below 6e4 with 1e3 times
  // what a sky varies by.
  options.fit.B_lower = -9.0;
  options.fit.B_upper = -0.01;
  options.largest_exponential = 6e4;
  options.fit.largest_gradation = 8.0;
  options.fit.largest_scattering = 1000.0;
  return options;
}

TableFitOptions TableFitOptions::utm2005() {
  TableFitOptions options;
  options.weights = SampleWeights::uniform;
  options.branch_tolerance = 0.0;
  return options;
}

SkyTable fit_table(const Context& context, std::span<const TableSky> skies, const TableFitOptions& options) {
  const Distinct which = distinct(skies);
  std::vector<FittedSky> fitted(which.skies.size());
  std::mutex one_at_a_time;
  std::size_t done = skies.size() - which.skies.size();
  parallel_for(which.skies.size(), context.threads, [&](std::size_t task) {
    const std::size_t row = which.skies[task];
    try {
      fitted[task] = FittedSky(skies[row], options.weights);
      fitted[task].fit(options);
    } catch (const InputError& error) {
      throw InputError("{}: {}", row_name(row, skies[row]), error.what());
    }
    const std::lock_guard lock(one_at_a_time);
    if (context.progress) context.progress("fitting", ++done, skies.size());
  });

  const GridPlaces places = options.branch_tolerance > 0.0 ? grid_of(fitted) : GridPlaces{};
  std::array<std::vector<std::size_t>, 3> branches;
  for (std::size_t c = 0; c < kChannels.size(); ++c)
    branches[c] = branches_of(context, places, fitted, c, options);

  std::vector<SkyFit> fits(fitted.size());
  parallel_for(fitted.size(), context.threads, [&](std::size_t i) {
    fits[i] = {.Y = fitted[i].report(0, branches[0][i], options),
               .x = fitted[i].report(1, branches[1][i], options),
               .y = fitted[i].report(2, branches[2][i], options),
               .zenith = fitted[i].zenith};
  });
  SkyTable table;
  table.grid = described(places);
  std::array<double, 3> cost_over_least{};
  for (std::size_t row = 0; row < skies.size(); ++row) {
    table.fits.push_back(fits[which.of_row[row]]);
    for (std::size_t c = 0; c < kChannels.size(); ++c) {
      const std::vector<PerezMinimum>& minima = fitted[which.of_row[row]].minima[c];
      const double cost = minima[branches[c][which.of_row[row]]].cost;
      cost_over_least[c] = cost > minima.front().cost ? cost / minima.front().cost - 1.0 : 0.0;
    }
    table.cost_over_least.push_back(cost_over_least);
    table.entries.push_back(table_entry(skies[row], table.fits.back()));
  }
  return table;
}

void require_converged(const SkyTable& table) {
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < table.fits.size(); ++i)
    if (const std::string channels = unconverged_channels(table.fits[i]); !channels.empty())
      rows.push_back(fmt::format("{} ({})", i + 1, channels));
  if (!rows.empty())
    throw WorkError("fits that did not converge, whose coefficients are not those of a minimum: rows {}",
                    fmt::join(rows, ", "));
}

}  // namespace skylut
