#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "options/file_kinds.hpp"
#include "options/light_kinds.hpp"
#include "options/number_kinds.hpp"
#include "program_context.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/report/aerosol_report.hpp"
#include "skylut/scattering/aerosol_optics.hpp"
#include "skylut/scattering/mie_sphere.hpp"

namespace skylut::cli {

namespace {

struct MieOptions {
  std::optional<double> size_parameter;
  std::optional<std::complex<double>> index;
  std::vector<double> angle_deg;
  bool json = false;
};

void show_mie(const MieOptions& options) {
  const MieSphere sphere(*options.size_parameter, *options.index);
  const std::vector<double>& angle_deg = options.angle_deg;
  std::vector<double> phase;
  for (const double angle : angle_deg)
    phase.push_back(sphere.phase_function(std::cos(angle * kRadiansPerDegree)));

  if (options.json) {
    nlohmann::ordered_json json{
        {"q_ext", sphere.q_ext()}, {"q_sca", sphere.q_sca()}, {"asymmetry", sphere.asymmetry()}};
    if (!angle_deg.empty()) {
      json["angle_deg"] = angle_deg;
      json["phase_function"] = phase;
    }
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("extinction efficiency  {:.8g}\nscattering efficiency  {:.8g}\nasymmetry              {:.8g}\n",
             sphere.q_ext(), sphere.q_sca(), sphere.asymmetry());
  if (!angle_deg.empty()) fmt::print("\nangle/deg   phase function (mean over all directions: 1)\n");
  for (std::size_t i = 0; i < angle_deg.size(); ++i) fmt::print("{:9g}   {:.8g}\n", angle_deg[i], phase[i]);
}

Command mie_command() {
  const auto options = std::make_shared<MieOptions>();
  Command command;
  command.name = "mie";
  command.summary = "one sphere by Mie's theory: efficiencies, phase function";
  command.examples = {"skylut aerosol mie --size-parameter 5.213 --index 1.55,0",
                      "skylut aerosol mie --size-parameter 10 --index 1.5,0.01 --angles 0:180:30"};
  OptionSet& set = command.options;
  set.add("--size-parameter", options->size_parameter, number(domain::kSizeParameter),
          "2 pi radius / wavelength")
      .required = true;
  set.add("--index", options->index, refractive_index(), "refractive index; IM > 0 means absorbing")
      .required = true;
  set.add("--angles", options->angle_deg,
          numbers_or_steps(domain::kAnyZenith_deg, domain::kMostScatteringAngles),
          "phase function at these scattering angles, degrees");
  set.add_flag("--json", options->json, "print JSON, in full precision");
  command.run = [options](const OptionSet&) { show_mie(*options); };
  return command;
}

void list_aerosols() {
  const Context context = program_context();
  for (const std::string& name : aerosol_names(context))
    fmt::print("{:<26} {}\n", name, load_aerosol_description(context, name).description);
}

Command list_command() {
  Command command;
  command.name = "list";
  command.summary = "names of the aerosols that come with skylut";
  command.examples = {"skylut aerosol list"};
  command.run = [](const OptionSet&) { list_aerosols(); };
  return command;
}

struct ShowOptions {
  std::string name;
  std::optional<double> humidity_percent;
  ComputingOptions computing;
  bool json = false;
};

void show_aerosol(const ShowOptions& options) {
  const Context context = program_context(options.computing);
  const AerosolOptics optics = load_aerosol(context, options.name, options.humidity_percent);
  if (options.json)
    fmt::print("{}\n", aerosol_report_json(optics).dump(2));
  else
    fmt::print("{}", aerosol_text(optics));
}

Command show_command() {
  const auto options = std::make_shared<ShowOptions>();
  Command command;
  command.name = "show";
  command.summary = "optics by wavelength, Angstrom exponents, vertical shape";
  command.examples = {"skylut aerosol show rural", "skylut aerosol show urban --humidity 80 --json"};
  OptionSet& set = command.options;
  set.add("AEROSOL", options->name, name_or_file(), "a name (skylut aerosol list) or a TOML file").required =
      true;
  set.add("--humidity", options->humidity_percent, number(domain::kHumidity_percent),
          "relative humidity in percent, for particles that take up water; default: the file's");
  set.add_flag("--json", options->json, "print JSON, in full precision");
  options->computing.add_to(set);
  command.run = [options](const OptionSet&) { show_aerosol(*options); };
  return command;
}

}  // namespace

Command aerosol_command() {
  Command command;
  command.name = "aerosol";
  command.summary = "aerosols: which there are, what they do to light";
  command.examples = {"skylut aerosol list", "skylut aerosol show rural",
                      "skylut aerosol mie --size-parameter 5.213 --index 1.55,0"};
  command.subcommands = {list_command(), show_command(), mie_command()};
  return command;
}

}  // namespace skylut::cli
