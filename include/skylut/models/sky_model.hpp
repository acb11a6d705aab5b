#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/colour/yxy.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/wavelength_grid.hpp"

namespace skylut {

/// What a sky depends on.
struct SkyConditions {
  double altitude_km = 0.0;  ///< of the observer, above the ground
  Turbidity turbidity;       ///< in the kind that the model takes, see ModelInfo
  double albedo = 0.2;       ///< of the ground, [0, 1]; models without one leave it aside
  Direction sun;
};

/// One sky: its colours for any view, with the coefficients already worked out.
class Sky {
 public:
  virtual ~Sky() = default;

  /// @param views    [n] directions, zenith angle within the model's
  /// @param colours  [n], filled: Y in cd/m², without the solar disc
  /// @throws InputError  for a view outside, never clamped, and if n differs
  virtual void colour(std::span<const Direction> views, std::span<Yxy> colours) const = 0;

  Yxy colour(const Direction& view) const {
    Yxy colour;
    this->colour({&view, 1}, {&colour, 1});
    return colour;
  }

  /// The wavelengths at which the model has spectra; null if it knows colours only.
  virtual const WavelengthGrid* wavelengths() const { return nullptr; }

  /// @param radiance  [view][wavelength], filled: W m⁻² sr⁻¹ nm⁻¹, without the solar disc
  /// @throws InputError  as colour(); and if the model knows colours only
  virtual void radiance(std::span<const Direction> views, std::span<float> radiance) const;

 protected:
  Sky() = default;
  Sky(const Sky&) = default;
  Sky& operator=(const Sky&) = default;
};

/// What a model is and what its source vouches for. Formulas may give values beyond; SkyModel::at says where
/// they stop.
struct ModelInfo {
  std::string name;        ///< as on the command line, "preetham1999"
  std::string title;       ///< "Preetham, Shirley, Smits 1999"
  std::string source;      ///< DOI, or where its numbers come from
  std::string quantities;  ///< "Y, x, y"
  Range altitude_km;
  TurbidityKind turbidity_kind = TurbidityKind::aod500;
  Range turbidity;
  std::optional<Range> albedo = {};  ///< none: the model has one ground, whatever it is
  Range sun_zenith_deg;
  Range view_zenith_deg;
};

/// A way to get skies from conditions. Published models, simulations and fitted tables share this interface
/// so that any two of them can be compared.
class SkyModel {
 public:
  virtual ~SkyModel() = default;

  virtual const ModelInfo& info() const = 0;

  /// @throws InputError  for conditions that the model gives nothing for, never clamped, and for a turbidity
  /// of
  ///                     another kind than info().turbidity_kind (from_aod500 converts)
  virtual std::unique_ptr<const Sky> at(const SkyConditions& conditions) const = 0;

 protected:
  SkyModel() = default;
  SkyModel(const SkyModel&) = default;
  SkyModel& operator=(const SkyModel&) = default;
};

}  // namespace skylut
