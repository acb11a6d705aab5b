#pragma once

#include <cstddef>
#include <optional>

#include "skylut/core/wavelength_grid.hpp"
#include "skylut/models/model_file.hpp"
#include "skylut/sky/sky_scene.hpp"

namespace skylut {

struct Context;

struct CompactFormOptions {
  /// Root mean square relative error of a sky's luminance that is aimed at for half of all skies by day,
  /// [5e-4, 0.02]: it chooses the rank. What came out is measured and stated in the file.
  double error = 0.0035;
  double most_aod500 = 1.0;             ///< the end of the loads, [0.1, 5]
  std::optional<WavelengthGrid> bands;  ///< that the model has spectra of
  std::size_t held_out = 24;            ///< skies at which the error is measured that the file states
};

/// Makes the form `skylut` from an atmosphere: skies at all altitudes from 0 to 30 km, loads, albedos and
/// suns from 0 to 96°. [docs/models.md]
/// @param scene  its atmosphere, solar spectrum and wavelengths; altitudes, turbidities, suns are the form's
/// @throws InputError  for options out of range
/// @throws Cancelled   when the context asks to stop
ModelFile fit_compact_sky(const Context& context, const SkyScene& scene, const CompactFormOptions& options,
                          const TransferOptions& transfer);

}  // namespace skylut
