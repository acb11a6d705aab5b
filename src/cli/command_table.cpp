#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "number_options.hpp"
#include "output_check.hpp"
#include "program_context.hpp"
#include "progress.hpp"
#include "scene_options.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/export/sky_csv.hpp"
#include "skylut/report/table_summary.hpp"
#include "skylut/table/fit_table.hpp"
#include "skylut/table/write_table.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

// The defaults are the UTM report's: 5 altitudes, 3 turbidities, 5 suns.
struct TableOptions {
  SceneOptions scene;
  fs::path out;
  std::vector<double> altitudes_km{0.0, 6.0, 12.0, 20.0, 30.0};
  std::vector<double> turbidities{0.0, 0.5, 1.0};
  std::string suns = "90:90,45:90,0:0,45:270,90:270";
  std::string weights = "uniform";
  bool save_maps = false;
};

SampleWeights parse_weights(const std::string& text) {
  if (text == "uniform") return SampleWeights::uniform;
  if (text == "solid-angle") return SampleWeights::solid_angle;
  throw InputError("--weights '{}': must be uniform or solid-angle", text);
}

// A look-up table with two rows for one key would be ambiguous.
template <class T>
void require_different(const char* option, const std::vector<T>& values, const std::string& text) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::find(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(i), values[i]) !=
        values.begin() + static_cast<std::ptrdiff_t>(i))
      throw InputError("{} {}: number {} is given twice, must be different", option, text, i + 1);
}

SkyScene scene_of(const Context& context, const TableOptions& options) {
  require_different("--altitudes-km", options.altitudes_km,
                    fmt::format("{}", fmt::join(options.altitudes_km, ",")));
  require_different("--turbidities", options.turbidities,
                    fmt::format("{}", fmt::join(options.turbidities, ",")));
  SkyScene scene = options.scene.scene(context);
  scene.altitudes_km = options.altitudes_km;
  for (const double value : options.turbidities)
    scene.turbidities.push_back({options.scene.turbidity_kind(), value});
  scene.suns = parse_suns(options.suns);
  require_different("--suns", scene.suns, options.suns);
  scene.directions = directions_utm271();
  scene.directions_name = "utm271";
  return scene;
}

std::string command_line(const TableOptions& options) {
  return fmt::format("skylut table --altitudes-km {} --turbidities {} --suns {} --weights {} {}",
                     fmt::join(options.altitudes_km, ","), fmt::join(options.turbidities, ","), options.suns,
                     options.weights, options.scene.command_line());
}

Provenance provenance_of(const Context& context, const TableOptions& options, const SkyScene& scene) {
  Provenance provenance = scene_provenance(context, scene, command_line(options));
  provenance.describe("quality", options.scene.quality());
  provenance.describe("weights", options.weights);
  return provenance;
}

void require_writable_outputs(const TableOptions& options) {
  require_writable_folder("--out", options.out);
  if (options.save_maps) require_writable_folder("--out", options.out / "maps");
  std::error_code ignored;
  if (!fs::is_directory(options.out, ignored)) return;
  require_writable_file("--out", options.out / "table.csv");
  require_writable_file("--out", options.out / "table.json");
}

void write_maps(const fs::path& folder, const std::vector<SkyMap>& maps, const Provenance& provenance) {
  create_folder(folder);
  for (std::size_t i = 0; i < maps.size(); ++i)
    write_text_atomically(folder / fmt::format("entry_{:03}.csv", i + 1), sky_csv(maps[i], provenance));
}

std::vector<SkyMap> simulate(const Context& context, const SkyScene& scene, TransferOptions transfer) {
  Progress progress("solving the radiative transfer:");
  transfer.progress = [&](std::size_t done, std::size_t all) { progress.show(done, all); };
  return simulate_sky(context, scene, transfer);
}

SkyTable fit(Context context, const std::vector<SkyMap>& maps, const SkyFitOptions& options) {
  Progress progress("fitting:");
  context.progress = [&](std::string_view, std::size_t done, std::size_t all) { progress.show(done, all); };
  return fit_table(context, maps, options);
}

void run(const TableOptions& options) {
  Context context = program_context();
  context.threads = options.scene.threads();
  const SkyScene scene = scene_of(context, options);
  const TransferOptions transfer = options.scene.transfer();
  SkyFitOptions fit_options;
  fit_options.weights = parse_weights(options.weights);
  require_writable_outputs(options);

  const std::vector<SkyMap> maps = simulate(context, scene, transfer);
  const SkyTable table = fit(context, maps, fit_options);

  create_folder(options.out);
  const Provenance provenance = provenance_of(context, options, scene);
  if (options.save_maps) write_maps(options.out / "maps", maps, provenance);
  write_table(options.out, table, scene.directions, provenance);

  for (const Turbidity& turbidity : scene.turbidities)
    fmt::print("{}\n", turbidity_text(turbidity, *scene.atmosphere));
  fmt::print("\n{}", table_summary(table, std::string(turbidity_kind_name(options.scene.turbidity_kind()))));
  fmt::print("wrote {} and table.json{}\n", (options.out / "table.csv").string(),
             options.save_maps ? fmt::format(", {} maps in maps", maps.size()) : "");
  require_converged(table);
}

}  // namespace

void add_table_command(CLI::App& program) {
  const auto options = std::make_shared<TableOptions>();
  CLI::App& command = *program.add_subcommand("table", "simulate skies and fit them: the coefficient table");
  command.footer(
      "\nWrites DIR/table.csv and DIR/table.json; one row per altitude, turbidity and sun, in that order.\n"
      "Examples:\n"
      "  skylut table --out out/table\n"
      "  skylut table --out out/city --turbidity-kind preetham-t --turbidities 2,4,6 --albedo 0.15\n"
      "  skylut table --out out/quick --altitudes-km 0 --suns 45:180 --wavelengths-nm 380:780:20 "
      "--save-maps");
  command.add_option("--out", options->out, "folder for the results, created if need be")
      ->required()
      ->type_name("DIR");
  add_numbers(command, "--altitudes-km", options->altitudes_km, {0.0, kHighestAltitude_km, "km"},
              "of the observers above the ground, 0 to 30");
  add_numbers(command, "--turbidities", options->turbidities, {0.0, 1e6, ""},
              "of the kind of --turbidity-kind");
  command
      .add_option("--suns", options->suns,
                  "zenith angle (0 to 96) and azimuth (clockwise from north) in degrees")
      ->capture_default_str()
      ->type_name("Z:A,...");
  command.add_option("--weights", options->weights, "of the directions in the fits: uniform or solid-angle")
      ->capture_default_str()
      ->type_name("NAME");
  command.add_flag("--save-maps", options->save_maps,
                   "also write each row's sky, DIR/maps/entry_001.csv ...");
  options->scene.add_to(command);
  command.callback([options] { run(*options); });
}

}  // namespace skylut::cli
