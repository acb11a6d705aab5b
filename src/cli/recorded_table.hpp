#pragma once

#include <memory>
#include <string>

#include "scene_options.hpp"
#include "skylut/sky/sky_scene.hpp"

namespace skylut::cli {

/// What a table was made of.
struct RecordedTable {
  SkyScene scene;
  std::shared_ptr<const SceneOptions> options;
};

/// The scene that a recorded `skylut table` command describes, by the command's own options.
/// @throws InputError  for a command that is none of this version's, or names files that there are no more
RecordedTable recorded_table(const Context& context, const std::string& command_line);

}  // namespace skylut::cli
