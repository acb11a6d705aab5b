#pragma once

#include <span>
#include <vector>

#include "scattering_factors.hpp"
#include "skylut/sky/solved_sky.hpp"
#include "zenith_panel.hpp"

namespace skylut {

/// A direction as a patch needs it.
struct PatchDirection {
  double cos_azimuth;     ///< relative to the sun
  double cos_scattering;  ///< of the angle to the sun
};

PatchDirection patch_direction(double zenith_deg, double relative_azimuth_deg, double sun_zenith_deg);

/// The parts of a sky's radiance in one panel of zenith angles: at every Lobatto point of the panel the
/// coefficients of a cosine series in azimuth,
///   f(x, φ) = Σ_j w_j(x) Σ_m c_jm cos mφ.
/// Layout [point][m][Stokes component][part][wavelength]; one component, I, so far.
class SkyPatch {
 public:
  /// @param points    of the panel, at least 2
  /// @param azimuths  nodes kπ/(azimuths-1), at least 1: as many cosines
  SkyPatch(ZenithPanel panel, int points, int azimuths);

  const ZenithPanel& panel() const { return panel_; }
  int points() const { return static_cast<int>(x_.size()); }
  int azimuths() const { return azimuths_; }
  double point_zenith_deg(int point) const { return panel_.zenith_deg(x_[static_cast<std::size_t>(point)]); }
  double point(int at) const { return x_[static_cast<std::size_t>(at)]; }
  const std::vector<double>& azimuths_deg() const { return azimuth_deg_; }

  /// Computes the points from lines of sight.
  void set_points(const SolvedSky& sky, double observer_km, double sun_zenith_deg);
  /// @param parts  of the lines of sight at the points, [point][part][azimuth][wavelength]
  void set_points(const SolvedSky& sky, std::span<const float> parts);
  /// The same as the eye sees them, from the points.
  void set_colours(const SolvedSky& sky);

  /// Coefficients at a zenith angle: [m][…] of the parts, or of the colours.
  void row(double zenith_deg, std::span<float> row) const { blend(spectral_, zenith_deg, row); }
  void colour_row(double zenith_deg, std::span<float> row) const { blend(colour_, zenith_deg, row); }
  std::size_t row_size() const { return spectral_.size() / x_.size(); }
  std::size_t colour_row_size() const { return colour_.size() / x_.size(); }

  /// Radiances of a row in one direction, W m⁻² sr⁻¹ nm⁻¹, [wavelength]; >= 0.
  /// @param factors  of the sky: its factors(), or those of a point
  /// @param scratch  of any size
  static void radiance(const ScatteringFactors& factors, std::span<const float> row,
                       const PatchDirection& direction, std::vector<float>& scratch,
                       std::span<float> radiance);
  /// Tristimulus values of a colour row, with the sky's factors(); >= 0.
  static Xyz colour(const SolvedSky& sky, std::span<const float> row, const PatchDirection& direction,
                    std::vector<float>& scratch);

 private:
  void blend(const std::vector<float>& coefficients, double zenith_deg, std::span<float> row) const;

  ZenithPanel panel_;
  std::vector<double> x_;
  int azimuths_;
  std::vector<double> azimuth_deg_;
  std::vector<float> spectral_;  // [point][m][part][wavelength]
  std::vector<float> colour_;    // [point][m][X, Y, Z][term]
};

}  // namespace skylut
