#pragma once

#include <vector>

#include "refractive_shells.hpp"
#include "sunbeam_nodes.hpp"

namespace skylut::transfer {

/// The sunbeam through a point, among shells where it is straight.
struct Sunbeam {
  double altitude_km = 0.0;  ///< of the point there
  double along_sun_km =
      0.0;  ///< radius times the cosine of the beam's local zenith angle, the apparent sun's
  /// Light on a plane normal to the beam over that above the air, but for what the way takes: the air's lens
  /// spreads it.
  double concentration = 1.0;
};

/// Which bent sunbeam reaches a point. The sun stands at a TRUE zenith angle χ there, as if light went
/// straight, and at an apparent one ψ = χ - ε, ε being the bending on the beam's way. The tables of ε have
/// SunbeamNodes, and ψ is searched. A tube of rays of impact parameter b to b + db, the axis through the
/// planet's centre, has the width r dχ cos ψ at a radius r, so that with b = n r sin ψ
///   concentration = b db/(r sin χ · r cos ψ dχ) = n² d(cos ψ)/d(cos χ);
/// n² is left out here as everywhere: radiances are those over n². [docs/refraction.md §3]
class SunRefraction {
 public:
  enum class Bending { tabulated, integrated };
  /// @param shells   must outlive this object
  /// @param bending  integrated for every beam: slower by two orders, for a few beams without the tables
  explicit SunRefraction(const RefractiveShells& shells, Bending bending = Bending::tabulated);

  /// @param altitude_km      of the point, from 0 to the top
  /// @param cos_sun_zenith  cos χ
  /// @return  of a point in the planet's shadow that of the beam which grazes the ground
  Sunbeam sunbeam(double altitude_km, double cos_sun_zenith) const;

  /// The largest χ that the ground does not hide, rad.
  double last_sun_rad(double altitude_km) const;

  /// ψ, rad; of a sun that the ground hides, lifted as the last one that it does not.
  double apparent_sun_rad(double altitude_km, double sun_rad) const;
  /// The other way round.
  double true_sun_rad(double altitude_km, double apparent_rad) const;

 private:
  double impact_km(double optical_km, double along_km) const;
  double bending(double optical_km, double along_km) const;
  double bending_from_table(double optical_km, double along_km) const;
  double true_zenith_rad(double optical_km, double along_km) const;
  double lowest_along_km(double optical_km) const;
  double concentration(double optical_km, double along_km) const;

  const RefractiveShells* shells_;
  SunbeamNodes nodes_;
  std::vector<double> from_level_;  // as SlantDepthGrid has paths; empty: integrated
  std::vector<double> from_perigee_;
};

}  // namespace skylut::transfer
