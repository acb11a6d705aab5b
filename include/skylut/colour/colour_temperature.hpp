#pragma once

#include <optional>
#include <vector>

#include "skylut/colour/cie1931.hpp"
#include "skylut/colour/yxy.hpp"

namespace skylut {

/// Which black body looks most like a light.
struct ColourTemperature {
  double temperature_K = 0.0;  ///< correlated colour temperature, [1000, 100000]
  double duv = 0.0;  ///< distance from it in the CIE 1960 (u, v) plane; positive above the locus: greenish
};

/// The colours of black bodies, 1000 to 100 000 K: Planck's law with c2 = 0.014388 m K (ITS-90), seen by the
/// CIE 1931 observer at the table's 5 nm steps. Immutable.
class PlanckianLocus {
 public:
  explicit PlanckianLocus(const ColourMatching& matching);

  /// Chromaticity of a black body. @param temperature_K  > 0
  Yxy chromaticity(double temperature_K) const;

  /// Correlated colour temperature: of the black body whose chromaticity is nearest in the CIE 1960 (u, v)
  /// plane (CIE 15:2004), found to 1e-6 of it. Nothing where none is near: further than 0.05, beyond
  /// which it has no meaning (same source), or nearest to an end of the range: skies that are
  /// bluer than the hottest body have none.
  std::optional<ColourTemperature> nearest(const Yxy& light) const;

 private:
  struct Uv {
    double u = 0.0;
    double v = 0.0;
  };
  static Uv uv(const Yxy& light);
  double distance(const Uv& light, double per_megakelvin) const;

  std::vector<double> wavelength_nm_;
  std::vector<Xyz> observer_;
};

}  // namespace skylut
