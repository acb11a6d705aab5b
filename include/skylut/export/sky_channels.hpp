#pragma once

namespace skylut {

/// What the channels of an OpenEXR picture of a sky hold. Each kind goes to a file of its own, because
/// readers that expect R,G,B misread or refuse a file that has anything else.
enum class SkyChannels {
  rgb,        ///< R,G,B: linear, in one of rgb_spaces(), cd m⁻²
  xyz,        ///< X,Y,Z: CIE 1931 2°, Y in cd m⁻²
  luminance,  ///< Y: cd m⁻²
  spectral  ///< S0.<nm>nm: W m⁻² sr⁻¹ nm⁻¹, with an R,G,B preview (Fichet, Pacanowski & Wilkie 2021,
            ///< JCGT 10(3))
};

}  // namespace skylut
