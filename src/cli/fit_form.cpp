#include "fit_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "options/light_kinds.hpp"
#include "options/number_kinds.hpp"
#include "output.hpp"
#include "recorded_table.hpp"
#include "skylut/core/json_reader.hpp"
#include "skylut/core/suggestion.hpp"
#include "skylut/forms/form.hpp"
#include "skylut/forms/map_skies.hpp"
#include "skylut/forms/simulated_skies.hpp"
#include "skylut/report/form_report.hpp"
#include "skylut/table/named_grids.hpp"
#include "skylut/table/table.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* kGroup = "Forms (with --form)";

/// Skies, and how they came about.
struct Input {
  std::unique_ptr<const SkySupply> skies;
  Provenance provenance;
};

bool is_table(const fs::path& input) {
  std::error_code ignored;
  return fs::exists(input / "table.json", ignored) || input.filename() == "table.csv";
}

// The air, its light and its bands must be those that the table was made of: a file may have changed since,
// or a version's numbers.
void require_same_numbers(const fs::path& table_json, const Provenance& replayed) {
  const nlohmann::ordered_json recorded = read_json_file(table_json.string());
  const nlohmann::ordered_json now = replayed.json();
  const auto require_same = [&](const std::string& what, const auto& then_value, const auto& now_value) {
    if (then_value != now_value)
      throw InputError("{}: its command now gives another {}: must be made again, with skylut table",
                       table_json.string(), what);
  };
  const nlohmann::ordered_json inputs = recorded.value("inputs", nlohmann::ordered_json::object());
  for (const char* const name : {"profile", "air", "wavelengths_nm", "solar", "sun_distance_au"})
    if (inputs.contains(name)) require_same(name, inputs.at(name), now.at("inputs").at(name));
  for (const auto& then : recorded.value("sources", nlohmann::ordered_json::array()))
    for (const auto& source : now.at("sources"))
      if (source.at("file") == then.at("file"))
        require_same(source.at("file").get<std::string>(), then.at("sha256"), source.at("sha256"));
}

/// The skies for which a table folder stands.
Input open_table(const Context& context, const fs::path& input, const std::string& command_line,
                 const std::function<void(SkyScene&)>& put_axes_into) {
  const Table table = Table::read(input);
  if (!table.provenance() || table.provenance()->inputs.empty())
    throw InputError("{}: has no table.json: must say how it was made, as skylut table writes it",
                     input.string());
  const std::string& command = table.provenance()->command;
  RecordedTable recorded;
  Provenance replayed;
  try {
    recorded = recorded_table(context, command);
    replayed = recorded.options->provenance(context, recorded.scene, {});
  } catch (const InputError& error) {
    throw InputError("{}: its command cannot be run again: {}", input.string(), error.what());
  }
  require_same_numbers((fs::is_directory(input) ? input : input.parent_path()) / "table.json", replayed);
  put_axes_into(recorded.scene);
  Provenance provenance = recorded.options->provenance(context, recorded.scene, command_line);
  provenance.describe("input", nlohmann::ordered_json{{"table", input.string()}, {"command", command}});
  const std::shared_ptr<const SceneOptions> made_with = recorded.options;
  return {std::make_unique<const SimulatedSkies>(
              std::move(recorded.scene), made_with->transfer(),
              [context, made_with](double albedo) { return made_with->air_over_ground(context, albedo); }),
          std::move(provenance)};
}

Input open_maps(const Context& context, const fs::path& input, const std::string& command_line) {
  auto maps = std::make_unique<const MapSkies>(input);
  Provenance provenance(command_line);
  for (const fs::path& file : maps->files()) provenance.add_source(context, file);
  return {std::move(maps), std::move(provenance)};
}

}  // namespace

void FormRequest::add_to(OptionSet& options) {
  options.group(kGroup);
  options.add("--form", form_, choice(form_names()), "fit a sky model of this form, to -o MODEL.json");
  options.add("--grid", grid_, choice(grid_names()),
              "altitudes, turbidities and suns instead of the input's");
  options.add("--altitudes-km", altitudes_km_, numbers(domain::kObserver_km), "instead of the input's");
  options.add("--turbidities", turbidities_, numbers(domain::kTurbidityValue), "instead of the input's");
  options.add("--albedos", albedos_, numbers(domain::kAlbedo),
              "of the ground, for hosek-wilkie: default 0,1");
  options.add_flag("--spectral", spectral_,
                   "bands instead of X, Y, Z, for hosek-wilkie; beside them, for skylut");
  options.add("--error", error_, number({5e-4, 0.02, ""}),
              "of luminance to aim at, for skylut: default 0.0035; smaller is a larger file");
  options.add("--bands-nm", bands_, wavelengths(), "first, last and step of bands: default 380:780:40");
  computing_.add_to(options);
}

void FormRequest::refuse_without_form(const OptionSet& given) const {
  for (const Option& option : given.all())
    if (option.given && (option.group == kGroup || option.name == "--simd"))
      throw InputError("{}: is for --form NAME", option.name);
}

void FormRequest::put_axes_into(SkyScene& scene) const {
  TurbidityKind kind = scene.turbidities.front().kind;
  const auto set_turbidities = [&](const std::vector<double>& values) {
    scene.turbidities.clear();
    for (const double value : values) scene.turbidities.push_back({kind, value});
  };
  if (grid_) {
    const NamedGrid grid = named_grid(*grid_);
    kind = grid.turbidity_kind;
    scene.altitudes_km = grid.altitudes_km;
    scene.suns = grid.suns;
    set_turbidities(grid.turbidities);
  }
  if (altitudes_km_) scene.altitudes_km = *altitudes_km_;
  if (turbidities_) set_turbidities(*turbidities_);
}

void FormRequest::refuse_axes_of_maps(const fs::path& input) const {
  for (const auto& [name, given] :
       {std::pair("--grid", grid_.has_value()), std::pair("--altitudes-km", altitudes_km_.has_value()),
        std::pair("--turbidities", turbidities_.has_value())})
    if (given)
      throw InputError("{}: {} has the skies that it has: must be a table folder", name, input.string());
}

std::string FormRequest::forms_text() {
  std::string text = "Forms:";
  for (const Form* const form : forms()) text += fmt::format("\n  {:<15} {}", form->name(), form->summary());
  return text;
}

void FormRequest::refuse_what_it_ignores(const Form& form) const {
  const auto refuse_unless = [&](bool given, bool FormHeeds::*heeded, const char* option) {
    if (!given || form.heeds().*heeded) return;
    std::vector<std::string> others;
    for (const Form* const other : forms())
      if (other->heeds().*heeded) others.emplace_back(other->name());
    throw InputError("{}: changes nothing of form {}: is for {}", option, form.name(), listed(others));
  };
  refuse_unless(spectral_, &FormHeeds::spectral, "--spectral");
  refuse_unless(bands_.has_value(), &FormHeeds::bands, "--bands-nm");
  refuse_unless(error_.has_value(), &FormHeeds::error, "--error");
  refuse_unless(albedos_.has_value(), &FormHeeds::albedos, "--albedos");
  if (bands_ && form.heeds().spectral && !spectral_)
    throw InputError("--bands-nm: needs --spectral with form {}", form.name());
}

void FormRequest::run(const fs::path& input, const fs::path& out, const std::string& command_line) const {
  const Context context = program_context(computing_);
  const Form& form = form_named(*form_);
  refuse_what_it_ignores(form);
  FormOptions options;
  options.spectral = spectral_;
  if (error_) options.error = *error_;
  if (bands_) options.bands = *bands_;
  if (albedos_) options.albedos = *albedos_;
  std::sort(options.albedos.begin(), options.albedos.end());
  if (std::adjacent_find(options.albedos.begin(), options.albedos.end()) != options.albedos.end())
    throw InputError("--albedos: must not hold a value twice");

  if (!is_table(input)) refuse_axes_of_maps(input);
  const Input opened = is_table(input) ? open_table(context, input, command_line,
                                                    [this](SkyScene& scene) { put_axes_into(scene); })
                                       : open_maps(context, input, command_line);
  const ModelFile file = fit_form(context, form, *opened.skies, options);
  const std::string text = model_file_json(file, opened.provenance);
  write_result(out, text);
  if (is_standard_output(out)) return;
  fmt::print("{}wrote {} ({} bytes)\n", form_text(file), out.string(), text.size());
}

}  // namespace skylut::cli
