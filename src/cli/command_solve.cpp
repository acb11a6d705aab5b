#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include "commands.hpp"
#include "json_reader.hpp"
#include "skylut/core/atomic_file.hpp"
#include "solve_case.hpp"

namespace skylut::cli {
namespace {

struct SolveArguments {
  std::string input;
  std::string output;
  SolveOptions options;
};

void run(const SolveArguments& arguments) {
  const nlohmann::ordered_json answer =
      solve_case(read_json_file(arguments.input), arguments.input, arguments.options);
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
  command->add_option("--quality", options.quality, "draft, default or reference (spherical solver)")
      ->transform(CLI::CheckedTransformer(qualities));
  command->add_option("--photons", options.photons, "Monte Carlo: photons per direction, default 100000");
  command->add_option("--seed", options.seed, "Monte Carlo: seed, default 1");
  command->add_option("--orders", options.orders, "Highest order of scattering; 0, the default: all")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--threads", options.threads, "Threads; 0, the default: all cores")
      ->check(CLI::NonNegativeNumber);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace skylut::cli
