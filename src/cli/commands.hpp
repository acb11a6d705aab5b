#pragma once

namespace CLI {
class App;
}

/// The subcommands of the program: each adds itself and runs when it was asked for, once all its
/// options are read.
namespace skylut::cli {

void add_table_command(CLI::App& program);
void add_map_command(CLI::App& program);
void add_fit_command(CLI::App& program);
void add_compare_command(CLI::App& program);

}  // namespace skylut::cli
