#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "advice.hpp"
#include "commands.hpp"
#include "memory.hpp"
#include "options/file_kinds.hpp"
#include "options/light_kinds.hpp"
#include "options/number_kinds.hpp"
#include "output.hpp"
#include "recorded_table.hpp"
#include "scene_options.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/writable.hpp"
#include "skylut/export/sky_csv.hpp"
#include "skylut/report/table_summary.hpp"
#include "skylut/table/fit_table.hpp"
#include "skylut/table/write_table.hpp"
#include "weights_kind.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

// The defaults are the UTM report's: 5 altitudes, 3 turbidities, 5 suns.
struct TableOptions {
  SceneOptions scene;
  fs::path out;
  std::vector<double> altitudes_km{0.0, 6.0, 12.0, 20.0, 30.0};
  std::vector<double> turbidities{0.0, 0.5, 1.0};
  std::vector<Direction> suns{{90.0, 90.0}, {45.0, 90.0}, {0.0, 0.0}, {45.0, 270.0}, {90.0, 270.0}};
  SampleWeights weights = SampleWeights::uniform;
  bool save_maps = false;
};

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
  scene.directions = directions_utm271();
  scene.directions_name = "utm271";
  return scene;
}

void advise_and_check(const Context& context, const SkyScene& scene) {
  require_memory({static_cast<double>(scene.directions.size()), static_cast<double>(scene.wavelengths.size()),
                  static_cast<double>(scene.turbidities.size()),
                  static_cast<double>(scene.altitudes_km.size()), static_cast<double>(scene.suns.size())});
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

void run(const TableOptions& options, const std::string& command_line) {
  require_writable_outputs(options);
  const Context context = options.scene.context();
  const SkyScene scene = scene_of(context, options);
  advise_and_check(context, scene);

  const std::vector<SkyMap> maps = simulate_sky(context, scene, options.scene.transfer());
  SkyFitOptions fit_options;
  fit_options.weights = options.weights;
  const SkyTable table = fit_table(context, maps, fit_options);

  create_folder(options.out);
  Provenance provenance = options.scene.provenance(context, scene, command_line);
  provenance.describe("weights", weights_kind().write(options.weights));
  provenance.set_instruction_set(maps.front().instruction_set);
  if (options.save_maps) write_maps(options.out / "maps", maps, provenance);
  write_table(options.out, table, scene.directions, provenance);

  for (const Turbidity& turbidity : scene.turbidities)
    fmt::print("{}\n", turbidity_text(turbidity, *scene.atmosphere));
  fmt::print("\n{}", table_summary(table, std::string(turbidity_kind_name(scene.turbidities.front().kind))));
  fmt::print("wrote {} and table.json{}\n", (options.out / "table.csv").string(),
             options.save_maps ? fmt::format(", {} maps in maps", maps.size()) : "");
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
  set.add("--altitudes-km", options->altitudes_km, numbers(domain::kObserver_km),
          "of the observers above the ground, 0 to 30");
  set.add("--turbidities", options->turbidities, numbers(domain::kTurbidityValue),
          "of the kind of --turbidity-kind");
  set.add("--suns", options->suns, suns(),
          "zenith angle (0 to 96) and azimuth (clockwise from north) in degrees");
  set.add("--weights", options->weights, weights_kind(),
          "of the directions in the fits: uniform or solid-angle");
  set.add_flag("--save-maps", options->save_maps, "also write each row's sky, DIR/maps/entry_001.csv ...");
  options->scene.add_to(set);
  return command;
}

}  // namespace

Command table_command() {
  const auto options = std::make_shared<TableOptions>();
  Command command = declared(options);
  command.run = [options](const OptionSet& given) { run(*options, given.command_line("skylut table")); };
  return command;
}

RecordedTable recorded_table(const Context& context, const std::string& command_line) {
  const auto options = std::make_shared<TableOptions>();
  Command program;
  program.name = "skylut";
  program.subcommands.push_back(declared(options));
  Command& table = program.subcommands.front();
  for (Option& option : table.options.all()) option.required = false;  // --out is not recorded
  table.run = [](const OptionSet&) {};
  const std::vector<std::string> words = shell_words(command_line);
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  run_command_line(program, static_cast<int>(arguments.size()), arguments.data());
  return {scene_of(context, *options), std::shared_ptr<const SceneOptions>(options, &options->scene)};
}

}  // namespace skylut::cli
