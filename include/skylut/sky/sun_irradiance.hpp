#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skylut/sky/simulate_sky.hpp"

namespace skylut {

struct Context;

/// A plane that faces any way.
struct TiltedPlane {
  double tilt_deg = 0.0;       ///< from the horizontal, [0, 180]: 0 faces up, 90 is a wall, 180 faces down
  double azimuth_deg = 180.0;  ///< that it faces, clockwise from north

  bool operator==(const TiltedPlane&) const = default;
};

/// What is asked beside the direct beam.
struct SunIrradianceOptions {
  bool diffuse = true;  ///< also the diffuse irradiance: needs the sun within 99° of the zenith
  double circumsolar_half_angle_deg =
      0.0;  ///< also the diffuse light within this angle of the sun, [0, 10]; 0: not
  std::optional<TiltedPlane> plane = std::nullopt;  ///< also the irradiance on it
  bool exact = false;                               ///< the sky by lines of sight instead of a ContinuousSky
};

/// Transmittance of one constituent along the sun's beam.
struct ConstituentTransmittance {
  std::string name;               ///< of the constituent
  std::vector<double> band_mean;  ///< per wavelength, [0, 1]; 0 where the ground hides the sun
};

/// Spectral irradiance at an observer, means over bands around the wavelengths, W m⁻² nm⁻¹. Lists have one
/// value per wavelength, or none for what was not asked.
struct SunIrradiance {
  WavelengthGrid wavelengths = WavelengthGrid::visible();
  Direction sun;                           ///< true
  Direction seen_sun;                      ///< apparent, where its beam comes from; true if nothing refracts
  bool beam_arrives = false;               ///< false where the ground hides the sun
  std::vector<double> extraterrestrial;    ///< normal to the beam, above the air
  std::vector<double> direct_normal;       ///< normal to the beam, without scattered light
  std::vector<double> diffuse_horizontal;  ///< from above on a horizontal plane, without the beam
  std::vector<double> circumsolar_normal;  ///< diffuse light around the sun, normal to the beam
  std::optional<TiltedPlane> plane;        ///< that the next three fall on
  std::vector<double> plane_direct;        ///< of the beam
  std::vector<double> plane_sky;           ///< diffuse, from above the horizontal
  std::vector<double> plane_ground;        ///< diffuse, from below: the ground, and the air before it
  std::vector<ConstituentTransmittance> transmittance;
  /// Lux per W m⁻² nm⁻¹, K_m V(λ) step: illuminance = Σ weight irradiance.
  std::vector<double> luminous_weight;
  std::string instruction_set;  ///< of the kernel that computed the diffuse light; empty: none

  /// Direct and diffuse light on a horizontal plane; empty without diffuse light.
  std::vector<double> global_horizontal() const;
  /// All the light on the plane; empty without a plane or diffuse light.
  std::vector<double> plane_global() const;
};

/// Irradiance of the sun and the sky at one observer. The direct beam crosses the spherical layers on a
/// straight path, or one that air with a refractivity bends as much as it does at every wavelength; each
/// constituent transmits Σ weight exp(-Σ depth · path), and their transmittances multiply. Diffuse light is
/// the solver's radiance, integrated over the sky. [docs/air.md, "Direct beam"]
/// @param scene  with one altitude, one turbidity and one sun (zenith angle 0-180; 0-99 with diffuse light);
/// its
///               directions are not used
/// @throws InputError  for values outside the ranges (never clamped)
/// @throws WorkError   if the transfer does not converge
SunIrradiance simulate_sun(const Context& context, const SkyScene& scene, const SunIrradianceOptions& options,
                           const TransferOptions& transfer);

/// @throws InputError  unless the scene has one altitude, one turbidity and one sun
void require_one_of_each(const SkyScene& scene);

/// Σ irradiance · step, W/m².
double broadband_W_m2(const std::vector<double>& irradiance, const WavelengthGrid& wavelengths);

/// Illuminance K_m Σ irradiance V(λ) step, lux; the wavelengths should span the visible range.
/// @param luminous_weight  as SunIrradiance holds it
double illuminance_lux(const std::vector<double>& irradiance, const std::vector<double>& luminous_weight);

/// K_m V(λ) step of every wavelength, lux per W m⁻² nm⁻¹.
std::vector<double> luminous_weights(const Context& context, const WavelengthGrid& wavelengths);

}  // namespace skylut
