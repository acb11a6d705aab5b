#pragma once

namespace skylut {

/// What scattering does to the Stokes parameters I, Q, U of light, Q and U counted from the plane of
/// scattering (Q = I in the plane minus I across it):
///   I' = F11 I + F12 Q,  Q' = F12 I + F22 Q,  U' = F33 U,
/// normalised as the phase function, which F11 is. V, and with it F34 and F44, is left out: light of the sun
/// becomes circular by two scatterings at least, the last of them by large particles, and what it gives back
/// is of the order of 1e-5 of I. [docs/polarisation.md]
struct ScatteringMatrix {
  double f11 = 0.0;
  double f12 = 0.0;
  double f22 = 0.0;
  double f33 = 0.0;
};

/// Moments of a scattering matrix of degree l with the generalised spherical functions d^l_mn
/// (core/generalised_legendre.hpp; de Rooij & van der Stap 1984; Hovenier & van der Mee 1983):
///   alpha1 = ½∫ F11 P_l dμ,  beta1 = ½∫ F12 d^l_02 dμ,  alpha2 ± alpha3 = ½∫ (F22 ± F33) d^l_2,±2 dμ,
/// so that F11 = Σ (2l+1) alpha1 P_l, and so on. All but alpha1 are 0 for l < 2.
struct MatrixMoments {
  double alpha1 = 0.0;
  double alpha2 = 0.0;
  double alpha3 = 0.0;
  double beta1 = 0.0;
};

}  // namespace skylut
