#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kind.hpp"

namespace skylut::cli {

/// One option of a command as data: what reads the command line, writes --help and records the command all
/// take it from here.
struct Option {
  std::string name;         ///< "--altitude-km"; an argument without a name has none of the dashes: "FILE"
  std::string short_name;   ///< "-o" or nothing
  std::string placeholder;  ///< of its value; a flag has none
  std::string help;
  std::string group;
  std::string default_text;  ///< as it would be typed; nothing if there is no default
  bool required = false;
  bool repeatable = false;  ///< given several times, its values are put together as one list
  bool recorded = true;     ///< whether it changes the result, and so belongs to the recorded command
  bool given = false;
  std::function<void(const std::string& text)> read;    ///< of a flag: with an empty text
  std::function<std::optional<std::string>()> written;  ///< the value now; none if there is none

  bool is_flag() const { return placeholder.empty(); }
  bool is_argument() const { return !name.starts_with('-'); }
  /// As people type it: "-o".
  const std::string& typed_name() const { return short_name.empty() ? name : short_name; }
};

/// The options of one command, in the order in which help and record show them. The variables that they fill
/// must outlive it.
class OptionSet {
 public:
  /// The group of the options that are added from here on; a title in --help.
  void group(std::string title) { group_ = std::move(title); }

  /// An option whose variable holds its default.
  template <class T>
  Option& add(const std::string& name, T& variable, Kind<T> kind, const std::string& help) {
    Option& option = append(name, kind.placeholder, help);
    option.default_text = kind.write(variable);
    option.read = [&variable, kind](const std::string& text) { variable = kind.read(text); };
    option.written = [&variable, kind] { return std::optional(kind.write(variable)); };
    return option;
  }

  /// An option that may have no value.
  template <class T>
  Option& add(const std::string& name, std::optional<T>& variable, Kind<T> kind, const std::string& help) {
    Option& option = append(name, kind.placeholder, help);
    if (variable) option.default_text = kind.write(*variable);
    option.read = [&variable, kind](const std::string& text) { variable = kind.read(text); };
    option.written = [&variable, kind] {
      return variable ? std::optional(kind.write(*variable)) : std::nullopt;
    };
    return option;
  }

  Option& add_flag(std::string name, bool& variable, std::string help);

  std::deque<Option>& all() { return options_; }
  const std::deque<Option>& all() const { return options_; }

  /// Whether the option was typed.
  bool given(std::string_view name) const;

  /// The command that gives the same result again: every recorded option that has a value, defaults spelled
  /// out, quoted for a shell.
  /// @param command  its words: "skylut table"
  std::string command_line(std::string_view command) const;

 private:
  Option& append(std::string name, std::string placeholder, std::string help);

  std::deque<Option> options_;  // its elements stay where they are
  std::string group_ = "Options";
};

/// A word as a POSIX shell reads it back, in single quotes where it needs them.
std::string shell_quoted(const std::string& word);

/// The words of a line that OptionSet::command_line or shell_quoted wrote. @throws InputError  for a quote
/// that is not closed
std::vector<std::string> shell_words(const std::string& line);

}  // namespace skylut::cli
