#include "options.hpp"

#include <algorithm>

#include "skylut/core/check.hpp"
#include "skylut/core/errors.hpp"

namespace skylut::cli {

Option& OptionSet::append(std::string name, std::string placeholder, std::string help) {
  Option& option = options_.emplace_back();
  option.name = std::move(name);
  option.placeholder = std::move(placeholder);
  option.help = std::move(help);
  option.group = group_;
  return option;
}

Option& OptionSet::add_flag(std::string name, bool& variable, std::string help) {
  Option& option = append(std::move(name), "", std::move(help));
  option.read = [&variable](const std::string&) { variable = true; };
  option.written = [&variable] { return variable ? std::optional<std::string>("") : std::nullopt; };
  return option;
}

bool OptionSet::given(std::string_view name) const {
  const auto found = std::find_if(options_.begin(), options_.end(),
                                  [&](const Option& option) { return option.name == name; });
  SKYLUT_CHECK(found != options_.end());
  return found != options_.end() && found->given;
}

std::string OptionSet::command_line(std::string_view command) const {
  std::string line(command);
  for (const Option& option : options_) {
    const std::optional<std::string> value = option.recorded ? option.written() : std::nullopt;
    if (!value || (value->empty() && !option.is_flag())) continue;  // an empty list is none
    line += " ";
    if (!option.is_argument()) line += option.name;
    if (option.is_flag()) continue;
    // With a blank between, a value that begins with a dash would be taken for an option.
    if (!option.is_argument()) line += value->starts_with('-') ? "=" : " ";
    line += shell_quoted(*value);
  }
  return line;
}

std::string shell_quoted(const std::string& word) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char character : word)
    if (character == '\'')
      quoted += "'\\''";
    else
      quoted += character;
  return quoted + "'";
}

std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words;
  bool inside = false;  // of a word
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char character = line[i];
    if (!quoted && character == ' ') {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    if (character == '\'')
      quoted = !quoted;
    else if (!quoted && character == '\\' && i + 1 < line.size())
      words.back() += line[++i];
    else
      words.back() += character;
  }
  if (quoted) throw InputError("command '{}': a quote is not closed", line);
  return words;
}

}  // namespace skylut::cli
