#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "advice.hpp"
#include "commands.hpp"
#include "directions_option.hpp"
#include "map_pictures.hpp"
#include "memory.hpp"
#include "options/file_kinds.hpp"
#include "options/number_kinds.hpp"
#include "output.hpp"
#include "picture_options.hpp"
#include "scene_options.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/export/sky_csv.hpp"
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
  std::optional<std::string> directions;  // of numbers
  PictureRequest picture;
  std::optional<std::int64_t> frame;
};

bool is_picture(const MapOptions& options) { return ending_of(options.out) == ".exr"; }

// What was not given gets its default, so that it is recorded.
void settle(MapOptions& options, const OptionSet& given) {
  refuse_options_of_other_files(given, options.out, {"--directions"});
  if (is_picture(options))
    options.picture.settle();
  else
    options.directions = options.directions.value_or("utm271");
}

SkyScene scene_of(const Context& context, MapOptions& options) {
  SkyScene scene = options.scene.scene(context);
  scene.altitudes_km = {options.altitude_km};
  scene.turbidities = {{options.scene.air().turbidity_kind(), options.turbidity}};
  if (options.sun.is_series()) return scene;
  options.sun.put_into(scene, options.scene.sun_place());
  options.sun.require_above(domain::kSunZenith_deg.highest, scene.suns.front(),
                            "the sky's light ends at 99 deg (night)");
  return scene;
}

RequestSize size_of(const SkyScene& scene) {
  return {static_cast<double>(scene.directions.size()), static_cast<double>(scene.wavelengths.size())};
}

SkyMap simulate(const Context& context, const MapOptions& options, const SkyScene& scene) {
  advise_on_turbidity(scene.turbidities, *scene.atmosphere);
  advise_on_wavelengths(context, scene.wavelengths);
  return simulate_sky(context, scene, options.scene.transfer()).front();
}

Provenance provenance_of(const Context& context, const MapOptions& options, const SkyScene& scene,
                         const SkyMap& map, const std::string& command) {
  Provenance provenance = options.scene.provenance(context, scene, command);
  provenance.set_instruction_set(map.instruction_set);
  return provenance;
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
               const std::string& command) {
  if (options.sun.is_series()) throw InputError("--time START/END/STEP: is for .exr files");
  scene.directions = directions_of(*options.directions);
  scene.directions_name = *options.directions;
  require_writable("-o", options.out);
  require_memory(size_of(scene));
  const SkyMap map = simulate(context, options, scene);
  write_text_atomically(options.out, sky_csv(map, provenance_of(context, options, scene, map, command)));
  print_facts(map, scene);
  fmt::print("wrote {}\n", options.out.string());
}

// Pictures of one sun, or of many.
void write_exr(const Context& context, MapOptions& options, SkyScene scene, const OptionSet& given) {
  SunSeries series;
  if (options.sun.is_series()) {
    series = options.sun.series(options.scene.sun_place(), scene.sun_distance_au);
  } else {
    series.frames.push_back({1, std::nullopt, scene.suns.front(), scene.sun_distance_au});
    if (options.frame) throw InputError("--frame: needs --suns, --times or --time START/END/STEP");
  }
  scene.suns.clear();
  for (const SunFrame& frame : series.frames) scene.suns.push_back(frame.sun);
  scene.sun_distance_au = 1.0;
  scene.directions_name = options.picture.projection();
  advise_on_turbidity(scene.turbidities, *scene.atmosphere);
  advise_on_wavelengths(context, scene.wavelengths);
  const PictureJob job{options.scene,
                       options.picture,
                       std::move(scene),
                       options.out,
                       options.sun.times_file().value_or(fs::path()),
                       given.command_line("skylut map")};
  if (!options.sun.is_series()) return write_picture(context, job, series.frames.front());
  write_series(context, job, series, static_cast<std::size_t>(options.frame.value_or(0)));
}

void run(MapOptions& options, const OptionSet& given) {
  require_turbidity_with_its_kind(given);
  settle(options, given);
  const Context context = options.scene.context();
  const SkyScene scene = scene_of(context, options);
  if (is_picture(options)) return write_exr(context, options, scene, given);
  write_csv(context, options, scene, given.command_line("skylut map"));
}

}  // namespace

Command map_command() {
  const auto options = std::make_shared<MapOptions>();
  Command command;
  command.name = "map";
  command.summary = "simulate one sky, as numbers (.csv) or a picture (.exr)";
  command.notes =
      "A picture of several kinds of channels goes to sky_rgb.exr, sky_spectral.exr and so on, faces to "
      "sky_px.exr. A series (--time START/END/STEP, --times, --suns) goes to sky_0001.exr and so on, with "
      "sky.csv.";
  command.examples = {
      "skylut map -o sky.csv --sun-zenith-deg 45 --turbidity 0.2",
      "skylut map -o sky.exr --sun-zenith-deg 85 --altitude-km 12 --size 64 --channels rgb,spectral",
      "skylut map -o sky.exr --latitude 48:51N --longitude 2:21E --time 2024-06-21T09:00Z",
      "skylut map -o sky.exr --sun disc --suns 45:90,60:100,75:110 --size 64"};
  OptionSet& set = command.options;
  add_output(set, options->out, file_named({".csv", ".exr"}), "file to write: .csv or .exr").required = true;
  set.add("--altitude-km", options->altitude_km, number(domain::kObserver_km),
          "of the observer above the ground, 0 to 30");
  add_turbidity(set, options->turbidity);
  options->sun.add_to(set, domain::kSunZenith_deg, time_or_steps());
  options->sun.add_apparent_to(set);
  add_directions(set, options->directions);
  options->picture.add_to(set);
  options->sun.add_series_to(set);
  set.add("--frame", options->frame, whole_number({1.0, domain::kMostFrames, ""}),
          "of a series, this one alone")
      .recorded = false;
  options->scene.add_to(set);
  command.run = [options](const OptionSet& given) { run(*options, given); };
  return command;
}

}  // namespace skylut::cli
