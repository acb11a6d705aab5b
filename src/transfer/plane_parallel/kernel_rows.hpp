#pragma once

#include <Eigen/Core>

#include "layer_modes.hpp"

namespace skylut::plane_parallel {

/// Half of the scattering kernel of one Fourier mode as a sum of squares: Σ_k weight_k row_k row_kᵀ.
struct KernelRows {
  Eigen::MatrixXd nodes;   ///< row k at the ordinates
  Eigen::MatrixXd views;   ///< at the views
  Eigen::VectorXd sun;     ///< for the unpolarised beam
  Eigen::VectorXd weight;  ///< ω (2l+1) χ_l and the like, any sign
};

/// The half that acts on the sum σ of both hemispheres (parity 0) or on their difference δ (1).
///
/// Without polarisation: Λ_lm with l+m even, or odd. With it, Π_l(μ) = [[Λ,0,0],[0,R,-T],[0,-T,R]],
/// B_l = [[χ,β1,0],[β1,α2,0],[0,0,α3]] and D = diag(1,1,-1): Π_l(-μ) = (-1)^{l+m} D Π_l(μ) D and D B = B D,
/// so that for D ι⁻ in place of ι⁻ the kernels of sum and difference are Π B (1 ± (-1)^{l+m} D) Π / 2: of
/// B_l, the block of I and Q goes where l+m has the parity, α3 where it has not. The block is diagonalised,
/// so that each degree gives two rows and one in place of one.
KernelRows kernel_rows(const LayerOptics& optics, const Ordinates& ordinates, int parity);

/// Whether the material scatters anything at all in this mode.
bool scatters_in_mode(const LayerOptics& optics, const Ordinates& ordinates);

}  // namespace skylut::plane_parallel
