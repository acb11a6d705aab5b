#include "skylut/transfer/quality.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "skylut/core/errors.hpp"

namespace skylut {

QualityLimits limits_of(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {0.2, 0.024, 12, 0.6, 8, 0, true, 20.0, 2.0, 3e-3};
    case Quality::standard:
      return {0.04, 0.012, 20, 0.7, 10, 0, true, 10.0, 0.25, 1e-3};
    case Quality::reference:
      return {0.02, 0.004, 30, 0.9, 16, 1, false, 5.0, 0.125, 1e-4};
  }
  return limits_of(Quality::standard);
}

void set_limit(QualityLimits& limits, std::string_view name, double value) {
  struct Knob {
    std::string_view name;
    double lowest;
    double highest;
    bool whole;
    std::function<void(double)> set;
  };
  const std::vector<Knob> knobs{
      {"optical-step", 1e-3, 1.0, false, [&](double v) { limits.optical_step = v; }},
      {"truncated-peak", 1e-4, 0.1, false, [&](double v) { limits.truncated_peak = v; }},
      {"narrow-peak-degrees", 2, 30, true,
       [&](double v) { limits.narrow_peak_degrees = static_cast<int>(v); }},
      {"polar-per-degree", 0.5, 4.0, false, [&](double v) { limits.polar_per_degree = v; }},
      {"polar-nodes", 4, 64, true, [&](double v) { limits.least_polar_nodes = static_cast<int>(v); }},
      {"sun-nodes", 0, 4, true, [&](double v) { limits.sun_node_density = static_cast<int>(v); }},
      {"merge-layers", 0, 1, true, [&](double v) { limits.merge_layers = v != 0.0; }},
      {"ray-step-km", 0.1, 100.0, false, [&](double v) { limits.ray_step_km = v; }},
      {"sunbeam-step-km", 0.01, 10.0, false, [&](double v) { limits.sunbeam_step_km = v; }},
      {"tolerance", 1e-6, 0.1, false, [&](double v) { limits.tolerance = v; }}};
  std::string known;
  for (const Knob& knob : knobs) {
    if (knob.name == name) {
      if (!(value >= knob.lowest && value <= knob.highest) || (knob.whole && value != std::floor(value)))
        throw InputError("{} {}: must be {} within {} to {}", name, value,
                         knob.whole ? "a whole number" : "a number", knob.lowest, knob.highest);
      knob.set(value);
      return;
    }
    known += (known.empty() ? "" : ", ") + std::string(knob.name);
  }
  throw InputError("quality limit '{}': must be one of {}", name, known);
}

}  // namespace skylut
