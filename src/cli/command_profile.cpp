#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "advice.hpp"
#include "commands.hpp"
#include "options/file_kinds.hpp"
#include "scene_options.hpp"
#include "skylut/report/profile_report.hpp"

namespace skylut::cli {

namespace {

struct ShowOptions {
  std::string name;
  AirOptions air;
  double turbidity = 0.0;
  ComputingOptions computing;
  bool json = false;
};

void list_profiles() {
  const Context context = program_context();
  for (const std::string& name : profile_names(context))
    fmt::print("{:<20} {}\n", name, load_profile(context, name).description);
}

void show_profile(const ShowOptions& options) {
  const Context context = program_context(options.computing);
  const Atmosphere air = build_atmosphere(context, options.air.atmosphere(options.name));
  const Turbidity turbidity{options.air.turbidity_kind(), options.turbidity};
  advise_on_turbidity({&turbidity, 1}, air);
  const double aod500 = to_aod500(turbidity, air);
  if (options.json)
    fmt::print("{}\n", profile_json(air, aod500).dump(2));
  else
    fmt::print("{}", profile_text(air, aod500));
}

Command list_command() {
  Command command;
  command.name = "list";
  command.summary = "names of the profiles that come with skylut";
  command.examples = {"skylut profile list"};
  command.run = [](const OptionSet&) { list_profiles(); };
  return command;
}

Command show_command() {
  const auto options = std::make_shared<ShowOptions>();
  Command command;
  command.name = "show";
  command.summary = "levels, columns, optical depths and Table 3.1's quantities";
  command.examples = {"skylut profile show ussa1976",
                      "skylut profile show tropical --water-cm 3 --turbidity 0.2"};
  OptionSet& set = command.options;
  set.add("PROFILE", options->name, name_or_file(), "a name (skylut profile list) or a TOML file").required =
      true;
  set.add_flag("--json", options->json, "print JSON, in full precision");
  add_turbidity(set, options->turbidity);
  options->air.add_to(set);
  options->computing.add_to(set);
  command.run = [options](const OptionSet& given) {
    require_turbidity_with_its_kind(given);
    show_profile(*options);
  };
  return command;
}

}  // namespace

Command profile_command() {
  Command command;
  command.name = "profile";
  command.summary = "atmospheric profiles: which there are, what they hold";
  command.examples = {"skylut profile list", "skylut profile show ussa1976",
                      "skylut profile case ussa1976 --wavelength-nm 550 -o case.json"};
  command.subcommands = {list_command(), show_command(), profile_case_command()};
  return command;
}

}  // namespace skylut::cli
