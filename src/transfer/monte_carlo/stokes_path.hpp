#pragma once

#include <array>

#include "shell_walk.hpp"
#include "skylut/scattering/phase_function.hpp"

namespace skylut::monte_carlo {

/// I, Q, U.
using Stokes = std::array<double, 3>;

/// What a photon carries where light is polarised. Followed backwards it does not carry Stokes parameters but
/// the product M₁ M₂ … of the matrices of its collisions, observer first: what becomes, at the observer, of
/// light that arrives where the photon is now (Collins et al. 1972, doi:10.1364/AO.11.002684; Emde et al.
/// 2010, doi:10.5194/acp-10-383-2010, §2.2). Sunlight is unpolarised, so each collision adds the product
/// times the first column of its own matrix.
///
/// Every piece of the path has two axes across its direction d (d points against the light): Q = I along the
/// first minus along the second, U > 0 along their sum; first × second = -d. The observer's are towards the
/// zenith and towards increasing azimuth; behind a collision, in its plane of scattering and across it.
class StokesPath {
 public:
  using Law = ScatteringMatrix;
  using Found = Stokes;

  static Law law(const PhaseFunction& phase, double cos_angle) { return phase.matrix(cos_angle); }
  static void add(Law& sum, double share, const Law& law);

  /// @param view  unit vector in which the observer, at (0, 0, r), looks; straight up or down: in the plane
  /// of azimuth given by the next
  /// @param azimuth_deg  of the view
  StokesPath(const Vector& view, double azimuth_deg);

  /// Of unpolarised light; no smaller than what any polarised light of the same I becomes, halved.
  double weight() const { return product_[0][0]; }
  void divide_weight(double divisor);

  /// Adds light of the sun scattered here: law / 4π × transmitted.
  void find_scattered(const Vector& direction, const Vector& to_sun, const Law& law, double transmitted);
  /// Adds unpolarised light of the given radiance from the ground.
  void find_reflected(double radiance);

  /// The light scattered here came along -after, and goes on along -before.
  void scatter(const Vector& before, const Vector& after, double albedo, const Law& law, double density);
  /// Lambertian ground: what it sends out is unpolarised, whatever has come in.
  void reflect(const Vector& after, double factor);

  /// sr⁻¹
  Found found(double first_weight) const;

 private:
  /// Twice the angle from the axes of a plane of scattering (in it, across it) to those carried.
  struct Turn {
    double cosine = 1.0;
    double sine = 0.0;
  };
  Turn turn_to(const Vector& direction, const Vector& across) const;
  void take_axes(const Vector& direction, const Vector& across);

  std::array<std::array<double, 3>, 3> product_{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  Vector first_axis_{};
  Vector second_axis_{};
  Stokes found_{};
};

}  // namespace skylut::monte_carlo
