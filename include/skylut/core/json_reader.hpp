#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "skylut/core/domain.hpp"

namespace skylut {

/// A place inside a JSON document that knows its own name, so that every refusal is one line naming
/// file, key, value and what would be right.
class JsonReader {
 public:
  JsonReader(const nlohmann::ordered_json& value, std::string name)
      : value_(&value), name_(std::move(name)) {}

  const std::string& name() const { return name_; }
  const nlohmann::ordered_json& value() const { return *value_; }
  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }

  /// Member of an object. @throws InputError if this is no object or lacks the key
  JsonReader at(const std::string& key) const;

  /// Elements of an array with at least one. @throws InputError
  std::vector<JsonReader> elements() const;

  /// A finite number within [lower, upper]. @throws InputError
  double number(double lower, double upper, const std::string& range) const;
  double number() const;
  /// A number of the domain. @throws InputError naming the range
  double number(const Range& range) const;
  std::string text() const;
  std::vector<double> numbers(double lower, double upper, const std::string& range) const;

  /// @throws InputError naming a key of this object that is not among `known`
  void only(const std::vector<std::string>& known) const;

  /// @throws InputError "<place>: <message>"
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  const nlohmann::ordered_json* value_;
  std::string name_;
};

/// Parses a whole file. @throws InputError if it cannot be read, is not JSON, is larger or deeper than the
/// domain allows, or gives a key twice in one object
nlohmann::ordered_json read_json_file(const std::string& path);

}  // namespace skylut
