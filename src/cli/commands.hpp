#pragma once

namespace CLI {
class App;
}

/// The subcommands of the program, one file each: command_<name>.cpp.
namespace skylut::cli {

/// `skylut solve CASE.json`: radiative transfer through explicit layers.
void add_solve_command(CLI::App& app);

}  // namespace skylut::cli
