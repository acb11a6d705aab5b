#pragma once

namespace CLI {
class App;
}

/// The subcommands of the program, one file each: command_<name>.cpp. Each adds itself with its options
/// and runs when it was asked for, once all its options are read.
namespace skylut::cli {

/// `skylut table --out DIR`: simulate, fit, write the coefficient table.
void add_table_command(CLI::App& program);

/// `skylut map -o sky.exr|sky.csv`: one sky.
void add_map_command(CLI::App& program);

/// `skylut solve CASE.json`: radiative transfer through explicit layers.
void add_solve_command(CLI::App& program);

}  // namespace skylut::cli
