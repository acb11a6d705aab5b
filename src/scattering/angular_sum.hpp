#pragma once

#include <complex>
#include <map>
#include <vector>

#include "skylut/core/quadrature.hpp"
#include "skylut/scattering/mie_sphere.hpp"
#include "skylut/scattering/scattering_matrix.hpp"

namespace skylut {

/// Moments of the scattering matrix of many spheres together. Spheres are sorted into classes of like size; a
/// class sums F11 = F22 = |S1|² + |S2|², F12 = |S2|² - |S1|² and F33 = 2 Re S1 S2* at the nodes of a
/// Gauss-Legendre rule that is exact for every moment. [P6]
class AngularSum {
 public:
  /// Rules by the number of terms of a class; they serve all wavelengths.
  using Rules = std::map<int, Quadrature>;

  /// Smallest class that takes a series of that many terms.
  static int class_of(int terms);

  static void prepare(Rules& rules, int class_terms);

  /// Adds a sphere, so many times.
  void add(const MieSphere& sphere, double weight);

  /// Moments as in scattering_matrix.hpp, not normalised, for l = 0 … twice the terms of the largest class.
  /// @param rules  prepared for all classes of the spheres added
  std::vector<MatrixMoments> moments(const Rules& rules) const;

 private:
  struct WeightedSphere {
    std::vector<std::complex<double>> a;
    std::vector<std::complex<double>> b;
    double weight;
  };
  std::map<int, std::vector<WeightedSphere>> classes_;
};

}  // namespace skylut
