#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"

namespace skylut::cli {

/// A kind of value on the command line: the one way to read it, and the one way to write it so that it reads
/// back as the same value. number_kinds.hpp, light_kinds.hpp and file_kinds.hpp hold those there are.
template <class T>
struct Kind {
  std::string placeholder;  ///< stands for the value in --help: "NUMBER"
  /// @throws InputError  "must be …": what would be right; the option puts its name and the text before it
  std::function<T(const std::string& text)> read;
  std::function<std::string(const T& value)> write;
};

/// One of several names, each with the value that it means.
template <class T>
Kind<T> choice(std::vector<std::pair<std::string, T>> choices) {
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) names.push_back(name);
  return {"NAME",
          [choices, names](const std::string& text) {
            for (const auto& [name, value] : choices)
              if (name == text) return value;
            throw InputError("must be {}{}", listed(names), suggested(text, names));
          },
          [choices](const T& value) {
            for (const auto& [name, known] : choices)
              if (known == value) return name;
            return std::string();
          }};
}

/// One of several names that mean themselves.
inline Kind<std::string> choice(const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, std::string>> choices;
  for (const std::string& name : names) choices.emplace_back(name, name);
  return choice(std::move(choices));
}

}  // namespace skylut::cli
