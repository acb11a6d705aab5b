#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/colour/yxy.hpp"
#include "skylut/forms/dome_views.hpp"
#include "skylut/models/sky_model.hpp"
#include "skylut/sky/sky_scene.hpp"

namespace skylut {

struct Context;

/// A sky that a form asks for.
struct SoughtSky {
  double altitude_km = 0.0;
  Turbidity turbidity;           ///< of whatever kind
  std::optional<double> albedo;  ///< none: the supply's own ground, which may have a spectrum
  Direction sun;
};

/// A sky that a form is fitted to, or that its model is measured against.
struct TrainingSky {
  SoughtSky conditions;
  DomeViews dome;
  std::vector<Yxy> colours;     ///< [view], Y in cd/m²
  std::vector<float> radiance;  ///< [view][wavelength], W m⁻² sr⁻¹ nm⁻¹; empty: only colours are known
};

/// The conditions that the input stands for, each axis ascending.
struct SkyAxes {
  std::vector<double> altitudes_km;
  TurbidityKind turbidity_kind = TurbidityKind::aod500;
  std::vector<double> turbidities;
  std::vector<double> sun_zeniths_deg;
};

/// Where a form gets its skies from.
class SkySupply {
 public:
  using ViewsUnderSun = std::function<DomeViews(const Direction& sun)>;

  virtual ~SkySupply() = default;

  virtual const SkyAxes& axes() const = 0;
  /// Of the radiances; null: it knows colours only.
  virtual const WavelengthGrid* wavelengths() const = 0;
  /// Whether it has skies for any conditions and views, or only those that it was given.
  virtual bool simulates() const = 0;

  /// The skies of the input's own conditions. @param views  where its skies are simulated for them
  virtual std::vector<TrainingSky> given(const Context& context, const ViewsUnderSun& views) const = 0;

  /// Skies for any conditions, in the order of the requests.
  /// @throws InputError  saying what input would be right, if it does not simulate
  virtual std::vector<TrainingSky> simulated(const Context& context, std::span<const SoughtSky> requests,
                                             const ViewsUnderSun& views) const = 0;

  /// The air and its light, and how finely it is solved, of a supply that simulates.
  struct Air {
    const SkyScene& scene;
    const TransferOptions& options;
  };
  virtual std::optional<Air> air() const { return {}; }

  /// Of the ground, if it is a number.
  virtual std::optional<double> albedo() const = 0;

 protected:
  SkySupply() = default;
  SkySupply(const SkySupply&) = default;
  SkySupply& operator=(const SkySupply&) = default;
};

}  // namespace skylut
