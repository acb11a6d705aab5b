#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "skylut/core/provenance.hpp"
#include "skylut/site/sun_series.hpp"
#include "skylut/sky/sky_light.hpp"
#include "skylut/sky/sun_disc.hpp"

namespace skylut {

/// One frame of a series and the light of its sky.
struct FrameRow {
  SunFrame frame;
  double direct_normal_lux = 0.0;       ///< of the beam, normal to it
  double direct_horizontal_lux = 0.0;   ///< of the beam on a horizontal plane
  double diffuse_horizontal_lux = 0.0;  ///< of the sky on a horizontal plane
  std::string file;                     ///< that holds the frame
};

/// The light of a frame: the beam is the disc's, the diffuse light the sky's integral. @param file  that
/// holds it
FrameRow frame_row(const SunFrame& frame, const SkyLight& sky, const SunDisc& disc, std::string file);

/// Name of one file of a series: its number goes before the ending, with four digits or as many as the last
/// one needs, so that names sort as numbers do: "out/sky.exr" → "out/sky_0001.exr".
/// @param index  from 1 to count
std::filesystem::path frame_file(const std::filesystem::path& name, std::size_t index, std::size_t count);

/// CSV of a series. The line that names the columns comes first: index,time,sun_zenith_deg,sun_azimuth_deg,
/// sun_distance_au,direct_normal_lux,direct_horizontal_lux,diffuse_horizontal_lux,file; then how it was made,
/// in lines that begin with '#'; then one row per frame. time is empty where the sun was given by its angles;
/// numbers are the shortest that read back exactly. @throws InputError  for a file name with a comma, a quote
/// or a line break: the format has no place for it
std::string frames_csv(std::span<const FrameRow> rows, const Provenance& provenance);

}  // namespace skylut
