#pragma once

#include <memory>
#include <vector>

#include "skylut/scattering/scattering_matrix.hpp"

namespace skylut {

/// Phase function of one kind of scatterer, normalised so that ½∫₋₁¹ p(cosΘ) dcosΘ = 1
/// (isotropic: p = 1). Both faces are needed: the exact value for single scattering, the Legendre
/// moments χ_l = ½∫ p P_l dcosΘ, χ_0 = 1, p = Σ (2l+1) χ_l P_l, for multiple scattering.
class PhaseFunction {
 public:
  virtual ~PhaseFunction() = default;

  /// p(cosΘ), dimensionless, for cosΘ in [-1, 1].
  virtual double value(double cos_scattering_angle) const = 0;

  /// Legendre moment χ_l, l >= 0; |χ_l| <= 1.
  virtual double moment(int l) const = 0;

  /// The whole scattering matrix, of which value() is F11. Where nothing is known of polarisation: light
  /// forwards keeps its own, F22 = F33 = F11 (1+cosΘ)²/4, and none is made.
  virtual ScatteringMatrix matrix(double cos_scattering_angle) const;

  /// Its moments of the degrees 0 … max_l; alpha1 is moment().
  virtual std::vector<MatrixMoments> matrix_moments(int max_l) const;
};

/// Rayleigh scattering with depolarisation: p = 3 [(1+3γ) + (1-γ) cos²Θ] / (4 (1+2γ)), γ = ρ/(2-ρ)
/// (Bucholtz 1995, doi:10.1364/AO.34.002765, eqs. 11-12; ρ = 0 gives ¾(1+cos²Θ)). χ_2 = (1-γ) / (10 (1+2γ)).
/// With Δ = (1-ρ)/(1+ρ/2): F12 = -¾Δ sin²Θ, F22 = ¾Δ(1+cos²Θ), F33 = 3/2 Δ cosΘ (Hansen & Travis 1974,
/// doi:10.1007/BF00168069, eqs. 2.15-2.16).
class RayleighPhaseFunction final : public PhaseFunction {
 public:
  /// @param depolarisation  depolarisation ratio ρ in [0, 0.5]; 0 for a scalar point dipole
  explicit RayleighPhaseFunction(double depolarisation = 0.0);
  double value(double cos_scattering_angle) const override;
  double moment(int l) const override;
  ScatteringMatrix matrix(double cos_scattering_angle) const override;
  std::vector<MatrixMoments> matrix_moments(int max_l) const override;

 private:
  double gamma_;
};

/// Henyey and Greenstein 1941, doi:10.1086/144246: p = (1-g²)/(1+g²-2g cosΘ)^{3/2}, χ_l = g^l.
class HenyeyGreensteinPhaseFunction final : public PhaseFunction {
 public:
  /// @param asymmetry  g in (-1, 1)
  explicit HenyeyGreensteinPhaseFunction(double asymmetry);
  double value(double cos_scattering_angle) const override;
  double moment(int l) const override;

 private:
  double asymmetry_;
};

/// A phase function given by its Legendre moments; χ_l = 0 beyond the last.
class LegendrePhaseFunction final : public PhaseFunction {
 public:
  /// @param moments  χ_0 … χ_n with χ_0 = 1 and |χ_l| <= 1
  explicit LegendrePhaseFunction(std::vector<double> moments);
  double value(double cos_scattering_angle) const override;
  double moment(int l) const override;

 private:
  std::vector<double> moments_;
};

}  // namespace skylut
