#include "row_errors.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::table_detail {

namespace {

constexpr double kCandelaPerKilocandela = 1000.0;
constexpr double kHorizonBand_deg = 10.0;

// One formula against the check; returns the RMSE over the dome.
double add_errors_of(FormulaNotes& notes, const TableEntry& row, const TableSky& sky,
                     const PerezCoefficients& k, double zenith, double Yxy::*channel, ResidualKind kind) {
  double squares = 0.0, weights = 0.0, horizon_squares = 0.0, horizon_weights = 0.0;
  const double sun_rad = sky.sun.zenith_deg * kRadiansPerDegree;
  notes.worst = 0.0;
  for (std::size_t i = 0; i < sky.check.views.size(); ++i) {
    const RelativeView& view = sky.check.views[i];
    const SkyDirection at = formula_view(sky, view);
    const double value = sky.check.colour[i].*channel;
    const double model = zenith * perez_relative(k, at.zenith_rad, at.gamma_rad, sun_rad);
    const double error = (model - value) / (kind == ResidualKind::relative ? value : 1.0);
    const double weight = sky.check.solid_angles_sr[i];
    squares += weight * error * error;
    weights += weight;
    if (view.zenith_deg > sky.dome_ends_deg - kHorizonBand_deg) {
      horizon_squares += weight * error * error;
      horizon_weights += weight;
    }
    if (std::abs(error) <= std::abs(notes.worst)) continue;
    notes.worst = error;
    notes.worst_direction = {
        view.zenith_deg,
        view.zenith_deg == 0.0 ? 0.0 : wrapped_azimuth_deg(row.sun.azimuth_deg + view.relative_azimuth_deg)};
  }
  notes.rmse_horizon = std::sqrt(horizon_squares / horizon_weights);
  return std::sqrt(squares / weights);
}

}  // namespace

SkyDirection formula_view(const TableSky& sky, const RelativeView& view) {
  // Exactly 90° at the formula's horizon.
  const double zenith_deg = view.zenith_deg * (90.0 / sky.dome_ends_deg);
  return {std::min(zenith_deg, 90.0) * kRadiansPerDegree,
          angle_between({view.zenith_deg, view.relative_azimuth_deg}, {sky.sun.zenith_deg, 0.0})};
}

void add_errors(TableEntry& entry, const TableSky& sky) {
  const double Y = entry.zenith.Y * kCandelaPerKilocandela;
  entry.rmse_Y_rel = add_errors_of(entry.notes_Y, entry, sky, entry.Y, Y, &Yxy::Y, ResidualKind::relative);
  entry.rmse_x =
      add_errors_of(entry.notes_x, entry, sky, entry.x, entry.zenith.x, &Yxy::x, ResidualKind::absolute);
  entry.rmse_y =
      add_errors_of(entry.notes_y, entry, sky, entry.y, entry.zenith.y, &Yxy::y, ResidualKind::absolute);
}

std::string flags_text(const std::array<bool, 5>& flags) {
  std::string digits;
  for (const bool flag : flags) digits += flag ? '1' : '0';
  return digits;
}

}  // namespace skylut::table_detail
