#include "refractive_shells.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/errors.hpp"

namespace skylut::transfer {

namespace {

ShellGeometry optical_shells(const Shells& shells) {
  const std::vector<double>& n = shells.refractivity;
  const std::vector<double>& h = shells.levels_km;
  if (n.size() != h.size())
    throw InputError("refractivity at {} levels: must be given at every one of {}", n.size(), h.size());
  const double ground = shells.planet_radius_km * (1.0 + n.front());
  std::vector<double> levels_km;
  for (std::size_t i = 0; i < h.size(); ++i) {
    if (!(n[i] >= 0.0 && n[i] < 1.0))
      throw InputError("refractivity {} at {} km: must lie within 0 to 1", n[i], h[i]);
    // n r - n0 r0 without the cancellation of large radii.
    levels_km.push_back(shells.planet_radius_km * (n[i] - n.front()) + h[i] * (1.0 + n[i]));
    if (i > 0 && !(levels_km[i] > levels_km[i - 1]))
      throw InputError(
          "air between {} and {} km over a planet of {} km: bends light more than the ground "
          "curves and traps it, must be denser less steeply or taken without refraction",
          h[i - 1], h[i], shells.planet_radius_km);
  }
  return {levels_km, ground};
}

/// d ln N/dx at every level, from the parabola through ln N there and at its neighbours.
std::vector<double> logarithmic_slopes(const std::vector<double>& x,
                                       const std::vector<double>& refractivity) {
  constexpr double kVacuum = 1e-30;
  const std::size_t last = x.size() - 1;
  std::vector<double> of_layer;
  for (std::size_t i = 0; i < last; ++i)
    of_layer.push_back(std::log(std::max(refractivity[i + 1], kVacuum) / std::max(refractivity[i], kVacuum)) /
                       (x[i + 1] - x[i]));
  std::vector<double> slope(x.size());
  slope.back() = of_layer.back();
  for (std::size_t i = 1; i < last; ++i) {
    const double below = x[i] - x[i - 1];
    const double above = x[i + 1] - x[i];
    slope[i] = (of_layer[i - 1] * above + of_layer[i] * below) / (below + above);
  }
  slope.front() = last > 1 ? 2.0 * of_layer.front() - slope[1] : of_layer.front();
  return slope;
}

}  // namespace

RefractiveShells::RefractiveShells(const Shells& shells)
    : layers_(shells.levels_km, shells.planet_radius_km), optical_(optical_shells(shells)) {
  const std::vector<double>& n = shells.refractivity;
  const std::vector<double>& x = optical_.levels_km();
  const std::vector<double> slope = logarithmic_slopes(x, n);
  const auto rate_at = [&](std::size_t level) { return -slope[level] * n[level] / (1.0 + n[level]); };
  for (std::size_t layer = 0; layer + 1 < x.size(); ++layer) {
    const double thickness = x[layer + 1] - x[layer];
    stretch_.push_back((shells.levels_km[layer + 1] - shells.levels_km[layer]) / thickness);
    // The parabola with the rates of both levels whose mean takes ln n from one to the other.
    const double mean = (std::log1p(n[layer]) - std::log1p(n[layer + 1])) / thickness;
    const double lower = rate_at(layer);
    const double upper = rate_at(layer + 1);
    rate_.push_back({{lower, 6.0 * mean - 4.0 * lower - 2.0 * upper, 3.0 * (lower + upper - 2.0 * mean)}});
  }
}

ShellGeometry RefractiveShells::optical(const ShellGeometry& levels) const {
  std::vector<double> levels_km;
  for (const double level : levels.levels_km()) levels_km.push_back(optical_km(level));
  return {levels_km, optical_.planet_radius_km()};
}

double RefractiveShells::optical_km(double altitude_km) const {
  const int layer = layers_.layer_of(altitude_km);
  return optical_.level_km(layer) + (altitude_km - layers_.level_km(layer)) / stretch(layer);
}

double RefractiveShells::altitude_km(double optical_km) const {
  const int layer = optical_.layer_of(optical_km);
  return layers_.level_km(layer) + (optical_km - optical_.level_km(layer)) * stretch(layer);
}

double RefractiveShells::bending_within(int layer, double impact_km, double from_km, double to_km) const {
  // Gauss and Legendre: exact for a rate that is a parabola in x, of the fourth degree in w.
  constexpr double kNode[3] = {0.5 - 0.38729833462074170, 0.5, 0.5 + 0.38729833462074170};
  constexpr double kWeight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  const double bottom = optical_.planet_radius_km() + optical_.level_km(layer);
  const double per_thickness = 1.0 / (optical_.level_km(layer + 1) - optical_.level_km(layer));
  const double* const rate = rate_[static_cast<std::size_t>(layer)].rate;
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double w = from_km + (to_km - from_km) * kNode[i];
    const double x = std::sqrt(impact_km * impact_km + w * w);
    const double t = (x - bottom) * per_thickness;
    sum += kWeight[i] * (rate[0] + t * (rate[1] + t * rate[2])) / x;
  }
  return sum * impact_km * (to_km - from_km);
}

double RefractiveShells::bending_above(double optical_km, double along_km) const {
  const double x = optical_.planet_radius_km() + optical_km;
  const double impact = std::sqrt(std::max(0.0, (x - along_km) * (x + along_km)));
  double bending = 0.0;
  double from = along_km;
  for (int layer = optical_.layer_of(optical_km); layer < optical_.layers(); ++layer) {
    const double climb = optical_.radius_square_difference(optical_.level_km(layer + 1), optical_km);
    const double to = std::sqrt(along_km * along_km + std::max(0.0, climb));
    bending += bending_within(layer, impact, from, to);
    from = to;
  }
  return bending;
}

}  // namespace skylut::transfer
