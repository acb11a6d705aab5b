#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "skylut/colour/yxy.hpp"
#include "skylut/sky/limb_darkening.hpp"
#include "skylut/transfer/solved_columns.hpp"

namespace skylut {

/// What the parts of a sky's radiance are multiplied by, tabulated by scattering angle Θ on nodes even in √Θ,
/// which crowd the forward peak: 0.003° apart at 0.01°, 0.3° at 100°.
///
/// For the eye a part's factor f(Θ, λ) is written as Σ_k u_k(Θ) v_k(λ) by a truncated singular value
/// decomposition, with as many terms as keep 1e-4 of the phase function: a colour is then a sum of a few
/// products, and Rayleigh's part has two exactly.
/// Also as means over the sun's disc: its light then comes from directions up to its radius around the one
/// that Θ is counted from, weighted as the disc is dark towards its limb.
class ScatteringFactors {
 public:
  /// @param columns       whose parts are tabulated
  /// @param first_column  a column of every wavelength: those of a band share their phase functions
  ScatteringFactors(const SolvedColumns& columns, std::span<const std::size_t> first_column);

  /// The same factors as means over the disc, for Θ up to 10°: beyond, they are those of its middle to 4e-4,
  /// even where they fall as Θ⁻² (mean ρ²/4 of the Laplacian).
  /// @param darkening  [wavelength]
  ScatteringFactors over_disc(double angular_radius_deg, std::span<const LimbDarkeningLaw> darkening) const;

  /// Parts of SolvedColumns that have a factor anywhere; the last one is the diffuse light, of factor 1.
  const std::vector<std::size_t>& parts() const { return part_; }

  /// Factors at one scattering angle. @param factors  [part][wavelength]
  void spectral(double cos_scattering, std::span<float> factors) const;

  /// One term of the decomposition: of which part, and its spectrum v.
  struct Term {
    std::size_t part;              ///< index among parts()
    std::vector<double> spectrum;  ///< [wavelength]
  };
  const std::vector<Term>& terms() const { return term_; }

  /// u of every term at one scattering angle. [term]
  void terms_at(double cos_scattering, std::span<float> factors) const;

 private:
  /// Four neighbouring nodes and their weights.
  struct Stencil {
    std::size_t first;
    float weight[4];
  };
  Stencil stencil(double cos_scattering) const;
  /// Rings of the disc around directions at an angle from its middle.
  struct Ring;
  void average(std::size_t node, std::span<const Ring> rings, std::span<const LimbDarkeningLaw> darkening,
               std::span<float> mean) const;
  void decompose();
  void decompose(std::size_t part, std::span<const double> scale, std::vector<std::vector<float>>& columns);

  std::size_t wavelengths_;
  std::size_t scatterers_;
  std::vector<std::size_t> part_;
  std::vector<float> spectral_;  // [node][part][wavelength]
  std::vector<Term> term_;
  std::vector<float> at_node_;  // [node][term]
};

}  // namespace skylut
