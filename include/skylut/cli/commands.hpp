#pragma once

#include <CLI/CLI.hpp>

namespace skylut::cli {

/// `skylut profile list` and `skylut profile show NAME`.
void add_profile_command(CLI::App& program);

}  // namespace skylut::cli
