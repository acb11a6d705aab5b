#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "number_options.hpp"
#include "output_check.hpp"
#include "program_context.hpp"
#include "progress.hpp"
#include "scene_options.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/export/sun_file.hpp"
#include "skylut/models/closed_form_sun.hpp"
#include "sun_option.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

constexpr double kNadir_deg = 180.0;

struct CommandOptions {
  SceneOptions scene;
  fs::path out;
  double altitude_km = 0.0;
  double turbidity = 0.1;
  SunOption sun;
  bool no_diffuse = false;
  double circumsolar_deg = 0.0;
  std::string model = "shells";
  const CLI::Option* turbidity_option = nullptr;
};

enum class FileKind { none, csv, json };

FileKind kind_of(const fs::path& file) {
  if (file.empty()) return FileKind::none;
  if (file.extension() == ".csv") return FileKind::csv;
  if (file.extension() == ".json") return FileKind::json;
  throw InputError("-o '{}': must be the name of a .csv or .json file", file.string());
}

std::optional<ClosedFormModel> model_of(const CommandOptions& options) {
  if (options.model == "shells") return std::nullopt;
  const ClosedFormModel model = parse_closed_form_model(options.model);
  if (options.circumsolar_deg > 0.0)
    throw InputError("--circumsolar-deg {}: --model {} has no diffuse light, must not be given with it",
                     options.circumsolar_deg, options.model);
  return model;
}

SkyScene scene_of(const Context& context, const CommandOptions& options) {
  if (options.scene.turbidity_kind_given() && options.turbidity_option->count() == 0)
    throw InputError("--turbidity-kind: needs --turbidity");
  SkyScene scene = options.scene.scene(context);
  scene.altitudes_km = {options.altitude_km};
  scene.turbidities = {{options.scene.turbidity_kind(), options.turbidity}};
  // Without diffuse light the sun may be anywhere: its position is wanted at night, too.
  options.sun.put_into(scene, options.scene, kNadir_deg);
  return scene;
}

std::string command_line(const CommandOptions& options) {
  std::string text = fmt::format("skylut sun --altitude-km {} --turbidity {} {}", options.altitude_km,
                                 options.turbidity, options.sun.command_line());
  if (options.no_diffuse) text += " --no-diffuse";
  if (options.circumsolar_deg > 0.0) text += fmt::format(" --circumsolar-deg {}", options.circumsolar_deg);
  if (options.model != "shells") text += fmt::format(" --model {}", options.model);
  return text + " " + options.scene.command_line();
}

Provenance provenance_of(const Context& context, const CommandOptions& options, const SkyScene& scene) {
  Provenance provenance = scene_provenance(context, scene, command_line(options));
  provenance.describe("quality", options.scene.quality());
  return provenance;
}

SunIrradiance simulate(const Context& context, const SkyScene& scene, const CommandOptions& options,
                       TransferOptions transfer) {
  Progress progress("solving the radiative transfer:");
  transfer.progress = [&](std::size_t done, std::size_t all) { progress.show(done, all); };
  return simulate_sun(context, scene, {!options.no_diffuse, options.circumsolar_deg}, transfer);
}

void print_line(const char* what, const std::vector<double>& irradiance, const SunIrradiance& sun) {
  if (irradiance.empty()) return;
  fmt::print("  {:<20} {:10.3f} W/m2 {:11.0f} lux\n", what, broadband_W_m2(irradiance, sun.wavelengths),
             illuminance_lux(irradiance, sun.luminous_weight));
}

void print_facts(const SunIrradiance& sun, const SkyScene& scene) {
  const Direction& direction = sun.sun;
  fmt::print("sun {:.4f} deg from the zenith, azimuth {:.4f} deg, {:.5f} au away, seen from {} km\n",
             direction.zenith_deg, direction.azimuth_deg, scene.sun_distance_au, scene.altitudes_km[0]);
  fmt::print("{}\n", turbidity_text(scene.turbidities[0], *scene.atmosphere));
  if (!sun.beam_arrives) fmt::print("the ground hides the sun: no direct beam\n");
  const double half_nm = 0.5 * sun.wavelengths.step_nm();
  fmt::print("sums over {}-{} nm\n", sun.wavelengths.first_nm() - half_nm,
             sun.wavelengths.last_nm() + half_nm);
  print_line("direct normal", sun.direct_normal, sun);
  print_line("circumsolar normal", sun.circumsolar_normal, sun);
  print_line("diffuse horizontal", sun.diffuse_horizontal, sun);
  print_line("global horizontal", sun.global_horizontal(), sun);
  print_line("extraterrestrial", sun.extraterrestrial, sun);
}

// Some twenty lines: every wavelength of a coarse grid, a choice of a fine one.
void print_table(const SunIrradiance& sun) {
  constexpr std::size_t kMostLines = 21;
  const std::vector<double> global = sun.global_horizontal();
  std::string head = fmt::format("{:>8} {:>9}", "nm", "direct");
  if (!global.empty()) head += fmt::format(" {:>9} {:>9}", "diffuse", "global");
  for (const ConstituentTransmittance& constituent : sun.transmittance)
    head += fmt::format(" {:>9}", constituent.name);
  fmt::print("{}   (W m-2 nm-1; transmittances)\n", head);
  const std::size_t stride = (sun.wavelengths.size() + kMostLines - 1) / kMostLines;
  for (std::size_t i = 0; i < sun.wavelengths.size(); i += stride) {
    std::string line = fmt::format("{:8g} {:9.5f}", sun.wavelengths[i], sun.direct_normal[i]);
    if (!global.empty()) line += fmt::format(" {:9.5f} {:9.5f}", sun.diffuse_horizontal[i], global[i]);
    for (const ConstituentTransmittance& constituent : sun.transmittance)
      line += fmt::format(" {:9.5f}", constituent.band_mean[i]);
    fmt::print("{}\n", line);
  }
}

void run(const CommandOptions& options) {
  const FileKind kind = kind_of(options.out);
  Context context = program_context();
  context.threads = options.scene.threads();
  const std::optional<ClosedFormModel> model = model_of(options);
  const SkyScene scene = scene_of(context, options);
  const TransferOptions transfer = options.scene.transfer();
  if (kind != FileKind::none) require_writable_file("-o", options.out);
  const SunIrradiance sun =
      model ? simulate_sun_closed_form(context, scene, *model) : simulate(context, scene, options, transfer);
  if (kind == FileKind::csv) write_text_atomically(options.out, sun_csv(sun));
  if (kind == FileKind::json)
    write_text_atomically(options.out,
                          sun_json(sun, scene, options.model, provenance_of(context, options, scene)));
  print_facts(sun, scene);
  if (kind == FileKind::none)
    print_table(sun);
  else
    fmt::print("wrote {}\n", options.out.string());
}

}  // namespace

void add_sun_command(CLI::App& program) {
  const auto options = std::make_shared<CommandOptions>();
  CLI::App& command = *program.add_subcommand(
      "sun", "where the sun stands, its spectral irradiance through the air and the sky's");
  command.footer(
      "\nSums and a short table go to the screen, the whole spectrum to a .csv or .json file.\n"
      "Examples:\n"
      "  skylut sun --sun-zenith-deg 48.2 --turbidity 0.084 --solar astm-g173 -o sun.csv\n"
      "  skylut sun --latitude 48:51N --longitude 2:21E --time 2024-06-21T09:00Z --no-diffuse\n"
      "  skylut sun --sun-zenith-deg 60 --model iqbal");
  command.add_option("-o,--output", options->out, "file to write: .csv or .json; default: the screen only")
      ->type_name("FILE");
  add_number(command, "--altitude-km", options->altitude_km, {0.0, kHighestAltitude_km, "km"},
             "of the observer above the ground, 0 to 30");
  options->turbidity_option = add_number(command, "--turbidity", options->turbidity, {0.0, 1e6, ""},
                                         "of the kind of --turbidity-kind");
  options->sun.add_to(command, kNadir_deg);
  command.add_flag("--no-diffuse", options->no_diffuse, "only the direct beam, in an instant");
  add_number(command, "--circumsolar-deg", options->circumsolar_deg, {0.0, 10.0, "deg"},
             "also the diffuse light within this angle of the sun, 0 to 10; 0: not");
  command
      .add_option("--model", options->model,
                  "shells (ours), or a closed form for the direct beam alone: iqbal or smarts-like")
      ->capture_default_str()
      ->type_name("NAME");
  options->scene.add_to(command);
  command.callback([options] { run(*options); });
}

}  // namespace skylut::cli
