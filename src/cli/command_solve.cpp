#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "number_options.hpp"
#include "program_context.hpp"
#include "skylut/cases/solve_case.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/json_reader.hpp"
#include "skylut/core/text.hpp"

namespace skylut::cli {
namespace {

struct SolveArguments {
  std::string input;
  std::string output;
  Quality quality = Quality::standard;
  std::vector<std::string> limits;  // NAME=VALUE
  SolveOptions options;
  int threads = 0;
};

DiscretisationOptions discretisation(const SolveArguments& arguments) {
  DiscretisationOptions chosen = discretisation_of(arguments.quality);
  for (const std::string& text : arguments.limits) {
    const std::vector<std::string> parts = split(text, '=');
    if (parts.size() != 2)
      throw InputError("--limit '{}': must be NAME=VALUE, for example optical-step=0.01", text);
    constexpr double kAny = std::numeric_limits<double>::max();
    set_discretisation(chosen, parts[0], parse_number("--limit " + parts[0], parts[1], {-kAny, kAny, ""}));
  }
  return chosen;
}

void run(SolveArguments& arguments) {
  arguments.options.discretisation = discretisation(arguments);
  Context context = program_context();
  context.threads = arguments.threads;
  const nlohmann::ordered_json answer =
      solve_case(context, read_json_file(arguments.input), arguments.input, arguments.options);
  const std::string text = answer.dump(1) + "\n";
  if (arguments.output.empty())
    fmt::print("{}", text);
  else
    write_text_atomically(arguments.output, text);
}

}  // namespace

void add_solve_command(CLI::App& app) {
  const auto arguments = std::make_shared<SolveArguments>();
  CLI::App* command = app.add_subcommand(
      "solve", "Radiative transfer through explicit layers: a solver case with our radiances");
  command->add_option("case", arguments->input, "Case file (JSON)")->required();
  command->add_option("-o,--output", arguments->output, "Where to write; the screen if not given");
  SolveOptions& options = arguments->options;
  const std::map<std::string, SolveMethod> methods{{"default", SolveMethod::standard},
                                                   {"monte-carlo", SolveMethod::monte_carlo}};
  command->add_option("--method", options.method, "default or monte-carlo (spherical cases)")
      ->transform(CLI::CheckedTransformer(methods));
  const std::map<std::string, Quality> qualities{
      {"draft", Quality::draft}, {"default", Quality::standard}, {"reference", Quality::reference}};
  command->add_option("--quality", arguments->quality, "draft, default or reference (spherical solver)")
      ->transform(CLI::CheckedTransformer(qualities));
  command
      ->add_option("--limit", arguments->limits,
                   "Refine one number of the quality, for convergence studies: optical-step=0.01 and others")
      ->delimiter(',')
      ->type_name("NAME=VALUE");
  command->add_option("--photons", options.photons, "Monte Carlo: photons per direction, default 100000");
  command->add_option("--seed", options.seed, "Monte Carlo: seed, default 1");
  command->add_option("--orders", options.orders, "Highest order of scattering; 0, the default: all")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--threads", arguments->threads, "Threads; 0, the default: all cores")
      ->check(CLI::NonNegativeNumber);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace skylut::cli
