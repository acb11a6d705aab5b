#pragma once

#include "skylut/core/context.hpp"

namespace skylut::cli {

/// The world as the program finds it: data from the folder that the environment variable SKYLUT_PROFILES
/// names, else from ../share/skylut/profiles beside the program, else the library's own default; results of
/// Mie's theory kept in $XDG_CACHE_HOME/skylut, else ~/.cache/skylut.
/// @throws WorkError  if SKYLUT_PROFILES names no folder
Context program_context();

}  // namespace skylut::cli
