#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "skylut/core/provenance.hpp"
#include "skylut/export/projection.hpp"
#include "skylut/sky/sky_light.hpp"
#include "skylut/sky/sun_disc.hpp"

namespace skylut {

struct Context;

struct PreviewOptions {
  ProjectionChoice projection;  ///< its size is the preview's own; "cube" is shown as "cube-cross"
  /// Luminance that becomes middle grey (0.18 before the tone curve's shoulder), cd/m²; none: the sky's own,
  /// the mean of its logarithm over the solid angle.
  std::optional<double> middle_grey_cd_m2;
};

/// A picture to look at: 8 bits a channel, sRGB.
///
/// Tone curve: Reinhard et al., "Photographic tone reproduction for digital images", ACM TOG 21(3), 2002 (doi
/// 10.1145/566654.566575), eqs. 1, 2 and 4 on the luminance, chromaticities kept:
///   L = 0.18 Y / Y_grey,  D = L (1 + L/L_white²)/(1 + L),
/// L_white being the brightest pixel, so that nothing is clipped. Colours outside Rec. 709, or too saturated
/// for their brightness, are mixed with D65 white of the same luminance D until every channel lies within 0
/// to 1: luminance and, nearly, hue stay, saturation gives way.
struct Preview {
  std::string png;  ///< the file's bytes
  int width = 0;
  int height = 0;
  double middle_grey_cd_m2 = 0.0;
  double white_cd_m2 = 0.0;     ///< luminance that is shown as white
  std::size_t desaturated = 0;  ///< pixels that mixing with white changed by more than 1/255

  /// One line for the screen; it stands in the file, too (tEXt "Comment", beside "Software" and "Source", the
  /// command).
  std::string description;
};

/// Computes the preview from a picture of its own size.
/// @param disc  shown with the sky; none: the sky alone
/// @throws InputError  for an unknown projection, a size or a middle grey out of range
/// @throws Cancelled   if context.cancel was asked
Preview make_preview(const Context& context, const SkyLight& sky, const PreviewOptions& options,
                     const Provenance& provenance, const SunDisc* disc = nullptr);

}  // namespace skylut
