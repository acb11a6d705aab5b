#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/export/sky_csv_reader.hpp"
#include "skylut/fit/fit_report_json.hpp"
#include "skylut/fit/fit_sky.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

struct FitCommandOptions {
  fs::path file;
  fs::path out;
  std::optional<double> sun_zenith_deg;
  std::optional<double> sun_azimuth_deg;
  std::string weights = "uniform";
  bool json = false;
};

// A sky as the fit takes it.
struct FitInput {
  SkyCsv sky;
  std::vector<SkyDirection> views;
  std::vector<Yxy> colours;
  double sun_zenith_deg = 0.0;
};

// Index of the row that looks straight up.
std::size_t zenith_row(const FitCommandOptions& options, const SkyCsv& sky) {
  constexpr double kZenith_deg = 1e-6;
  for (std::size_t i = 0; i < sky.rows.size(); ++i)
    if (sky.rows[i].zenith_deg <= kZenith_deg) return i;
  throw InputError("{}: no row with zenith_deg 0: the fit is scaled to the zenith and needs it",
                   options.file.string());
}

// γ from the azimuths if the sun is known, from the file's own γ column otherwise.
FitInput prepare(const FitCommandOptions& options) {
  FitInput input;
  input.sky = read_sky_csv(options.file);
  const std::vector<SkyCsvRow>& rows = input.sky.rows;
  const SkyCsvRow& top = rows[zenith_row(options, input.sky)];
  const auto zenith = options.sun_zenith_deg ? options.sun_zenith_deg : input.sky.sun_zenith_deg;
  const auto azimuth = options.sun_azimuth_deg ? options.sun_azimuth_deg : input.sky.sun_azimuth_deg;
  if (zenith && !(*zenith >= 0.0 && *zenith <= 180.0))
    throw InputError("{}: sun_zenith_deg {}: must lie within 0-180", options.file.string(), *zenith);
  const bool from_azimuth = top.azimuth_deg && zenith && azimuth;
  if (!from_azimuth && !top.gamma_deg)
    throw InputError(
        "{}: sun unknown: give --sun-zenith-deg and --sun-azimuth-deg, or '# sun_zenith_deg=…' and "
        "'# sun_azimuth_deg=…' in the file, or a column gamma_deg",
        options.file.string());
  if (from_azimuth) {
    input.sun_zenith_deg = *zenith;
  } else {
    input.sun_zenith_deg = *top.gamma_deg;
    if (zenith && std::abs(*zenith - *top.gamma_deg) > 0.01)
      throw InputError("{}:{}: gamma_deg {} at the zenith: must be the sun's zenith angle, given as {}",
                       options.file.string(), top.line, *top.gamma_deg, *zenith);
  }
  for (const SkyCsvRow& row : rows) {
    const double gamma_rad = from_azimuth
                                 ? angle_between({row.zenith_deg, *row.azimuth_deg}, {*zenith, *azimuth})
                                 : *row.gamma_deg * kRadiansPerDegree;
    input.views.push_back({row.zenith_deg * kRadiansPerDegree, gamma_rad});
    input.colours.push_back(row.colour);
  }
  return input;
}

Json report_json(const FitReport& report, const FitInput& input) {
  const SkyCsvRow& worst = input.sky.rows[report.worst_direction];
  Json place = {{"line", worst.line}, {"zenith_deg", worst.zenith_deg}};
  if (worst.azimuth_deg) place["azimuth_deg"] = *worst.azimuth_deg;
  place["gamma_deg"] = input.views[report.worst_direction].gamma_rad * kDegreesPerRadian;
  Json json = fit_report_json(report, std::move(place));
  json["zenith"] = report.zenith_value;
  return json;
}

std::string as_json(const FitCommandOptions& options, const FitInput& input, const SkyFit& fit) {
  const Json json = {{"format", "skylut fit"},
                     {"format_version", 1},
                     {"file", options.file.filename().string()},
                     {"directions", input.views.size()},
                     {"sun_zenith_deg", input.sun_zenith_deg},
                     {"weights", options.weights},
                     {"residuals", {{"Y", "relative"}, {"x", "absolute"}, {"y", "absolute"}}},
                     {"Y", report_json(fit.Y, input)},
                     {"x", report_json(fit.x, input)},
                     {"y", report_json(fit.y, input)}};
  return json.dump(1) + "\n";
}

void print_channel(const char* name, const FitReport& report, const FitInput& input) {
  const std::array<double, 5> values = report.coefficients.values();
  fmt::print("\n{}: zenith {:.6g}, RMSE {:.4g}{}\n", name, report.zenith_value, report.rmse,
             name[0] == 'Y' ? " of the value" : "");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const char* note = report.at_bound[i]     ? "on its bound"
                       : report.determined[i] ? ""
                                              : "not determined by the data";
    fmt::print("  {} {:>14.7g} +- {:<10.3g} {}\n", kPerezNames[i], values[i], report.standard_error[i], note);
  }
  const SkyCsvRow& worst = input.sky.rows[report.worst_direction];
  fmt::print("  worst: {:+.4g} at zenith angle {:g} deg, {:.4g} deg from the sun (line {})\n",
             report.worst_residual, worst.zenith_deg,
             input.views[report.worst_direction].gamma_rad * kDegreesPerRadian, worst.line);
  fmt::print("  {} after {} iterations\n", to_string(report.termination), report.iterations);
}

void run(const FitCommandOptions& options) {
  const FitInput input = prepare(options);
  SkyFitOptions fit_options;
  if (options.weights == "solid-angle") fit_options.weights = SampleWeights::solid_angle;
  SkyFit fit;
  try {
    fit = fit_sky(input.views, input.colours, input.sun_zenith_deg * kRadiansPerDegree, fit_options);
  } catch (const InputError& error) {
    throw InputError("{}: {}", options.file.string(), error.what());
  }
  if (!options.out.empty()) write_text_atomically(options.out, as_json(options, input, fit));
  if (options.json) {
    fmt::print("{}", as_json(options, input, fit));
    require_converged(fit);
    return;
  }
  fmt::print("{}: {} directions, sun at zenith angle {:g} deg, {} weights\n", options.file.string(),
             input.views.size(), input.sun_zenith_deg, options.weights);
  fmt::print(
      "v = v_zenith F(theta,gamma)/F(0,theta_sun), F = (1 + A exp(B/cos theta)) (1 + C exp(D gamma) + E "
      "cos^2 "
      "gamma)\n");
  print_channel("Y", fit.Y, input);
  print_channel("x", fit.x, input);
  print_channel("y", fit.y, input);
  if (!options.out.empty()) fmt::print("\nwrote {}\n", options.out.string());
  require_converged(fit);
}

}  // namespace

void add_fit_command(CLI::App& program) {
  const auto options = std::make_shared<FitCommandOptions>();
  CLI::App& command = *program.add_subcommand("fit", "fit Perez coefficients to any sky (.csv)");
  command.footer(
      "\nFILE: columns zenith_deg, azimuth_deg or gamma_deg, Y_cd_m2 (or Y), x, y; one row must be the "
      "zenith.\n"
      "Example:\n  skylut fit sky.csv --sun-zenith-deg 45 --sun-azimuth-deg 90 --json");
  command.add_option("FILE", options->file, "the sky, as skylut map -o sky.csv writes it or anybody's")
      ->required();
  command.add_option("--sun-zenith-deg", options->sun_zenith_deg, "of the sun, if the file does not say")
      ->check(CLI::Range(0.0, 180.0));
  command.add_option("--sun-azimuth-deg", options->sun_azimuth_deg, "of the sun, clockwise from north")
      ->check(CLI::Range(0.0, 360.0));
  command.add_option("--weights", options->weights, "of the directions: uniform or solid-angle")
      ->capture_default_str()
      ->check(CLI::IsMember({"uniform", "solid-angle"}));
  command.add_flag("--json", options->json, "print the result as JSON");
  command.add_option("-o,--output", options->out, "file for the result as JSON")->type_name("FILE");
  command.callback([options] { run(*options); });
}

}  // namespace skylut::cli
