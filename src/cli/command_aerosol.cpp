#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <complex>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "number_options.hpp"
#include "program_context.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/text.hpp"
#include "skylut/report/aerosol_report.hpp"
#include "skylut/scattering/aerosol_optics.hpp"
#include "skylut/scattering/mie_sphere.hpp"

namespace skylut::cli {

namespace {

struct MieOptions {
  double size_parameter = 0.0;
  std::string index;
  std::string angles;
  bool json = false;
};

constexpr double kMostAngles = 100001.0;

std::complex<double> parse_index(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 2)
    throw InputError("--index '{}': must be RE,IM, for example 1.5,0.01 (IM > 0: absorbing)", text);
  return {parse_number("--index real part", parts[0], {0.05, 20.0, ""}),
          parse_number("--index imaginary part", parts[1], {0.0, 20.0, ""})};
}

// A list 0,10,90 or a range LO:HI:STEP, degrees.
std::vector<double> parse_angles(const std::string& text) {
  if (text.empty()) return {};
  const NumberRange range{0.0, 180.0, "deg"};
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() == 1) return parse_numbers("--angles", text, range);
  if (parts.size() != 3)
    throw InputError("--angles '{}': must be a list 0,10,90 or LO:HI:STEP in degrees", text);
  const double lowest = parse_number("--angles first", parts[0], range);
  const double highest = parse_number("--angles last", parts[1], range);
  const double step = parse_number("--angles step", parts[2], range);
  const double steps = step > 0.0 ? std::round((highest - lowest) / step) : -1.0;
  if (!(steps >= 0.0 && steps < kMostAngles && std::abs(lowest + steps * step - highest) < 1e-9 * 180.0))
    throw InputError("--angles '{}': must be a whole number of steps upwards, at most {}", text,
                     static_cast<int>(kMostAngles) - 1);
  std::vector<double> angles;
  for (int i = 0; i <= static_cast<int>(steps); ++i) angles.push_back(lowest + i * step);
  return angles;
}

void show_mie(const MieOptions& options) {
  const MieSphere sphere(options.size_parameter, parse_index(options.index));
  const std::vector<double> angle_deg = parse_angles(options.angles);
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

void add_mie(CLI::App& aerosol) {
  CLI::App* mie = aerosol.add_subcommand("mie", "One sphere by Mie's theory: efficiencies, phase function");
  const auto options = std::make_shared<MieOptions>();
  add_number(*mie, "--size-parameter", options->size_parameter, {1e-6, 1e5, ""}, "2 pi radius / wavelength")
      ->default_str("")
      ->required();
  mie->add_option("--index", options->index, "refractive index; IM > 0 means absorbing")
      ->required()
      ->type_name("RE,IM");
  mie->add_option("--angles", options->angles, "phase function at these scattering angles, degrees")
      ->type_name("LIST|LO:HI:STEP");
  mie->add_flag("--json", options->json, "write JSON, in full precision");
  mie->callback([options] { show_mie(*options); });
}

void list_aerosols() {
  const Context context = program_context();
  for (const std::string& name : aerosol_names(context))
    fmt::print("{:<26} {}\n", name, load_aerosol_description(context, name).description);
}

struct ShowOptions {
  std::string name;
  std::optional<double> humidity_percent;
  bool json = false;
};

void show_aerosol(const ShowOptions& options) {
  const Context context = program_context();
  const AerosolOptics optics = load_aerosol(context, options.name, options.humidity_percent);
  if (options.json)
    fmt::print("{}\n", aerosol_report_json(optics).dump(2));
  else
    fmt::print("{}", aerosol_text(optics));
}

void add_show(CLI::App& aerosol) {
  CLI::App* show = aerosol.add_subcommand("show", "Optics by wavelength, Angstrom exponents, vertical shape");
  const auto options = std::make_shared<ShowOptions>();
  show->add_option("name", options->name, "aerosol name or TOML file")->required();
  show->add_option_function<std::string>(
          "--humidity",
          [options](const std::string& text) {
            options->humidity_percent = parse_number("--humidity", text, {0.0, 99.0, "%"});
          },
          "relative humidity in percent, for particles that take up water; default: the file's")
      ->type_name("NUMBER");
  show->add_flag("--json", options->json, "write JSON, in full precision");
  show->callback([options] { show_aerosol(*options); });
}

}  // namespace

void add_aerosol_command(CLI::App& program) {
  CLI::App* aerosol = program.add_subcommand("aerosol", "Aerosols: which there are, what they do to light");
  aerosol->require_subcommand(1);
  aerosol->add_subcommand("list", "Names of the aerosols that come with skylut")->callback(list_aerosols);
  add_show(*aerosol);
  add_mie(*aerosol);
}

}  // namespace skylut::cli
