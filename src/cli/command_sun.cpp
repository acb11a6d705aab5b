#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "advice.hpp"
#include "commands.hpp"
#include "options/file_kinds.hpp"
#include "options/light_kinds.hpp"
#include "options/number_kinds.hpp"
#include "output.hpp"
#include "scene_options.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/export/sun_file.hpp"
#include "skylut/models/closed_form_sun.hpp"
#include "skylut/report/sun_report.hpp"
#include "skylut/sky/limb_darkening.hpp"
#include "skylut/sky/sun_appearance.hpp"
#include "skylut/sky/sun_disc.hpp"
#include "sun_option.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

// Of the direct beam: none is ours, through shells.
using Model = std::optional<ClosedFormModel>;

struct SunOptions {
  SceneOptions scene;
  std::optional<fs::path> out;
  double altitude_km = 0.0;
  double turbidity = 0.1;
  SunOption sun;
  bool no_diffuse = false;
  double circumsolar_deg = 0.0;
  std::optional<double> tilt_deg;
  std::optional<double> tilt_azimuth_deg;
  Model model;
};

Kind<Model> model_kind() {
  return choice<Model>({{"shells", std::nullopt},
                        {"iqbal", ClosedFormModel::iqbal},
                        {"smarts-like", ClosedFormModel::smarts_like}});
}

void require_low_enough_demands(const SunOptions& options, const Direction& sun) {
  if (options.model)
    options.sun.require_above(90.0, sun, "closed forms end at the horizon, 90 deg");
  else if (!options.no_diffuse)
    options.sun.require_above(domain::kSunZenith_deg.highest, sun,
                              "diffuse light ends at 99 deg (night): use --no-diffuse");
}

SkyScene scene_of(const Context& context, SunOptions& options) {
  if (options.model && options.circumsolar_deg > 0.0)
    throw InputError("--circumsolar-deg {}: --model {} has no diffuse light, must not be given with it",
                     options.circumsolar_deg, model_kind().write(options.model));
  if (options.model && options.tilt_deg)
    throw InputError("--tilt-deg {}: --model {} has no diffuse light, must not be given with it",
                     *options.tilt_deg, model_kind().write(options.model));
  SkyScene scene = options.scene.scene(context);
  scene.altitudes_km = {options.altitude_km};
  scene.turbidities = {{options.scene.air().turbidity_kind(), options.turbidity}};
  options.sun.put_into(scene, options.scene.sun_place());
  // Without diffuse light the sun may be anywhere: its position is wanted at night, too.
  require_low_enough_demands(options, scene.suns.front());
  return scene;
}

SunIrradianceOptions irradiances(SunOptions& options) {
  SunIrradianceOptions asked;
  asked.exact = options.scene.exact();
  asked.diffuse = !options.no_diffuse;
  asked.circumsolar_half_angle_deg = options.circumsolar_deg;
  if (options.tilt_azimuth_deg && !options.tilt_deg) throw InputError("--tilt-azimuth-deg: needs --tilt-deg");
  if (options.tilt_deg) {
    options.tilt_azimuth_deg = options.tilt_azimuth_deg.value_or(TiltedPlane{}.azimuth_deg);  // recorded
    asked.plane = TiltedPlane{*options.tilt_deg, *options.tilt_azimuth_deg};
  }
  return asked;
}

void print_facts(const SunIrradiance& sun, const SunAppearance& appearance, const SkyScene& scene,
                 bool shells) {
  fmt::print("sun {:.4f} deg from the zenith, azimuth {:.4f} deg, {:.5f} au away, seen from {} km\n",
             sun.sun.zenith_deg, sun.sun.azimuth_deg, scene.sun_distance_au, scene.altitudes_km[0]);
  if (shells) fmt::print("{}", refracted_sun_text(refracted_sun(scene)));
  fmt::print("{}\n", turbidity_text(scene.turbidities[0], *scene.atmosphere));
  if (!sun.beam_arrives) fmt::print("the ground hides the sun: no direct beam\n");
  fmt::print("{}{}", sun_sums_text(sun), sun_appearance_text(appearance));
}

void run(SunOptions& options, const OptionSet& given) {
  require_turbidity_with_its_kind(given);
  if (options.out) require_writable("-o", *options.out);
  const SunIrradianceOptions asked = irradiances(options);
  const Context context = options.scene.context();
  const SkyScene scene = scene_of(context, options);
  advise_on_turbidity(scene.turbidities, *scene.atmosphere);
  advise_on_wavelengths(context, scene.wavelengths);
  const SunIrradiance sun = options.model ? simulate_sun_closed_form(context, scene, *options.model)
                                          : simulate_sun(context, scene, asked, options.scene.transfer());
  const SunAppearance appearance = options.model ? sun_appearance(context, sun, scene.sun_distance_au)
                                                 : sun_appearance(context, sun, SunDisc(context, scene));
  if (!options.out) {
    print_facts(sun, appearance, scene, !options.model);
    fmt::print("{}", sun_spectrum_text(sun));
    return;
  }
  const bool json = ending_of(*options.out) == ".json";
  Provenance provenance = options.scene.provenance(context, scene, given.command_line("skylut sun"));
  provenance.set_instruction_set(sun.instruction_set);
  if (!options.model) provenance.add_source(context, LimbDarkening::file(context));
  write_text_atomically(
      *options.out,
      json ? sun_json(sun, appearance, scene, model_kind().write(options.model), provenance) : sun_csv(sun));
  print_facts(sun, appearance, scene, !options.model);
  fmt::print("wrote {}\n", options.out->string());
}

}  // namespace

Command sun_command() {
  const auto options = std::make_shared<SunOptions>();
  Command command;
  command.name = "sun";
  command.summary = "where the sun stands, its spectral irradiance through the air and the sky's";
  command.notes = "Sums and a short table go to the screen, the whole spectrum to a .csv or .json file.";
  command.examples = {"skylut sun --sun-zenith-deg 48.2 --turbidity 0.084 --solar astm-g173 -o sun.csv",
                      "skylut sun --latitude 48:51N --longitude 2:21E --time 2024-06-21T09:00Z --no-diffuse",
                      "skylut sun --sun-zenith-deg 60 --model iqbal"};
  OptionSet& set = command.options;
  add_output(set, options->out, file_named({".csv", ".json"}),
             "file to write: .csv or .json; default: the screen only");
  set.add("--altitude-km", options->altitude_km, number(domain::kObserver_km),
          "of the observer above the ground, 0 to 30");
  add_turbidity(set, options->turbidity);
  options->sun.add_to(set, domain::kAnyZenith_deg);
  options->sun.add_apparent_to(set);
  set.add_flag("--no-diffuse", options->no_diffuse, "only the direct beam, in an instant");
  set.add("--circumsolar-deg", options->circumsolar_deg, number(domain::kCircumsolar_deg),
          "also the diffuse light within this angle of the sun, 0 to 10; 0: not");
  set.add("--tilt-deg", options->tilt_deg, number(domain::kTilt_deg),
          "also the irradiance on a plane tilted from the horizontal: 90 is a wall, 180 faces down");
  set.add("--tilt-azimuth-deg", options->tilt_azimuth_deg, azimuth(),
          "that the plane faces, clockwise from north; default: 180");
  set.add("--model", options->model, model_kind(),
          "shells (ours), or a closed form for the direct beam alone: iqbal or smarts-like");
  options->scene.add_to(set);
  command.run = [options](const OptionSet& given) { run(*options, given); };
  return command;
}

}  // namespace skylut::cli
