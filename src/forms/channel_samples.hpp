#pragma once

#include <vector>

#include "skylut/forms/form.hpp"
#include "skylut/models/sky_channels.hpp"

namespace skylut::forms_detail {

/// Bands of a supply's spectra, each the mean over its step, with the colour weights that give the colours of
/// the skies best: those of the CIE functions, moved as little as makes the colours of the skies right (least
/// squares, so that 11 bands do the work of 81).
/// @param skies  with radiances
/// @throws InputError  if the supply has no spectra, or none of the band's wavelengths
SkyChannels band_channels(const Context& context, const SkySupply& supply, const WavelengthGrid& bands,
                          std::span<const TrainingSky> skies);

/// The values of a sky's channels: [view][channel].
/// @param wavelengths  of its radiances; only for bands
std::vector<double> channel_values(const TrainingSky& sky, const SkyChannels& channels,
                                   const WavelengthGrid* wavelengths);

}  // namespace skylut::forms_detail
