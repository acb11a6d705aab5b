#pragma once

#include <memory>
#include <span>
#include <vector>

#include "skylut/colour/yxy.hpp"
#include "skylut/core/wavelength_grid.hpp"
#include "skylut/transfer/solved_columns.hpp"

namespace skylut {

struct Context;
struct SkyScene;
class ScatteringFactors;

/// What the sky's single scattering takes the sun for.
enum class SunShape {
  point,  ///< as lines of sight do
  disc    ///< darkened towards the limb: where the disc is drawn, its aureole must not be sharper than itself
};

/// One atmosphere with one aerosol load, solved for some suns: what all skies through it share, whatever
/// observer, sun and direction. Immutable; its functions may be called by several threads.
class SolvedSky {
 public:
  /// @param scene  with one turbidity; its suns are those that may be asked for; its altitudes and directions
  ///               are not used
  /// @param shape  of the sun in factors(); radiance() is that of a point in any case
  /// @throws InputError  for values out of range, or what does not fit the memory
  /// @throws WorkError   if the transfer does not converge
  SolvedSky(const Context& context, const SkyScene& scene, const TransferOptions& options,
            SunShape shape = SunShape::point);
  ~SolvedSky();
  SolvedSky(SolvedSky&&) noexcept;
  SolvedSky& operator=(SolvedSky&&) noexcept;

  const WavelengthGrid& wavelengths() const { return wavelengths_; }
  const Shells& shells() const { return columns_->shells(); }
  const TransferReport& report() const { return columns_->report(); }

  /// Radiance of every band, W m⁻² sr⁻¹ nm⁻¹, with the sun at its mean distance. [azimuth][wavelength]
  void radiance(const SightLine& line, std::span<float> radiance) const;

  /// The parts of which, times their factors, it is the sum (see SolvedColumns); only parts that have a
  /// factor somewhere. [line][part][azimuth][wavelength]
  void radiance_parts(std::span<const SightLine> lines, std::span<float> parts) const;
  /// The same along one line under many suns. [sun][part][azimuth][wavelength]
  void radiance_parts(const SightFan& fan, std::span<float> parts) const;
  std::size_t parts() const;

  /// The parts' factors by scattering angle, spectrally and as the eye sees them.
  const ScatteringFactors& factors() const { return averaged_factors_ ? *averaged_factors_ : *factors_; }
  /// Those of a point, with which the parts add up to radiance().
  const ScatteringFactors& factors_of_point() const { return *factors_; }

  /// CIE 1931 tristimulus values of a unit of radiance at each wavelength: colour is their weighted sum.
  const std::vector<Xyz>& colour_weights() const { return colour_weights_; }

 private:
  /// From [part of the columns][azimuth][column] to [part][azimuth][wavelength].
  void collect(std::span<const float> of_columns, std::size_t azimuths, std::span<float> parts) const;

  WavelengthGrid wavelengths_;
  std::unique_ptr<SolvedColumns> columns_;
  std::vector<std::size_t> first_column_;  // [wavelength], and one past the last
  std::vector<float> column_weight_;       // solar irradiance times the column's share of its band
  std::vector<Xyz> colour_weights_;
  std::unique_ptr<const ScatteringFactors> factors_;
  std::unique_ptr<const ScatteringFactors> averaged_factors_;  // over the sun's disc; none: not wanted
};

}  // namespace skylut
