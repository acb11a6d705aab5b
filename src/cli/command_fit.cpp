#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "fit_form.hpp"
#include "options/file_kinds.hpp"
#include "options/light_kinds.hpp"
#include "options/number_kinds.hpp"
#include "output.hpp"
#include "program_context.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/report/fit_report.hpp"
#include "weights_kind.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

struct FitArguments {
  fs::path file;
  std::optional<fs::path> out;
  std::optional<double> sun_zenith_deg;
  std::optional<double> sun_azimuth_deg;
  SampleWeights weights = SampleWeights::uniform;
  bool json = false;
  FormRequest form;
};

// Index of the row that looks straight up.
std::size_t zenith_row(const FitArguments& options, const SkyCsv& sky) {
  constexpr double kZenith_deg = 1e-6;
  for (std::size_t i = 0; i < sky.rows.size(); ++i)
    if (sky.rows[i].zenith_deg <= kZenith_deg) return i;
  throw InputError("{}: no row with zenith_deg 0: the fit is scaled to the zenith and needs it",
                   options.file.string());
}

// The sun of the command line goes before that of the file, which may have been the wrong one; not in
// silence.
void say_which_sun(const FitArguments& options, const SkyCsv& sky) {
  const auto compare = [&](const char* option, const std::optional<double>& given,
                           const std::optional<double>& own, const char* name) {
    constexpr double kSame_deg = 1e-6;
    if (given && own && std::abs(std::remainder(*given - *own, 360.0)) > kSame_deg)
      warn("{} {}: used instead of {} {} of {}", option, *given, name, *own, options.file.string());
  };
  compare("--sun-zenith-deg", options.sun_zenith_deg, sky.sun_zenith_deg, "sun_zenith_deg");
  compare("--sun-azimuth-deg", options.sun_azimuth_deg, sky.sun_azimuth_deg, "sun_azimuth_deg");
}

// γ from the azimuths if the sun is known, from the file's own γ column otherwise.
FittedSky fitted(const FitArguments& options) {
  FittedSky input;
  input.file = options.file.string();
  input.weights = weights_kind().write(options.weights);
  input.sky = read_sky_csv(options.file);
  const std::vector<SkyCsvRow>& rows = input.sky.rows;
  const SkyCsvRow& top = rows[zenith_row(options, input.sky)];
  const auto zenith = options.sun_zenith_deg ? options.sun_zenith_deg : input.sky.sun_zenith_deg;
  const auto azimuth = options.sun_azimuth_deg ? options.sun_azimuth_deg : input.sky.sun_azimuth_deg;
  if (zenith && !domain::kAnyZenith_deg.holds(*zenith))
    throw InputError("{}: sun_zenith_deg {}: must lie within 0-180", options.file.string(), *zenith);
  say_which_sun(options, input.sky);
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
  std::vector<Yxy> colours;
  for (const SkyCsvRow& row : rows) {
    const double gamma_rad = from_azimuth
                                 ? angle_between({row.zenith_deg, *row.azimuth_deg}, {*zenith, *azimuth})
                                 : *row.gamma_deg * kRadiansPerDegree;
    input.views.push_back({row.zenith_deg * kRadiansPerDegree, gamma_rad});
    colours.push_back(row.colour);
  }
  SkyFitOptions fit_options;
  fit_options.weights = options.weights;
  try {
    input.fit = fit_sky(input.views, colours, input.sun_zenith_deg * kRadiansPerDegree, fit_options);
  } catch (const InputError& error) {
    throw InputError("{}: {}", options.file.string(), error.what());
  }
  return input;
}

// The options of one sky's fit mean nothing to a form.
void fit_form(const FitArguments& options, const OptionSet& given) {
  for (const char* name : {"--sun-zenith-deg", "--sun-azimuth-deg", "--json"})
    if (given.given(name)) throw InputError("{}: must not be given with --form", name);
  if (options.weights != SampleWeights::uniform)
    throw InputError("--weights: must not be given with --form, which weights by solid angle");
  if (!options.out) throw InputError("--form: needs -o MODEL.json");
  options.form.run(options.file, *options.out, given.command_line("skylut fit"));
}

void run(const FitArguments& options, const OptionSet& given) {
  if (options.form.wanted()) return fit_form(options, given);
  options.form.refuse_without_form(given);
  const std::string command_line = given.command_line("skylut fit");
  const FittedSky sky = fitted(options);
  Provenance provenance(command_line);
  provenance.add_source(program_context(), options.file);
  if (options.out) write_result(*options.out, fit_json(sky, provenance));
  if (!options.out || !is_standard_output(*options.out)) {
    fmt::print("{}", options.json ? fit_json(sky, provenance) : fit_text(sky));
    if (options.out && !options.json) fmt::print("\nwrote {}\n", options.out->string());
  }
  require_converged(sky.fit);
}

}  // namespace

Command fit_command() {
  const auto options = std::make_shared<FitArguments>();
  Command command;
  command.name = "fit";
  command.summary = "fit Perez coefficients to any sky (.csv), or a sky model to many";
  command.notes =
      "FILE: columns zenith_deg, azimuth_deg or gamma_deg, Y_cd_m2 (or Y), x, y; one row must be the "
      "zenith.\n"
      "With --form: a sky.csv, a folder of them, or a table's folder, which stands for its conditions.\n" +
      FormRequest::forms_text();
  command.examples = {"skylut map -o sky.csv --sun-zenith-deg 45 --sun-azimuth-deg 90", "skylut fit sky.csv",
                      "skylut fit sky.csv --sun-zenith-deg 45 --sun-azimuth-deg 90 --json",
                      "skylut fit sky.csv --form perez -o sky.json"};
  OptionSet& set = command.options;
  set.add("FILE", options->file, file_in(), "the sky, as skylut map -o sky.csv writes it or anybody's")
      .required = true;
  set.add("--sun-zenith-deg", options->sun_zenith_deg, number(domain::kAnyZenith_deg),
          "of the sun, if the file does not say");
  set.add("--sun-azimuth-deg", options->sun_azimuth_deg, azimuth(), "of the sun, clockwise from north");
  set.add("--weights", options->weights, weights_kind(), "of the directions: uniform or solid-angle");
  set.add_flag("--json", options->json, "print the result as JSON");
  add_output(set, options->out, file_out(), "file for the result as JSON; of --form the model");
  options->form.add_to(set);
  command.run = [options](const OptionSet& given) { run(*options, given); };
  return command;
}

}  // namespace skylut::cli
