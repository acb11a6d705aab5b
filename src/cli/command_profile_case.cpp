#include "command_profile_case.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "number_options.hpp"
#include "output_check.hpp"
#include "program_context.hpp"
#include "scene_options.hpp"
#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/cases/optical_case.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/text.hpp"
#include "skylut/profile/profile.hpp"

namespace skylut::cli {

namespace {

struct CaseOptions {
  SceneOptions scene;
  std::string name;
  std::filesystem::path out;
  double turbidity = 0.1;
  std::string views = "0:0,30:0,30:90,30:180,60:0,60:90,60:180,85:0,85:90,85:180";
  int absorption_term = 1;
  OpticalCaseRequest request;
  const CLI::Option* turbidity_option = nullptr;
  const CLI::Option* term_option = nullptr;
};

std::vector<RelativeView> parse_views(const std::string& text) {
  std::vector<RelativeView> views;
  for (const std::string& part : split(text, ',')) {
    const std::vector<std::string> angles = split(part, ':');
    if (angles.size() != 2)
      throw InputError("view '{}': must be ZENITH:AZIMUTH in degrees, for example 60:90", part);
    views.push_back({parse_number("view zenith angle", angles[0], {0.0, 180.0, "deg"}),
                     parse_number("view azimuth from the sun's", angles[1], {0.0, 180.0, "deg"})});
  }
  return views;
}

std::string command_line(const CaseOptions& options) {
  const OpticalCaseRequest& request = options.request;
  std::string text = fmt::format("skylut profile case {} --wavelength-nm {} --band-nm {}", options.name,
                                 request.wavelength_nm, request.band_nm);
  if (options.term_option->count() > 0) text += fmt::format(" --absorption-term {}", options.absorption_term);
  return text + fmt::format(" --altitude-km {} --sun-zenith-deg {} --view {} --turbidity {} {}",
                            request.altitude_km, request.sun_zenith_deg, options.views, options.turbidity,
                            options.scene.air_command_line());
}

void run(const CaseOptions& options) {
  if (options.scene.turbidity_kind_given() && options.turbidity_option->count() == 0)
    throw InputError("--turbidity-kind: needs --turbidity");
  OpticalCaseRequest request = options.request;
  request.views = parse_views(options.views);
  if (options.term_option->count() > 0) request.absorption_term = options.absorption_term;
  const Context context = program_context();
  AtmosphereDescription description = options.scene.atmosphere();
  description.profile = options.name;
  const Atmosphere air = build_atmosphere(context, description);
  request.aod500 = to_aod500({options.scene.turbidity_kind(), options.turbidity}, air);
  if (!options.out.empty()) require_writable_file("-o", options.out);
  nlohmann::ordered_json document = optical_case(air, request);
  document["command"] = command_line(options);
  const std::string text = document.dump(1) + "\n";
  if (options.out.empty())
    fmt::print("{}", text);
  else
    write_text_atomically(options.out, text);
}

}  // namespace

void add_profile_case_command(CLI::App& profile) {
  const auto options = std::make_shared<CaseOptions>();
  CLI::App& command = *profile.add_subcommand(
      "case", "The air at one wavelength as explicit layers: a case for skylut solve");
  command.footer(
      "\nExample:\n"
      "  skylut profile case ussa1976 --wavelength-nm 550 --turbidity 0.2 --sun-zenith-deg 60 -o case.json\n"
      "  skylut solve case.json");
  command.add_option("name", options->name, "profile name or TOML file")->required();
  command.add_option("-o,--output", options->out, "where to write; default: the screen")->type_name("FILE");
  add_number(command, "--wavelength-nm", options->request.wavelength_nm, {300.0, 1000.0, "nm"}, "300 to 1000")
      ->required();
  add_number(command, "--band-nm", options->request.band_nm, {0.01, 100.0, "nm"},
             "width of the band: absorption by lines and the ground's albedo are its means");
  options->term_option = add_count(command, "--absorption-term", options->absorption_term, 1, 1'000'000,
                                   "which of the band's terms, where lines absorb");
  options->turbidity_option = add_number(command, "--turbidity", options->turbidity, {0.0, 1e6, ""},
                                         "of the kind of --turbidity-kind");
  add_number(command, "--altitude-km", options->request.altitude_km, {0.0, kHighestAltitude_km, "km"},
             "of the observer above the ground, 0 to 30");
  add_number(command, "--sun-zenith-deg", options->request.sun_zenith_deg, {0.0, kLowestSun_deg, "deg"},
             "of the sun, 0 to 96");
  command
      .add_option("--view", options->views,
                  "zenith angle (0 to 180) and azimuth from the sun's (0 to 180), degrees")
      ->capture_default_str()
      ->type_name("Z:A,...");
  options->scene.add_air_to(command);
  command.callback([options] { run(*options); });
}

}  // namespace skylut::cli
