#pragma once

#include <string_view>

namespace skylut {

/// How finely the transfer equation is discretised. See docs/validation.md for the error and the
/// time of each quality.
enum class Quality { draft, standard, reference };

/// The numbers behind a quality, each of which can be refined by itself to show that the answer has
/// converged. Ranges as in set_discretisation. [docs/validation.md, "Convergence"]
struct DiscretisationOptions {
  /// Largest scaled optical depth of a sublayer, [0.001, 1].
  double optical_step;
  /// Largest share of the scattering that delta-M may cut off beside narrow peaks, [0.0001, 0.1].
  double truncated_peak;
  /// Legendre degree that is enough for a phase function with a narrow peak, 2 to 30.
  int narrow_peak_degree;
  /// Legendre degree to which the polarisation of diffuse light is followed, 2 to 30; 0: light is taken for
  /// unpolarised, which it is not. Singly scattered light, which holds the sharp structure, is polarised
  /// exactly. [docs/polarisation.md]
  int polarised_degree;
  /// Polar nodes per hemisphere, per Legendre degree, [0.5, 4].
  double polar_per_degree;
  /// 4 to 64, per hemisphere.
  int least_polar_nodes;
  /// Sun nodes: 0 are the 33 chosen ones; 1, 2, 4 put one at every half, quarter, eighth of a degree around
  /// the terminator; up to 4.
  int sun_node_density;
  /// A sun's field is interpolated among the nodes around it instead of all: at most 0.1 % for a fraction of
  /// the time.
  bool sun_bands;
  /// Thin layers are taken together in the sweep.
  bool merge_layers;
  /// Longest step of a line of sight, [0.1, 100].
  double ray_step_km;
  /// Largest change of the sunbeam's lowest altitude along a step where that lies close below, [0.01, 10].
  double sunbeam_step_km;
  /// Of the iteration: relative error of the mean diffuse radiance, [1e-6, 0.1].
  double tolerance;
};

DiscretisationOptions discretisation_of(Quality quality);

/// Changes one number of a quality by its name in the command line: "optical-step", "truncated-peak",
/// "narrow-peak-degrees", "polarised-degrees", "polar-per-degree", "polar-nodes", "sun-nodes", "sun-bands"
/// and "merge-layers" (0 or 1), "ray-step-km", "sunbeam-step-km", "tolerance".
/// @throws InputError  for an unknown name (listing the known ones) or a value out of range
void set_discretisation(DiscretisationOptions& options, std::string_view name, double value);

/// @throws InputError naming the first number that is out of range
void check_discretisation(const DiscretisationOptions& options);

}  // namespace skylut
