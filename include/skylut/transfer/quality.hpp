#pragma once

#include <string_view>

namespace skylut {

/// How finely the transfer equation is discretised. See docs/validation.md for the error and the
/// time of each quality.
enum class Quality { draft, standard, reference };

/// The numbers behind a quality, each of which can be refined by itself to show that the answer has
/// converged. [docs/validation.md, "Convergence"]
struct QualityLimits {
  double optical_step;  ///< largest scaled optical depth of a sublayer, > 0
  double
      truncated_peak;  ///< largest share of the scattering that delta-M may cut off beside narrow peaks, > 0
  int narrow_peak_degrees;  ///< degrees that are enough for a phase function with a narrow peak, at most 30
  double polar_per_degree;  ///< polar nodes per hemisphere, per Legendre degree, > 0
  int least_polar_nodes;    ///< 4 to 64
  /// Sun nodes: 0 are the 33 chosen ones; 1, 2, 4 put one at every half, quarter, eighth of a degree around
  /// the terminator.
  int sun_node_density;
  bool merge_layers;   ///< thin layers are taken together in the sweep
  double ray_step_km;  ///< longest step of a line of sight, > 0
  /// Largest change of the sunbeam's lowest altitude along a step where that lies close below, > 0.
  double sunbeam_step_km;
  double tolerance;  ///< of the iteration: relative error of the mean diffuse radiance, > 0
};

QualityLimits limits_of(Quality quality);

/// Changes one number of a quality by its name in the command line: "optical-step", "truncated-peak",
/// "polar-per-degree", "polar-nodes", "sun-nodes", "merge-layers" (0 or 1), "ray-step-km",
/// "sunbeam-step-km", "tolerance".
/// @throws InputError  for an unknown name (listing the known ones) or a value out of range
void set_limit(QualityLimits& limits, std::string_view name, double value);

}  // namespace skylut
