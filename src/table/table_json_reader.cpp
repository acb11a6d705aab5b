#include "table_json_reader.hpp"

#include <nlohmann/json.hpp>

#include "skylut/core/errors.hpp"
#include "skylut/core/json_reader.hpp"
#include "skylut/core/sha256.hpp"

namespace skylut {

namespace fs = std::filesystem;

namespace {

// Whether the csv is the file that table.json was written with. Tables of skylut 0.1.0 do not say.
bool belongs(const JsonReader& file, const fs::path& csv) {
  if (!file.has("table_csv")) return csv.filename() == "table.csv";
  const JsonReader stated = file.at("table_csv");
  if (stated.at("file").text() != csv.filename()) return false;
  const std::string expected = stated.at("sha256").text();
  const std::string found = sha256_of_file(csv);
  if (found != expected)
    throw InputError("{}: sha256 {:.12}…: must be {:.12}…, that of the table which {} was written with",
                     csv.string(), found, expected, file.name());
  return true;
}

ListedTurbidity listed_turbidity(const JsonReader& one) {
  ListedTurbidity listed{.given = one.at("given").number(), .by_kind = {}};
  for (const TurbidityKind kind : turbidity_kinds()) {
    const std::string name(turbidity_kind_name(kind));
    // An infinite visibility is null.
    if (one.has(name) && one.at(name).value().is_number()) listed.by_kind[kind] = one.at(name).number();
  }
  return listed;
}

// A number, or the name and curve of one that varies with the wavelength.
std::optional<double> ground_albedo(const JsonReader& inputs) {
  if (!inputs.has("air") || !inputs.at("air").has("ground_albedo")) return {};
  const JsonReader albedo = inputs.at("air").at("ground_albedo");
  if (!albedo.value().is_number()) return {};
  return albedo.number();
}

}  // namespace

std::optional<TableManifest> read_table_json(const fs::path& json, const fs::path& csv) {
  const nlohmann::ordered_json document = read_json_file(json.string());
  const JsonReader file(document, json.string());
  if (!file.has("format") || file.at("format").text() != "skylut table")
    throw InputError("{}: must be the table.json of skylut table", json.string());
  if (!belongs(file, csv)) return {};
  TableManifest manifest;
  manifest.provenance = {
      .skylut_version = file.at("skylut_version").text(),
      .command = file.at("command").text(),
      .inputs = file.at("inputs").value().dump(),
      .ground_albedo = ground_albedo(file.at("inputs")),
      .between_nodes = file.has("between_nodes") ? file.at("between_nodes").value().dump() : ""};
  for (const JsonReader& one : file.at("inputs").at("turbidities").elements()) {
    manifest.turbidities.push_back(listed_turbidity(one));
    manifest.turbidity_kind = parse_turbidity_kind(one.at("kind").text());
  }
  return manifest;
}

}  // namespace skylut
