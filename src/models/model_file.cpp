#include "skylut/models/model_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <fstream>

#include "skylut/core/errors.hpp"
#include "skylut/core/json_reader.hpp"
#include "skylut/models/compact_sky.hpp"
#include "skylut/models/hosek_wilkie_model.hpp"
#include "skylut/models/perez_rows_model.hpp"
#include "skylut/models/preetham_model.hpp"

namespace skylut {

namespace {

using nlohmann::ordered_json;

constexpr const char* kFormat = "skylut model";

/// A form that can be read back: its name, and what makes a model of the file's domain and numbers.
struct FormReader {
  const char* form;
  std::unique_ptr<const SkyModel> (*read)(const ModelInfo& info, const JsonReader& model);
};

// A new form is one line here.
constexpr std::array kReaders{
    FormReader{"perez", PerezRowsModel::read}, FormReader{"perez-spectral", PerezRowsModel::read},
    FormReader{"preetham", PreethamModel::read}, FormReader{"hosek-wilkie", HosekWilkieModel::read},
    FormReader{"skylut", CompactSkyModel::read}};

ordered_json range_json(const Range& range) { return {range.lowest, range.highest}; }

Range read_range(const JsonReader& domain, const char* key, const char* unit) {
  const std::vector<JsonReader> ends = domain.at(key).elements();
  if (ends.size() != 2) domain.at(key).refuse("must be [lowest, highest]");
  const Range range{ends[0].number(), ends[1].number(), unit};
  if (!(range.lowest <= range.highest)) domain.at(key).refuse("must be [lowest, highest]");
  return range;
}

ModelInfo read_info(const JsonReader& file, const std::string& path) {
  const JsonReader domain = file.at("domain");
  ModelInfo info;
  info.name = path;
  info.title = file.at("title").text();
  info.source = file.at("command").text();
  info.quantities = file.at("quantities").text();
  info.altitude_km = read_range(domain, "altitude_km", "km");
  info.turbidity_kind = parse_turbidity_kind(domain.at("turbidity_kind").text());
  info.turbidity = read_range(domain, "turbidity", "");
  if (domain.has("albedo")) info.albedo = read_range(domain, "albedo", "");
  info.sun_zenith_deg = read_range(domain, "sun_zenith_deg", "deg");
  info.view_zenith_deg = read_range(domain, "view_zenith_deg", "deg");
  return info;
}

}  // namespace

std::string model_file_json(const ModelFile& file, const Provenance& provenance) {
  ordered_json json;
  json["format"] = kFormat;
  json["form"] = file.form;
  json["title"] = file.info.title;
  json["quantities"] = file.info.quantities;
  json.update(provenance.json());
  ordered_json& domain = json["domain"];
  domain["altitude_km"] = range_json(file.info.altitude_km);
  domain["turbidity_kind"] = turbidity_kind_name(file.info.turbidity_kind);
  domain["turbidity"] = range_json(file.info.turbidity);
  if (file.info.albedo) domain["albedo"] = range_json(*file.info.albedo);
  domain["sun_zenith_deg"] = range_json(file.info.sun_zenith_deg);
  domain["view_zenith_deg"] = range_json(file.info.view_zenith_deg);
  json["error"] = file.error;
  json["model"] = file.model;
  return json.dump(1) + '\n';
}

std::unique_ptr<const SkyModel> make_model(const ModelFile& file) {
  for (const FormReader& reader : kReaders)
    if (file.form == reader.form) return reader.read(file.info, JsonReader(file.model, file.form));
  throw InputError("form '{}': must be one of {}", file.form, fmt::join(model_forms(), ", "));
}

std::vector<std::string> model_forms() {
  std::vector<std::string> names;
  for (const FormReader& reader : kReaders) names.emplace_back(reader.form);
  return names;
}

bool is_model_file(const std::filesystem::path& path) {
  // The format is the first key of every model file that we write.
  std::ifstream file(path);
  std::string start(64, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start.find(kFormat) != std::string::npos;
}

std::unique_ptr<const SkyModel> read_model_file(const std::filesystem::path& path) {
  const ordered_json document = read_json_file(path.string());
  const JsonReader file(document, path.string());
  if (!file.has("format") || file.at("format").text() != kFormat)
    file.refuse("must be a model file, as skylut fit --form writes it");
  const std::string form = file.at("form").text();
  for (const FormReader& reader : kReaders)
    if (form == reader.form) return reader.read(read_info(file, path.string()), file.at("model"));
  throw InputError("{}: form '{}': must be one of {}", path.string(), form, fmt::join(model_forms(), ", "));
}

}  // namespace skylut
