#include <CLI/CLI.hpp>

#include "command.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"
#include "skylut/core/version.hpp"

/// The door to CLI11: the only file that knows it. CLI11 splits the arguments and lays out --help; values are
/// read by the options themselves.
namespace skylut::cli {

namespace {

// An option of ours with what CLI11 found for it.
struct Entry {
  Option* option;
  CLI::Option* found;
};

// A command of ours with its mirror in CLI11.
struct Mirror {
  Command* command;
  CLI::App* app;
  std::string path;  // "skylut profile case"
  std::vector<Entry> entries;
  std::vector<Mirror> subcommands;
};

std::string footer_of(const Command& command) {
  std::string text;
  if (!command.notes.empty()) text += "\n" + command.notes;
  if (!command.examples.empty()) text += command.examples.size() == 1 ? "\nExample:" : "\nExamples:";
  for (const std::string& example : command.examples) text += "\n  " + example;
  return text;
}

Entry declared(CLI::App& app, Option& option) {
  const std::string names = option.short_name.empty() ? option.name : option.short_name + "," + option.name;
  const std::string help = option.help + (option.required ? " (required)" : "");
  CLI::Option* found = nullptr;
  if (option.is_flag()) {
    found = app.add_flag(names, help);
  } else {
    found = app.add_option(
        names, [](const CLI::results_t&) { return true; }, help);
    found->expected(1)->type_name(option.placeholder)->default_str(option.default_text);
  }
  // Whether it may be given several times is for us to say.
  found->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  if (!option.is_argument()) found->group(option.group);
  return {&option, found};
}

Mirror mirrored(Command& command, CLI::App& app, const std::string& path) {
  Mirror mirror{&command, &app, path, {}, {}};
  app.footer(footer_of(command));
  app.allow_extras();  // we say what is wrong with them
  for (Option& option : command.options.all()) mirror.entries.push_back(declared(app, option));
  for (Command& subcommand : command.subcommands)
    mirror.subcommands.push_back(mirrored(
        subcommand, *app.add_subcommand(subcommand.name, subcommand.summary), path + " " + subcommand.name));
  return mirror;
}

const Mirror& chosen(const Mirror& mirror) {
  for (const Mirror& subcommand : mirror.subcommands)
    if (subcommand.app->parsed()) return chosen(subcommand);
  return mirror;
}

std::vector<std::string> option_names(const Mirror& mirror) {
  std::vector<std::string> names{"--help"};
  for (const Entry& entry : mirror.entries)
    if (!entry.option->is_argument()) names.push_back(entry.option->name);
  return names;
}

std::vector<std::string> command_names(const Mirror& mirror) {
  std::vector<std::string> names;
  for (const Mirror& subcommand : mirror.subcommands) names.push_back(subcommand.command->name);
  return names;
}

std::string see_help(const Mirror& mirror) { return fmt::format(" (see {} --help)", mirror.path); }

void refuse_what_is_unknown(const Mirror& mirror) {
  const std::vector<std::string> extras = mirror.app->remaining();
  for (const std::string& extra : extras)
    if (extra.starts_with('-') && extra.size() > 1) {
      const std::string name = extra.substr(0, extra.find('='));
      throw InputError("{}: unknown option{}{}", name, suggested(name, option_names(mirror)),
                       see_help(mirror));
    }
  if (!mirror.subcommands.empty()) {
    const std::string names = listed(command_names(mirror));
    if (extras.empty())
      throw InputError("{}: needs a subcommand: {}{}", mirror.path, names, see_help(mirror));
    throw InputError("command '{}': must be one of {}{}", extras.front(), names,
                     suggested(extras.front(), command_names(mirror)));
  }
  if (!extras.empty()) throw InputError("'{}': belongs to no option{}", extras.front(), see_help(mirror));
}

// Long lists would bury what is wrong with them.
std::string shortened(const std::string& text) {
  constexpr std::size_t kMost = 80;
  return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

// Control characters would break the comment lines of the files that record a command.
void refuse_control_characters(const Option& option, const std::string& text) {
  for (const char character : text)
    if (static_cast<unsigned char>(character) < 0x20 || character == 0x7f)
      throw InputError("{}: must not hold a control character", option.typed_name());
}

void read(const Mirror& mirror, const Entry& entry) {
  Option& option = *entry.option;
  const std::vector<std::string>& texts = entry.found->results();
  if (texts.empty()) {
    if (option.required) throw InputError("{} is required{}", option.typed_name(), see_help(mirror));
    return;
  }
  option.given = true;
  if (option.is_flag()) {
    if (texts.front() != "true")
      throw InputError("{}: takes no value{}", option.typed_name(), see_help(mirror));
    return option.read("");
  }
  if (texts.size() > 1 && !option.repeatable)
    throw InputError("{}: must be given once, not {} times", option.typed_name(), texts.size());
  const std::string text = CLI::detail::join(texts, ",");
  for (const std::string& name : option_names(mirror))
    if (text == name) throw InputError("{}: its value is missing before {}", option.typed_name(), name);
  refuse_control_characters(option, text);
  try {
    option.read(text);
  } catch (const InputError& error) {
    throw InputError("{} '{}': {}", option.typed_name(), shortened(text), error.what());
  }
}

// "help", "help map" and "version", in words as well as in options.
std::vector<std::string> without_words_for_options(int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (arguments.empty()) return arguments;
  const std::string first = arguments.front();
  if (first == "help") {
    arguments.erase(arguments.begin());
    arguments.push_back("--help");
  }
  if (first == "version" || first == "-v" || first == "-V") return {"--version"};
  return arguments;
}

[[noreturn]] void refuse_missing_value(const Mirror& mirror, const std::string& message) {
  throw InputError("{}: its value is missing{}", message.substr(0, message.find(':')), see_help(mirror));
}

}  // namespace

void run_command_line(Command& program, int argc, const char* const* argv) {
  CLI::App app{program.summary, program.name};
  app.set_version_flag("--version", program.name + " " + kVersion);
  const Mirror root = mirrored(program, app, program.name);
  std::vector<std::string> arguments = without_words_for_options(argc, argv);
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the end
  try {
    app.parse(arguments);
  } catch (const CLI::CallForHelp&) {
    if (const Mirror& helped = chosen(root); !helped.app->remaining().empty()) refuse_what_is_unknown(helped);
    fmt::print("{}", app.help());
    return;
  } catch (const CLI::Success& version) {
    app.exit(version);
    return;
  } catch (const CLI::ArgumentMismatch& error) {
    refuse_missing_value(chosen(root), error.what());
  } catch (const CLI::ParseError& error) {
    throw InputError("{}{}", error.what(), see_help(chosen(root)));
  }
  const Mirror& command = chosen(root);
  refuse_what_is_unknown(command);
  for (const Entry& entry : command.entries) read(command, entry);
  command.command->run(command.command->options);
}

}  // namespace skylut::cli
