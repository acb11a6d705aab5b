#include "skylut/report/table_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace skylut {

namespace {

using FlagsOf = std::array<bool, 5> (*)(const FitReport&);

// "A_Y B_Y D_x": the coefficients of a fit that a flag is set for.
std::string flagged(const SkyFit& fit, FlagsOf flags_of) {
  std::string names;
  for (const auto& [channel, report] :
       {std::pair{"Y", &fit.Y}, std::pair{"x", &fit.x}, std::pair{"y", &fit.y}}) {
    const std::array<bool, 5> flags = flags_of(*report);
    for (std::size_t i = 0; i < flags.size(); ++i)
      if (flags[i]) names += fmt::format(" {}_{}", kPerezNames[i], channel);
  }
  return names;
}

std::array<bool, 5> undetermined(const FitReport& report) {
  std::array<bool, 5> flags{};
  std::transform(report.determined.begin(), report.determined.end(), flags.begin(), std::logical_not<>());
  return flags;
}

std::array<bool, 5> at_bound(const FitReport& report) { return report.at_bound; }

std::string notes(const SkyFit& fit) {
  std::string text;
  if (const std::string channels = unconverged_channels(fit); !channels.empty())
    text += "  no convergence: " + channels;
  const std::string bound = flagged(fit, at_bound);
  if (!bound.empty()) text += "  at bound:" + bound;
  const std::string loose = flagged(fit, undetermined);
  if (!loose.empty()) text += "  undetermined:" + loose;
  return text;
}

}  // namespace

std::string table_summary(const SkyTable& table, const std::string& turbidity_kind) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{:>4} {:>8} {:>12}  {:>13} {:>10} {:>7} {:>7}  {:>7} {:>7} {:>7}\n", "row", "altitude",
                 turbidity_kind, "sun", "zenith Y", "x", "y", "rmse Y", "x", "y");
  fmt::format_to(out, "{:>4} {:>8} {:>12}  {:>6} {:>6} {:>10} {:>7} {:>7}  {:>7} {:>7} {:>7}\n", "", "km", "",
                 "zenith", "azim.", "kcd/m2", "", "", "%", "", "");
  for (std::size_t i = 0; i < table.entries.size(); ++i) {
    const TableEntry& row = table.entries[i];
    fmt::format_to(
        out, "{:>4} {:>8} {:>12}  {:>6} {:>6} {:>10.4g} {:>7.4f} {:>7.4f}  {:>7.2f} {:>7.4f} {:>7.4f}{}\n",
        i + 1, row.altitude_km, row.turbidity, row.sun.zenith_deg, row.sun.azimuth_deg, row.zenith.Y,
        row.zenith.x, row.zenith.y, 100.0 * row.rmse_Y_rel, row.rmse_x, row.rmse_y, notes(table.fits[i]));
  }
  const auto worst =
      std::max_element(table.entries.begin(), table.entries.end(),
                       [](const TableEntry& a, const TableEntry& b) { return a.rmse_Y_rel < b.rmse_Y_rel; });
  if (worst != table.entries.end())
    fmt::format_to(out, "{} rows; the largest rmse of Y is {:.2f} % in row {}\n", table.entries.size(),
                   100.0 * worst->rmse_Y_rel, worst - table.entries.begin() + 1);
  return fmt::to_string(text);
}

}  // namespace skylut
