#pragma once

#include <Eigen/Core>

#include "polarised_functions.hpp"
#include "scaled_medium.hpp"

namespace skylut::plane_parallel {

/// The discrete ordinates of one hemisphere and what a Fourier mode m needs at them.
///
/// Double-Gauss nodes μ_i with weights w_i on (0, 1]. Vectors are kept in the scaled form
/// ι = (wμ)^½ I, in which reflection and transmission are symmetric matrices (reciprocity).
///
/// Polarised, a vector holds I at all nodes, then Q, then U, and U of the light that goes down with its sign
/// changed: then both hemispheres have the same equations, as without polarisation (kernel_rows.hpp).
struct Ordinates {
  bool polarised = false;
  Eigen::VectorXd mu;             ///< N nodes, ascending; polarised: three times
  Eigen::VectorXd flux_root;      ///< (wμ)^½: irradiance = 2π Σ flux_root ι; 0 for Q and U
  int mode = 0;                   ///< m
  Eigen::MatrixXd legendre;       ///< z_l = Λ_lm(μ_i) (w_i/μ_i)^½, rows l = m …
  Eigen::VectorXd legendre_sun;   ///< Λ_lm(μ0)
  Eigen::MatrixXd legendre_view;  ///< Λ_lm(|μ_view|), columns are views
  PolarisedFunctions functions;   ///< at the nodes, with the same factor; empty unless polarised
  PolarisedFunctions functions_view;
};

/// General solution of one material in Fourier mode m. With σ = ι⁺+ι⁻ and δ = ι⁺-ι⁻ (up, down) the
/// transfer equation is, τ downward,
///   σ' = A δ - α e^{-λτ},  A = 1/μ - ω Σ_{l+m odd}  (2l+1) χ_l z_l z_lᵀ
///   δ' = B σ - β e^{-λτ},  B = 1/μ - ω Σ_{l+m even} (2l+1) χ_l z_l z_lᵀ,   λ = 1/μ0
/// (Nakajima & Tanaka 1986). With A = LLᵀ and LᵀBL = V K² Vᵀ: σ = G x(τ), δ = H x'(τ), x'' = K² x,
/// G = LV, H = L⁻ᵀV, GᵀH = 1. Only K² enters, so conservative scattering (K = 0) is no special case.
struct LayerModes {
  bool scatters = false;             ///< false: nothing scatters in this mode, the rest is empty
  Eigen::VectorXd rate;              ///< K, 1/optical depth, >= 0
  Eigen::MatrixXd sum_modes;         ///< G
  Eigen::MatrixXd difference_modes;  ///< H
  double beam_rate = 0.0;            ///< λ, moved by 2e-7 of itself if it meets a rate (resonance)
  Eigen::VectorXd beam_sum;          ///< σ of the particular solution at unit beam, × e^{-λτ}
  Eigen::VectorXd beam_difference;   ///< δ of the same
  /// Source function towards the views: J(±μ) = even·(σ part) ± odd·(δ part), as rows per view; polarised:
  /// I of all views, Q, then U.
  Eigen::MatrixXd view_even;       ///< × x
  Eigen::MatrixXd view_odd;        ///< × x'
  Eigen::VectorXd view_beam_even;  ///< × e^{-λτ}; light scattered at least twice
  Eigen::VectorXd view_beam_odd;
};

/// Solves the eigenproblem of one material for one Fourier mode. @param cos_sun μ0
/// @throws WorkError  for moments that no phase function >= 0 has
LayerModes solve_layer_modes(const LayerOptics& optics, const Ordinates& ordinates, double cos_sun);

/// Nodes, weights and Legendre functions for Fourier mode m.
Ordinates make_ordinates(int streams, int mode, double cos_sun, const Eigen::VectorXd& cos_views,
                         bool polarised);

}  // namespace skylut::plane_parallel
