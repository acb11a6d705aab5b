#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "directions_option.hpp"
#include "number_options.hpp"
#include "output_check.hpp"
#include "program_context.hpp"
#include "progress.hpp"
#include "scene_options.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/export/projection.hpp"
#include "skylut/export/sky_csv.hpp"
#include "skylut/export/sky_exr.hpp"
#include "sun_option.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

struct MapOptions {
  SceneOptions scene;
  fs::path out;
  double altitude_km = 0.0;
  double turbidity = 0.1;
  SunOption sun;
  std::string directions = "utm271";
  std::string projection = "latlong";
  std::string channels = "rgb";
  int size = 256;
  // Which of them were typed: options that exclude each other or belong to one kind of file.
  const CLI::Option* turbidity_option = nullptr;
  const CLI::Option* directions_option = nullptr;
  std::vector<const CLI::Option*> picture_options;
};

enum class FileKind { csv, exr };

FileKind kind_of(const MapOptions& options) {
  const std::string extension = options.out.extension().string();
  const bool csv = extension == ".csv";
  if (!csv && extension != ".exr")
    throw InputError("-o '{}': must be the name of a .csv or .exr file", options.out.string());
  if (!csv && options.directions_option->count() > 0)
    throw InputError("--directions: is for .csv files, must not be given with {}", options.out.string());
  for (const CLI::Option* option : options.picture_options)
    if (csv && option->count() > 0)
      throw InputError("{}: is for .exr files, must not be given with {}", option->get_name(),
                       options.out.string());
  return csv ? FileKind::csv : FileKind::exr;
}

SkyScene scene_of(const Context& context, const MapOptions& options) {
  if (options.scene.turbidity_kind_given() && options.turbidity_option->count() == 0)
    throw InputError("--turbidity-kind: needs --turbidity");
  SkyScene scene = options.scene.scene(context);
  scene.altitudes_km = {options.altitude_km};
  scene.turbidities = {{options.scene.turbidity_kind(), options.turbidity}};
  options.sun.put_into(scene, options.scene, kLowestSun_deg);
  return scene;
}

std::string command_line(const MapOptions& options) {
  std::string text = fmt::format("skylut map --altitude-km {} --turbidity {} {}", options.altitude_km,
                                 options.turbidity, options.sun.command_line());
  if (kind_of(options) == FileKind::csv)
    text += fmt::format(" --directions {}", options.directions);
  else
    text += fmt::format(" --projection {} --size {} --channels {}", options.projection, options.size,
                        options.channels);
  return text + " " + options.scene.command_line();
}

Provenance provenance_of(const Context& context, const MapOptions& options, const SkyScene& scene) {
  Provenance provenance = scene_provenance(context, scene, command_line(options));
  provenance.describe("quality", options.scene.quality());
  return provenance;
}

SkyMap simulate(const Context& context, const SkyScene& scene, TransferOptions transfer) {
  Progress progress("solving the radiative transfer:");
  transfer.progress = [&](std::size_t done, std::size_t all) { progress.show(done, all); };
  return simulate_sky(context, scene, transfer).front();
}

void print_facts(const SkyMap& map, const SkyScene& scene) {
  const auto darker = [](const Yxy& a, const Yxy& b) { return a.Y < b.Y; };
  const auto [darkest, brightest] = std::minmax_element(map.colour.begin(), map.colour.end(), darker);
  fmt::print("altitude {} km, sun {:.6g}:{:.6g} deg, {} directions, {} wavelengths\n", map.altitude_km,
             map.sun.zenith_deg, map.sun.azimuth_deg, map.directions.size(), map.wavelengths.size());
  fmt::print("{}\n", turbidity_text(map.turbidity, *scene.atmosphere));
  fmt::print("luminance {:.5g} to {:.5g} cd/m2\n", darkest->Y, brightest->Y);
}

void write_csv(const Context& context, const MapOptions& options, SkyScene scene,
               const TransferOptions& transfer) {
  scene.directions = directions_of(options.directions);
  scene.directions_name = options.directions;
  require_writable_file("-o", options.out);
  const SkyMap map = simulate(context, scene, transfer);
  const Provenance provenance = provenance_of(context, options, scene);
  write_text_atomically(options.out, sky_csv(map, provenance));
  print_facts(map, scene);
  fmt::print("wrote {}\n", options.out.string());
}

void write_exr(const Context& context, const MapOptions& options, SkyScene scene,
               const TransferOptions& transfer) {
  const std::unique_ptr<Projection> projection = make_projection(options.projection, options.size);
  const std::vector<SkyChannels> channels = parse_sky_channels(options.channels);
  for (const SkyChannels kind : channels) require_writable_file("-o", sky_exr_path(options.out, kind));
  scene.directions = projection->directions();
  scene.directions_name = projection->name();
  const SkyMap map = simulate(context, scene, transfer);
  const Provenance provenance = provenance_of(context, options, scene);
  for (const SkyChannels kind : channels)
    write_sky_exr(sky_exr_path(options.out, kind), map, *projection, kind, provenance);
  print_facts(map, scene);
  if (const std::size_t outside = count_outside_rec709(map); outside > 0)
    fmt::print("{} pixels have a colour outside Rec. 709: a negative R, G or B, kept as it is\n", outside);
  for (const SkyChannels kind : channels) fmt::print("wrote {}\n", sky_exr_path(options.out, kind).string());
}

void run(const MapOptions& options) {
  const FileKind kind = kind_of(options);
  Context context = program_context();
  context.threads = options.scene.threads();
  const SkyScene scene = scene_of(context, options);
  const TransferOptions transfer = options.scene.transfer();
  if (kind == FileKind::csv) return write_csv(context, options, scene, transfer);
  write_exr(context, options, scene, transfer);
}

void add_picture_options(CLI::App& command, MapOptions& options) {
  const std::string group = "Picture (.exr)";
  options.picture_options = {
      command.add_option("--projection", options.projection, "latlong")
          ->capture_default_str()
          ->type_name("NAME")
          ->group(group),
      add_count(command, "--size", options.size, 2, 8192, "height in pixels; latlong is twice as wide")
          ->group(group),
      command.add_option("--channels", options.channels, "rgb, xyz, spectral or several: rgb,spectral")
          ->capture_default_str()
          ->type_name("LIST")
          ->group(group)};
}

}  // namespace

void add_map_command(CLI::App& program) {
  const auto options = std::make_shared<MapOptions>();
  CLI::App& command =
      *program.add_subcommand("map", "simulate one sky, as numbers (.csv) or a picture (.exr)");
  command.footer(
      "\nA picture sky.exr goes to sky_rgb.exr, sky_xyz.exr and sky_spectral.exr, as --channels asks.\n"
      "Examples:\n"
      "  skylut map -o sky.csv --sun-zenith-deg 45 --turbidity 0.2\n"
      "  skylut map -o sky.exr --sun-zenith-deg 85 --altitude-km 12 --size 512 --channels rgb,spectral\n"
      "  skylut map -o sky.exr --latitude 48:51N --longitude 2:21E --time 2024-06-21T09:00Z");
  command.add_option("-o,--output", options->out, "file to write: .csv or .exr")
      ->required()
      ->type_name("FILE");
  add_number(command, "--altitude-km", options->altitude_km, {0.0, kHighestAltitude_km, "km"},
             "of the observer above the ground, 0 to 30");
  options->turbidity_option = add_number(command, "--turbidity", options->turbidity, {0.0, 1e6, ""},
                                         "of the kind of --turbidity-kind");
  options->sun.add_to(command, kLowestSun_deg);
  options->directions_option =
      command.add_option("--directions", options->directions, "utm271, preetham343 or a CSV file (for .csv)")
          ->capture_default_str()
          ->type_name("NAME|FILE");
  add_picture_options(command, *options);
  options->scene.add_to(command);
  command.callback([options] { run(*options); });
}

}  // namespace skylut::cli
