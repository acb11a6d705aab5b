#pragma once

#include <functional>
#include <string>
#include <vector>

#include "options.hpp"

namespace skylut::cli {

/// One command of the program, or the program itself: what it is called, its options, and what it does.
struct Command {
  std::string name;
  std::string summary;
  std::string notes;                  ///< in --help after the options; may be empty
  std::vector<std::string> examples;  ///< command lines that run as they are, in this order, in one folder
  OptionSet options;
  /// Called once all options are read. Empty where one of the subcommands must be chosen.
  std::function<void(const OptionSet& options)> run;
  std::vector<Command> subcommands;
};

/// Reads the arguments, and shows help or runs the command that they choose.
/// @throws InputError  unknown command or option (saying which was probably meant), a value that is missing,
///                     given twice or not as the option's kind demands
void run_command_line(Command& program, int argc, const char* const* argv);

}  // namespace skylut::cli
