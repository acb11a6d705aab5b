#pragma once

#include <cstdint>
#include <optional>

#include "options/options.hpp"
#include "skylut/core/context.hpp"

namespace skylut::cli {

/// How the program computes, which changes no physics: threads, instruction set, cache.
struct ComputingOptions {
  std::int64_t threads = 0;
  std::optional<Simd> simd;
  bool no_cache = false;

  void add_to(OptionSet& options);
};

/// The world around the program as the library is told of it. Only here does the program look at its
/// environment:
///   data   SKYLUT_PROFILES, else ../share/skylut/profiles beside the program, else the library's own
///   cache  $XDG_CACHE_HOME/skylut, else ~/.cache/skylut; nowhere with --no-cache
///   simd   --simd, else SKYLUT_SIMD
/// Progress goes to the terminal.
/// @throws InputError, WorkError  for an environment that names what there is not
Context program_context(const ComputingOptions& options = {});

}  // namespace skylut::cli
