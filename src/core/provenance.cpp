#include "skylut/core/provenance.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "skylut/core/context.hpp"
#include "skylut/core/sha256.hpp"
#include "skylut/core/version.hpp"

namespace skylut {

using Json = nlohmann::ordered_json;

namespace {

std::string name_of(const Context& context, const std::filesystem::path& file) {
  const std::filesystem::path relative = file.lexically_relative(context.data_folder);
  const bool ours = !relative.empty() && *relative.begin() != "..";
  return ours ? ("profiles" / relative).string() : file.string();
}

// A text in one line whatever it holds.
std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

Provenance::Provenance(std::string command)
    : command_(std::move(command)), inputs_(std::make_shared<const Json>(Json::object())) {}

void Provenance::describe(const std::string& name, const Json& description) {
  Json inputs = *inputs_;
  inputs[name] = description;
  inputs_ = std::make_shared<const Json>(std::move(inputs));
}

void Provenance::describe(const std::string& name, const std::string& text) { describe(name, Json(text)); }

void Provenance::add_source(const Context& context, const std::filesystem::path& file) {
  const std::string name = name_of(context, file);
  for (const Source& known : sources_)
    if (known.file == name) return;
  sources_.push_back({name, sha256_of_file(file)});
}

Json Provenance::json() const {
  Json json{{"skylut_version", kVersion}, {"command", command_}};
  if (!instruction_set_.empty()) json["instruction_set"] = instruction_set_;
  json["inputs"] = *inputs_;
  Json& sources = json["sources"] = Json::array();
  for (const Source& source : sources_) sources.push_back({{"file", source.file}, {"sha256", source.sha256}});
  return json;
}

std::string Provenance::comment_lines() const {
  // Comments of the form "# name=value" are read as values: the provenance is none of them, hence the colons
  // and JSON's other way to write an equals sign.
  std::string compact;
  for (const char character : json().dump())
    compact += character == '=' ? std::string("\\u003d") : std::string(1, character);
  return in_one_line("# command: " + command_) + "\n# provenance: " + in_one_line(compact) + "\n";
}

}  // namespace skylut
