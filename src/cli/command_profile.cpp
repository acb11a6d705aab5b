#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "command_profile_case.hpp"
#include "commands.hpp"
#include "program_context.hpp"
#include "scene_options.hpp"
#include "skylut/atmosphere/atmosphere_description.hpp"
#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/profile/profile.hpp"
#include "skylut/report/profile_report.hpp"
#include "skylut/site/place.hpp"

namespace skylut::cli {

namespace {

struct ShowOptions {
  std::string name;
  bool json = false;
  double turbidity = 0.0;
  std::string turbidity_kind = "aod500";
  std::string aerosol = "rural";
  std::optional<double> humidity_percent;
  std::string latitude;
  std::string longitude = "0";
  double height_m = 0.0;
  std::optional<double> ozone_du;
  std::string albedo = "0.2";
  std::optional<double> water_cm;
  std::optional<double> no2_du;
  std::optional<double> pressure_hpa;
};

AtmosphereDescription atmosphere_of(const ShowOptions& options) {
  AtmosphereDescription description;
  description.profile = options.name;
  description.aerosol = options.aerosol;
  description.humidity_percent = options.humidity_percent;
  description.ground_albedo = options.albedo;
  description.ozone_du = options.ozone_du;
  description.no2_du = options.no2_du;
  description.water_cm = options.water_cm;
  description.surface_pressure_hPa = options.pressure_hpa;
  if (!options.latitude.empty())
    description.place = parse_place(options.latitude, options.longitude, options.height_m);
  return description;
}

void list_profiles() {
  const Context context = program_context();
  for (const std::string& name : profile_names(context))
    fmt::print("{:<20} {}\n", name, load_profile(context, name).description);
}

void show_profile(const ShowOptions& options) {
  const Context context = program_context();
  const TurbidityKind kind = parse_turbidity_kind(options.turbidity_kind);
  const Atmosphere air = build_atmosphere(context, atmosphere_of(options));
  const double aod500 = to_aod500({kind, options.turbidity}, air);
  if (options.json)
    fmt::print("{}\n", profile_json(air, aod500).dump(2));
  else
    fmt::print("{}", profile_text(air, aod500));
}

}  // namespace

void add_profile_command(CLI::App& program) {
  CLI::App* profile =
      program.add_subcommand("profile", "Atmospheric profiles: which there are, what they hold");
  profile->require_subcommand(1);
  profile->add_subcommand("list", "Names of the profiles that come with skylut")->callback(list_profiles);

  CLI::App* show =
      profile->add_subcommand("show", "Levels, columns, optical depths and Table 3.1's quantities");
  const auto options = std::make_shared<ShowOptions>();
  show->add_option("name", options->name, "profile name or TOML file")->required();
  show->add_flag("--json", options->json, "write JSON, in full precision");
  show->add_option("--turbidity", options->turbidity, "aerosol load, shown in all kinds")
      ->capture_default_str();
  show->add_option("--turbidity-kind", options->turbidity_kind,
                   "aod500, aod550, angstrom-beta, preetham-t or visibility-km")
      ->capture_default_str();
  show->add_option("--aerosol", options->aerosol, "aerosol name or TOML file")->capture_default_str();
  show->add_option("--humidity", options->humidity_percent, "relative humidity of its particles, percent");
  CLI::Option* latitude = show->add_option(
      "--latitude", options->latitude, "decimal or DMS; sets gravity and planet radius (default: standard)");
  show->add_option("--longitude", options->longitude, "decimal or DMS")->needs(latitude);
  show->add_option("--height-m", options->height_m, "of the ground above the ellipsoid")->needs(latitude);
  show->add_option("--ozone-du", options->ozone_du, "ozone column, Dobson units (default: the profile's)");
  show->add_option("--water-cm", options->water_cm, "precipitable water, cm (default: the profile's)");
  show->add_option("--no2-du", options->no2_du,
                   "nitrogen dioxide column, Dobson units (default: the profile's)");
  show->add_option("--pressure-hpa", options->pressure_hpa,
                   "pressure at the ground; scales the air and its oxygen (default: the profile's)");
  show->add_option("--albedo", options->albedo, "of the ground: a number, a name or a CSV file")
      ->capture_default_str();
  show->callback([options] { show_profile(*options); });
  add_profile_case_command(*profile);
}

}  // namespace skylut::cli
