#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "advice.hpp"
#include "commands.hpp"
#include "directions_option.hpp"
#include "memory.hpp"
#include "options/file_kinds.hpp"
#include "options/light_kinds.hpp"
#include "options/number_kinds.hpp"
#include "output.hpp"
#include "recorded_table.hpp"
#include "scene_options.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/suggestion.hpp"
#include "skylut/core/writable.hpp"
#include "skylut/export/sky_csv.hpp"
#include "skylut/report/table_summary.hpp"
#include "skylut/table/between_nodes.hpp"
#include "skylut/table/fit_table.hpp"
#include "skylut/table/named_grids.hpp"
#include "skylut/table/write_table.hpp"
#include "weights_kind.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* kDome = "dome";
constexpr const char* kReport2005 = "utm271";

// The defaults are the UTM report's: 5 altitudes, 3 turbidities, 5 suns.
struct TableOptions {
  SceneOptions scene;
  fs::path out;
  std::optional<std::string> grid;
  std::vector<double> altitudes_km{0.0, 6.0, 12.0, 20.0, 30.0};
  std::vector<double> turbidities{0.0, 0.5, 1.0};
  std::vector<Direction> suns{{90.0, 90.0}, {45.0, 90.0}, {0.0, 0.0}, {45.0, 270.0}, {90.0, 270.0}};
  std::string directions = kDome;
  std::optional<SampleWeights> weights;
  bool to_horizon = false;
  bool save_maps = false;
};

std::string grid_texts() {
  std::vector<std::string> texts;
  for (const NamedGrid& grid : named_grids()) texts.push_back(fmt::format("{} ({})", grid.name, grid.what));
  return fmt::format("{}", fmt::join(texts, "; "));
}

// A look-up table with two rows for one key would be ambiguous.
template <class T>
void require_different(const char* option, const std::vector<T>& values, const Kind<std::vector<T>>& kind) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const auto here = values.begin() + static_cast<std::ptrdiff_t>(i);
        std::find(values.begin(), here, *here) != here)
      throw InputError("{}: {} (number {}) is given twice, must be different", option, kind.write({*here}),
                       i + 1);
}

SkyScene scene_of(const Context& context, const TableOptions& options) {
  require_different("--altitudes-km", options.altitudes_km, numbers(domain::kObserver_km));
  require_different("--turbidities", options.turbidities, numbers(domain::kTurbidityValue));
  require_different("--suns", options.suns, suns());
  SkyScene scene = options.scene.scene(context);
  scene.altitudes_km = options.altitudes_km;
  for (const double value : options.turbidities)
    scene.turbidities.push_back({options.scene.air().turbidity_kind(), value});
  scene.suns = options.suns;
  scene.directions_name = options.directions;
  return scene;
}

TableSampling sampling_of(const TableOptions& options) {
  TableSampling sampling;
  std::error_code ignored;
  const std::vector<std::string> names{kDome, kReport2005, "preetham343"};
  if (std::find(names.begin(), names.end(), options.directions) == names.end() &&
      !fs::exists(options.directions, ignored))
    throw InputError("--directions '{}': must be {} or a CSV file with columns zenith_deg,azimuth_deg{}",
                     options.directions, fmt::join(names, ", "), suggested(options.directions, names));
  if (options.directions != kDome) sampling.directions = directions_of(options.directions);
  for (const Direction& direction : sampling.directions)
    if (direction.zenith_deg > 90.0)
      throw InputError("--directions '{}': zenith_deg {}: must be at most 90 for a fit", options.directions,
                       direction.zenith_deg);
  sampling.to_horizon = options.to_horizon;
  sampling.exact = options.scene.exact();
  if (options.to_horizon && !sampling.directions.empty())
    throw InputError("--to-horizon: needs --directions {}, as other sets end at 90 deg", kDome);
  if (options.save_maps)
    sampling.map_directions = sampling.directions.empty() ? directions_utm271() : sampling.directions;
  return sampling;
}

TableFitOptions fit_options_of(const TableOptions& options) {
  TableFitOptions fit =
      options.directions == kReport2005 ? TableFitOptions::utm2005() : TableFitOptions::half_floats();
  fit.weights = *options.weights;
  return fit;
}

// The most directions that are looked at in one go.
std::size_t directions_at_once(const TableSampling& sampling) {
  constexpr std::size_t kCheck = 1500;
  return std::max({kCheck, sampling.directions.size(), sampling.map_directions.size()});
}

void advise_and_check(const Context& context, const SkyScene& scene, const TableSampling& sampling) {
  const RequestSize size{
      static_cast<double>(directions_at_once(sampling)), static_cast<double>(scene.wavelengths.size()),
      static_cast<double>(scene.turbidities.size()), static_cast<double>(scene.altitudes_km.size()),
      static_cast<double>(scene.suns.size())};
  const auto of_maps = static_cast<double>(sampling.map_directions.size());
  require_memory(size, [=](const RequestSize& part) { return needed_bytes_of_table(part, of_maps); });
  advise_on_turbidity(scene.turbidities, *scene.atmosphere);
  advise_on_wavelengths(context, scene.wavelengths);
}

void require_writable_outputs(const TableOptions& options) {
  const auto folder = options.save_maps ? options.out / "maps" : options.out;
  try {
    require_writable_folder(folder);
  } catch (const InputError& error) {
    throw InputError("--out {}: {}", options.out.string(), error.what());
  }
  std::error_code ignored;
  if (!fs::is_directory(options.out, ignored)) return;
  require_writable("--out", options.out / "table.csv");
  require_writable("--out", options.out / "table.json");
}

void write_maps(const fs::path& folder, const std::vector<SkyMap>& maps, const Provenance& provenance) {
  create_folder(folder);
  for (std::size_t i = 0; i < maps.size(); ++i)
    write_text_atomically(folder / fmt::format("entry_{:03}.csv", i + 1), sky_csv(maps[i], provenance));
}

// What was not given of a grid's axes is the grid's, and recorded as such.
void settle_grid(TableOptions& options, const OptionSet& given) {
  if (!options.grid) return;
  const NamedGrid& grid = named_grid(*options.grid);
  if (!given.given("--altitudes-km")) options.altitudes_km = grid.altitudes_km;
  if (!given.given("--suns")) options.suns = grid.suns;
  if (given.given("--turbidities")) return;
  if (given.given("--turbidity-kind") && options.scene.air().turbidity_kind() != grid.turbidity_kind)
    throw InputError("--turbidity-kind {}: the turbidities of --grid {} are {}; give --turbidities too",
                     turbidity_kind_name(options.scene.air().turbidity_kind()), grid.name,
                     turbidity_kind_name(grid.turbidity_kind));
  options.turbidities = grid.turbidities;
  options.scene.take_turbidities_as(grid.turbidity_kind);
}

// @param errors  of some skies, as between_nodes_json() has them
void print_between_nodes(const char* which_skies, const nlohmann::ordered_json& errors) {
  const auto percents = [&errors](const char* of) {
    const nlohmann::ordered_json& Y = errors[of]["Y"];
    return fmt::format("median {:.2g} %, 90th percentile {:.2g} %, worst {:.2g} %",
                       100.0 * Y["median"].get<double>(), 100.0 * Y["p90"].get<double>(),
                       100.0 * Y["worst"].get<double>());
  };
  fmt::print("between its rows, {}, {} skies: rms of Y {}; of rows fitted there {}\n", which_skies,
             errors["skies"].get<std::size_t>(), percents("table"), percents("row_alone"));
}

// Of a table that is meant to be interpolated: what it errs between its rows.
void measure_between_nodes(const Context& context, const TableOptions& options, const SkyScene& scene,
                           const TableSampling& sampling, SkyTable& table) {
  if (!options.grid || !named_grid(*options.grid).for_between) return;
  const TableModel model(Table(table.entries, scene.turbidities.front().kind));
  const std::vector<HeldOutSky> skies = held_out_skies(context, scene, options.scene.transfer(), sampling,
                                                       fit_options_of(options), model.info());
  const nlohmann::ordered_json json = between_nodes_json(model, skies);
  table.between_nodes = json.dump();
  if (json.contains("sun_up")) print_between_nodes("sun up", json["sun_up"]);
  if (json.contains("sun_below_horizon"))
    print_between_nodes("sun below the horizon", json["sun_below_horizon"]);
}

void run(const TableOptions& options, const std::string& command_line) {
  require_writable_outputs(options);
  const Context context = options.scene.context();
  const TableSampling sampling = sampling_of(options);
  SkyScene scene = scene_of(context, options);
  scene.directions = sampling.directions;
  const TableFitOptions fit_options = fit_options_of(options);
  advise_and_check(context, scene, sampling);

  const TableSkies skies = simulate_table_skies(context, scene, options.scene.transfer(), sampling);
  SkyTable table = fit_table(context, skies.skies, fit_options);
  measure_between_nodes(context, options, scene, sampling, table);

  create_folder(options.out);
  Provenance provenance = options.scene.provenance(context, scene, command_line);
  provenance.describe("weights", weights_kind().write(fit_options.weights));
  if (options.directions == kDome) provenance.describe("directions", nlohmann::ordered_json{{"name", kDome}});
  provenance.describe("to_horizon", nlohmann::ordered_json(options.to_horizon));
  provenance.set_instruction_set(skies.instruction_set);
  if (options.save_maps) write_maps(options.out / "maps", skies.maps, provenance);
  write_table(options.out, table, provenance);

  for (const Turbidity& turbidity : scene.turbidities)
    fmt::print("{}\n", turbidity_text(turbidity, *scene.atmosphere));
  fmt::print("\n{}", table_summary(table, std::string(turbidity_kind_name(scene.turbidities.front().kind))));
  fmt::print("wrote {} and table.json{}\n", (options.out / "table.csv").string(),
             options.save_maps ? fmt::format(", {} maps in maps", skies.maps.size()) : "");
  require_converged(table);
}

// The command but for what it does.
Command declared(const std::shared_ptr<TableOptions>& options) {
  Command command;
  command.name = "table";
  command.summary = "simulate skies and fit them: the coefficient table";
  command.notes =
      "Writes DIR/table.csv and DIR/table.json; one row per altitude, turbidity and sun, in that order.";
  command.examples = {
      "skylut table --out out/table",
      "skylut table --out out/city --turbidity-kind preetham-t --turbidities 2,4,6 --albedo 0.15",
      "skylut table --out out/quick --altitudes-km 0 --suns 45:180 --wavelengths-nm 380:780:20 --save-maps"};
  OptionSet& set = command.options;
  Option& out = set.add("--out", options->out, folder_out(), "folder for the results, created if need be");
  out.required = true;
  out.recorded = false;
  set.add("--grid", options->grid, choice(grid_names()),
          "axes by name: " + grid_texts() + "; single axes may be given too");
  set.add("--altitudes-km", options->altitudes_km, numbers(domain::kObserver_km),
          "of the observers above the ground, 0 to 30");
  set.add("--turbidities", options->turbidities, numbers(domain::kTurbidityValue),
          "of the kind of --turbidity-kind");
  set.add("--suns", options->suns, suns(),
          "zenith angle (0 to 99) and azimuth (clockwise from north) in degrees");
  set.add(
      "--directions", options->directions, name_or_file(),
      "that the fits see: dome (the whole dome, each sky's own), utm271 (as the UTM report 2005 has it, each "
      "row alone), preetham343 or a CSV file");
  set.add(
      "--weights", options->weights, weights_kind(),
      "of the directions in the fits: horizon (solid angle, the last degrees emphasised; default for dome), "
      "solid-angle or uniform (default otherwise)");
  set.add_flag("--to-horizon", options->to_horizon,
               "fit from the zenith to the geometric horizon, which lies below 90 deg aloft");
  set.add_flag("--save-maps", options->save_maps,
               "also write each row's sky, DIR/maps/entry_001.csv ..., in the report's 271 directions, or in "
               "those of --directions");
  options->scene.add_to(set);
  return command;
}

}  // namespace

Command table_command() {
  const auto options = std::make_shared<TableOptions>();
  Command command = declared(options);
  command.run = [options](const OptionSet& given) {
    // Settled first, so that they are recorded.
    if (!options->weights)
      options->weights = options->directions == kDome ? SampleWeights::horizon : SampleWeights::uniform;
    settle_grid(*options, given);
    run(*options, given.command_line("skylut table"));
  };
  return command;
}

RecordedTable recorded_table(const Context& context, const std::string& command_line) {
  const auto options = std::make_shared<TableOptions>();
  Command program;
  program.name = "skylut";
  program.subcommands.push_back(declared(options));
  Command& table = program.subcommands.front();
  for (Option& option : table.options.all()) option.required = false;  // --out is not recorded
  table.run = [options](const OptionSet& given) { settle_grid(*options, given); };
  const std::vector<std::string> words = shell_words(command_line);
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  run_command_line(program, static_cast<int>(arguments.size()), arguments.data());
  return {scene_of(context, *options), std::shared_ptr<const SceneOptions>(options, &options->scene)};
}

}  // namespace skylut::cli
