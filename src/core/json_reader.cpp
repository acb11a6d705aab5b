#include "skylut/core/json_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "input_file.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

/// A value as it stands in the file, shortened to fit in one line.
std::string shown(const nlohmann::ordered_json& value) {
  constexpr std::size_t kLongest = 60;
  std::string text = value.dump(-1, ' ', true);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "…";
  return text;
}

// Looks through a document before a tree is made of it: trees are copied, printed and destroyed by recursion,
// which a deep one takes beyond the stack; and of a key given twice the tree would keep only one.
class DocumentGuard final : public nlohmann::json_sax<nlohmann::ordered_json> {
 public:
  const std::string& refusal() const { return refusal_; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return open(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    if (keys_.back().insert(name).second) return true;
    return refuse(fmt::format("key {} is given twice in one object: must be given once", shown(name)));
  }
  bool parse_error(std::size_t byte, const std::string&, const nlohmann::json::exception& error) override {
    constexpr int kNumberOutOfRange = 406;
    if (error.id == kNumberOutOfRange)
      return refuse("holds a number out of range: must fit in double precision");
    return refuse(fmt::format("not valid JSON near byte {}", byte));
  }

 private:
  bool open() {
    keys_.emplace_back();
    if (keys_.size() <= domain::kDeepestNesting) return true;
    return refuse(fmt::format("nested deeper than {} levels", domain::kDeepestNesting));
  }
  bool close() {
    keys_.pop_back();
    return true;
  }
  bool refuse(std::string why) {
    refusal_ = std::move(why);
    return false;
  }

  std::vector<std::set<std::string>> keys_;  // of every open object
  std::string refusal_;
};

}  // namespace

void JsonReader::refuse(const std::string& message) const { throw InputError("{}: {}", name_, message); }

JsonReader JsonReader::at(const std::string& key) const {
  if (!value_->is_object()) refuse(fmt::format("{} must be an object", shown(*value_)));
  const auto found = value_->find(key);
  if (found == value_->end()) refuse(fmt::format("key \"{}\" is missing", key));
  return {*found, fmt::format("{}: {}", name_, key)};
}

std::vector<JsonReader> JsonReader::elements() const {
  if (!value_->is_array() || value_->empty())
    refuse(fmt::format("{} must be an array with at least one element", shown(*value_)));
  std::vector<JsonReader> found;
  for (std::size_t i = 0; i < value_->size(); ++i)
    found.emplace_back((*value_)[i], fmt::format("{}[{}]", name_, i));
  return found;
}

double JsonReader::number(double lower, double upper, const std::string& range) const {
  const double found = value_->is_number() ? value_->get<double>() : std::numeric_limits<double>::quiet_NaN();
  if (!(found >= lower && found <= upper && std::isfinite(found)))
    refuse(fmt::format("{} must be a number {}", shown(*value_), range));
  return found;
}

double JsonReader::number() const {
  return number(std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max(), "that is finite");
}

double JsonReader::number(const Range& range) const {
  const char* const space = *range.unit == '\0' ? "" : " ";
  return number(range.lowest, range.highest,
                fmt::format("within {}-{}{}{}", range.lowest, range.highest, space, range.unit));
}

std::string JsonReader::text() const {
  if (!value_->is_string()) refuse(fmt::format("{} must be a text", shown(*value_)));
  return value_->get<std::string>();
}

std::vector<double> JsonReader::numbers(double lower, double upper, const std::string& range) const {
  std::vector<double> found;
  for (const JsonReader& element : elements()) found.push_back(element.number(lower, upper, range));
  return found;
}

void JsonReader::only(const std::vector<std::string>& known) const {
  if (!value_->is_object()) refuse(fmt::format("{} must be an object", shown(*value_)));
  for (const auto& [key, ignored] : value_->items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      refuse(fmt::format("unknown key \"{}\": known are {}", key, fmt::join(known, ", ")));
}

nlohmann::ordered_json read_json_file(const std::string& path) {
  const std::string text = read_input_file(path, "a file in JSON");
  DocumentGuard guard;
  if (!nlohmann::ordered_json::sax_parse(text, &guard)) throw InputError("{}: {}", path, guard.refusal());
  return nlohmann::ordered_json::parse(text);
}

}  // namespace skylut
