#pragma once

namespace CLI {
class App;
}

/// The subcommands of the program: each adds itself and runs when it was asked for.
namespace skylut::cli {

void add_fit_command(CLI::App& program);
void add_compare_command(CLI::App& program);

}  // namespace skylut::cli
