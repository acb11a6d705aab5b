#pragma once

#include <span>
#include <vector>

#include "skylut/colour/yxy.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/core/wavelength_grid.hpp"
#include "skylut/sky/limb_darkening.hpp"
#include "skylut/sky/sky_scene.hpp"

namespace skylut {

struct Context;

/// Angle between the centre and the limb of the sun: 959.63″ at 1 au (Auwers 1891, Astronomische Nachrichten
/// 128, 361; what almanacs use), its sine inversely as the distance. @param distance_au  >= 0.01
double sun_angular_radius_deg(double distance_au);

/// Solid angle of the whole disc, sr; 6.80e-5 at 1 au.
double sun_solid_angle_sr(double distance_au);

/// The disc's light as points, each with the irradiance normal to the beam that its part of the disc sends.
struct SunDiscPoints {
  std::vector<Direction> directions;
  std::vector<double> irradiance;  ///< [point][wavelength], W m⁻² nm⁻¹: radiance times solid angle
  std::vector<Xyz> illuminance;    ///< [point], lux: the same as tristimulus values
};

/// The sun's disc as one observer sees it through the air: darkened towards the limb, weakened by the air
/// more at its lower edge than at its upper one, cut by the horizon. Air with a refractivity lifts and
/// flattens it, at all wavelengths alike. Light scattered around it is the sky's. Immutable; calls may run in
/// parallel.
///
/// The light from the whole disc, ∫ L dω, is the direct normal irradiance of simulate_sun, which takes the
/// disc for a point: within 2e-5 for a sun to 60° from the zenith, 0.4 % at 85°. As it sets, the disc's
/// upper part sends most light: 3 % more in all at 89°, 7 % at 89.5°; at 90° the upper half alone sends 12 %
/// less (illuminance, aerosol optical depth 0.1, from the ground). [docs/air.md, "The disc"]
class SunDisc {
 public:
  /// @param scene  with one altitude, one turbidity and one sun (zenith angle 0-180); its directions are not
  ///               used
  /// @throws InputError  for values out of range
  SunDisc(const Context& context, const SkyScene& scene);

  const WavelengthGrid& wavelengths() const { return wavelengths_; }
  Direction sun() const { return sun_; }  ///< true
  double angular_radius_deg() const { return angular_radius_deg_; }

  double solid_angle_sr() const { return solid_angle_sr_; }  ///< of the whole disc

  /// Solid angle of what stands above the horizon, sr; 0 where the ground hides all of it.
  double visible_solid_angle_sr() const { return visible_solid_angle_sr_; }
  /// Part of the disc that stands above the horizon, [0, 1]: of the disc as it is, before it is flattened.
  double visible_part() const { return visible_true_sr_ / solid_angle_sr_; }

  /// ∫ L dω over what is visible, W m⁻² nm⁻¹, per wavelength: irradiance normal to the beam. (The cosine
  /// between a ray of the disc and its centre is taken as 1; it is 0.99999 at the limb.)
  const std::vector<double>& direct_normal() const { return direct_normal_; }
  /// The same as tristimulus values, lux.
  Xyz illuminance() const { return to_colour(direct_normal_); }

  /// @param directions  where the observer looks, zenith angle [0, 180]
  /// @param radiance    W m⁻² sr⁻¹ nm⁻¹, [direction][wavelength]; 0 beside the disc and below the horizon
  void radiance(std::span<const Direction> directions, std::span<float> radiance) const;

  /// @param colour  CIE 1931 tristimulus values in cd/m², [direction]
  void colour(std::span<const Direction> directions, std::span<Xyz> colour) const;

  /// Points that hold all the disc's light: their irradiances sum to direct_normal() whatever the spacing, so
  /// that a picture which adds each point to the pixel that holds it has the disc's energy, however coarse or
  /// fine it is. None where the ground hides the disc. Always the same for the same arguments.
  /// @param spacing_deg  neighbours are no further apart, [0.002, 1]. Some (5 r / spacing)² points, r the
  ///                     disc's radius, 0.27 deg
  /// @throws InputError  for a spacing out of range
  SunDiscPoints points(double spacing_deg) const;

 private:
  struct Place;  // on the disc
  struct Node;   // of a quadrature
  void fill_transmittance(const Atmosphere& air, double altitude_km, double aod500, double top_deg,
                          double bottom_deg);
  std::vector<Node> quadrature(int order) const;
  double lowest_y() const;  ///< of what the horizon leaves, in radii above the centre
  Direction direction_of(const Place& place) const;  ///< true
  Direction seen(const Direction& sun) const;        ///< apparent direction of a point of the disc
  double concentration(double sun_zenith_deg) const;
  /// Radiance at μ, in the direction of that zenith angle, which is held at the horizon.
  void spectrum(double mu, double zenith_deg, std::span<double> radiance) const;
  Xyz to_colour(std::span<const double> spectrum) const;
  /// μ where the line of sight meets the sun; negative where it does not, or where the ground hides it.
  double visible_mu(const Direction& direction) const;

  WavelengthGrid wavelengths_;
  Direction sun_;
  double angular_radius_deg_;
  double solid_angle_sr_;
  double horizon_zenith_deg_;  ///< apparent
  double last_sun_deg_;        ///< true zenith angle of what stands on the horizon
  bool bends_ = false;
  double visible_solid_angle_sr_ = 0.0;
  double visible_true_sr_ = 0.0;             ///< the same without refraction's flattening
  std::vector<LimbDarkeningLaw> darkening_;  // per wavelength
  std::vector<double> mean_above_air_;       // mean radiance of the disc above the air, per wavelength
  std::vector<Xyz> colour_weight_;           // per wavelength
  std::vector<double> zenith_deg_;           // of transmittance_, apparent, ascending; none: all is hidden
  std::vector<double> true_deg_;             // the same, true; none: nothing bends
  std::vector<double> concentration_;        // there
  std::vector<double> transmittance_;        // [zenith angle][wavelength]
  std::vector<double> direct_normal_;        // per wavelength
};

}  // namespace skylut
