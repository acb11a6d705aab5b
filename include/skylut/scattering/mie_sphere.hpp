#pragma once

#include <complex>
#include <vector>

namespace skylut {

/// Scattering of a plane wave by a homogeneous sphere: Mie's series after Bohren and Huffman 1983
/// (doi:10.1002/9783527618156, chapter 4), with logarithmic derivatives by downward recurrence.
/// [docs/aerosols.md P1-P4]
///
/// Accuracy: efficiencies and asymmetry within 1e-8 of a 60-digit calculation for size parameters
/// 1e-3 to 3000, index 1.2-1.9, absorption 0-0.5 (tests/unit/scattering/mie_sphere_test.cpp).
class MieSphere {
 public:
  /// @param size_parameter    x = 2π r/λ, λ in the surrounding medium, [1e-6, 1e5]
  /// @param refractive_index  m = n + i k relative to the medium; n in [0.05, 20], k in [0, 20] (absorbing:
  ///                          k > 0), m not 1
  /// @throws InputError  naming the value and its range
  MieSphere(double size_parameter, std::complex<double> refractive_index);

  double size_parameter() const { return size_parameter_; }

  /// Cross-sections over the geometric one, π r².
  double q_ext() const { return q_ext_; }
  double q_sca() const { return q_sca_; }

  /// Mean cosine of the scattering angle.
  double asymmetry() const { return asymmetry_; }

  /// Scattering amplitudes across and along the plane of scattering, dimensionless.
  struct Amplitudes {
    std::complex<double> s1;
    std::complex<double> s2;
  };

  /// @param cos_scattering_angle  [-1, 1]
  Amplitudes amplitudes(double cos_scattering_angle) const;

  /// For unpolarised light, ½∫p dμ = 1: p = 2 (|S1|² + |S2|²) / (x² Q_sca).
  double phase_function(double cos_scattering_angle) const;

  /// Coefficients of the series, a_n and b_n for n = 1 … N (index n - 1).
  const std::vector<std::complex<double>>& a() const { return a_; }
  const std::vector<std::complex<double>>& b() const { return b_; }

  /// Terms of the series, N = x + 4.6 x^(1/3) + 6: more than Wiscombe 1980 (doi:10.1364/AO.19.001505) eq. 15
  /// (4.05, 2) for the sake of the phase function's minima.
  static int terms(double size_parameter);

 private:
  double size_parameter_;
  std::vector<std::complex<double>> a_;
  std::vector<std::complex<double>> b_;
  double q_ext_ = 0.0;
  double q_sca_ = 0.0;
  double asymmetry_ = 0.0;
};

}  // namespace skylut
