#pragma once

#include <array>
#include <vector>

#include "angular_grid.hpp"
#include "kernel_problem.hpp"

namespace skylut::transfer {

/// The transforms of Q and U between polar and azimuth nodes and moments. Scattering mixes them by the
/// generalised spherical functions with m and ±2: Q + U goes by d^l_m,-2, Q - U by s_m d^l_m2 (s_m = (-1)^m
/// up to 2, then 1), and Q has the cosines of mφ where U has the sines. Degrees beyond the field's own
/// polarised degree are left out: what they would carry, the sharp structure of polarised diffuse light, is
/// scattered by large particles alone. [docs/polarisation.md P5-P7]
class PolarisedAngles {
 public:
  /// @param degree  highest that is kept, at most that of the intensity
  PolarisedAngles(const AngularGrid& angles, int degree);

  int moments() const { return static_cast<int>(moment_degree_.size()); }

  /// The kernel's view; it points into this object.
  PolarisedView view() const;

  /// R = ½ (s_m d^l_m2 + d^l_m,-2) and T = ½ (s_m d^l_m2 - d^l_m,-2) of every moment in one direction.
  /// @param mu  cosine of the direction in which the light travels
  void rotation_functions(double mu, std::vector<float>& r, std::vector<float>& t) const;

 private:
  int degree_;
  int orders_;
  std::vector<int> moment_offset_;        // [m], of its least degree
  std::vector<int> moment_degree_;        // [moment]
  std::vector<int> moment_of_intensity_;  // [moment]: that of the same l and m
  struct Matrices {
    std::vector<PanelMatrix> own;
    std::vector<const float*> data;
    void add(PanelMatrix matrix);
    void point();
  };
  std::array<std::array<Matrices, 2>, 2> polar_synthesis_;  // [hemisphere][Q + U, Q - U], of ½ of them
  std::array<std::array<Matrices, 2>, 2> polar_analysis_;
  std::array<PanelMatrix, 2> cosine_synthesis_;  // [parity of m]
  std::array<PanelMatrix, 2> cosine_analysis_;
  std::array<PanelMatrix, 2> sine_synthesis_;
  std::array<PanelMatrix, 2> sine_analysis_;
};

}  // namespace skylut::transfer
