#pragma once

#include <filesystem>
#include <string>

#include "picture_options.hpp"
#include "scene_options.hpp"
#include "skylut/site/sun_series.hpp"

namespace skylut::cli {

/// What `skylut map` draws pictures of.
struct PictureJob {
  SceneOptions scene_options;
  PictureRequest request;
  SkyScene scene;  ///< with the suns of all frames, which have their distances themselves
  std::filesystem::path out;
  std::filesystem::path times_file;  ///< that the suns were taken from; empty: none
  std::string command;               ///< that makes the pictures again
};

/// One picture, with its facts on the screen.
void write_picture(const Context& context, const PictureJob& job, const SunFrame& sun);

/// Numbered pictures and beside them a CSV of the frames' light: sky_0001.exr …, sky.csv.
/// @param only  that frame alone, without the CSV; 0: all
void write_series(const Context& context, const PictureJob& job, const SunSeries& series, std::size_t only);

}  // namespace skylut::cli
