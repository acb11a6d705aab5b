#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "options/file_kinds.hpp"
#include "options/number_kinds.hpp"
#include "output.hpp"
#include "program_context.hpp"
#include "scene_options.hpp"
#include "skylut/cases/solve_case.hpp"
#include "skylut/core/json_reader.hpp"
#include "skylut/core/provenance.hpp"
#include "skylut/report/case_report.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

struct SolveArguments {
  std::filesystem::path input;
  std::optional<std::filesystem::path> out;
  SolveMethod method = SolveMethod::standard;
  Quality quality = Quality::standard;
  NamedNumbers limits;
  std::int64_t photons = 100'000;
  std::int64_t seed = 1;
  std::int64_t orders = 0;
  ComputingOptions computing;
};

SolveOptions solve_options(const SolveArguments& arguments) {
  SolveOptions options;
  options.method = arguments.method;
  options.discretisation = discretisation_of(arguments.quality);
  for (const auto& [name, value] : arguments.limits) set_discretisation(options.discretisation, name, value);
  options.orders = static_cast<int>(arguments.orders);
  options.photons = static_cast<std::uint64_t>(arguments.photons);
  options.seed = static_cast<std::uint64_t>(arguments.seed);
  return options;
}

void run(const SolveArguments& arguments, const std::string& command_line) {
  const SolveOptions options = solve_options(arguments);
  const Context context = program_context(arguments.computing);
  nlohmann::ordered_json answer =
      solve_case(context, read_json_file(arguments.input), arguments.input, options);
  Provenance provenance(command_line);
  if (fs::is_regular_file(arguments.input)) provenance.add_source(context, arguments.input);
  if (answer.contains("instruction_set")) provenance.set_instruction_set(answer["instruction_set"]);
  answer["provenance"] = provenance.json();
  if (arguments.out) write_result(*arguments.out, answer.dump(1) + "\n");
  if (arguments.out && is_standard_output(*arguments.out)) return;
  fmt::print("{}", solved_case_text(answer));
  if (arguments.out)
    fmt::print("wrote {}\n", arguments.out->string());
  else
    fmt::print("-o FILE writes the whole answer as JSON\n");
}

}  // namespace

Command solve_command() {
  const auto arguments = std::make_shared<SolveArguments>();
  Command command;
  command.name = "solve";
  command.summary = "radiative transfer through explicit layers: a solver case with our radiances";
  command.notes =
      "Radiances go to the screen, the whole case with them to -o FILE as JSON (-o - : to the screen).";
  command.examples = {"skylut profile case ussa1976 --wavelength-nm 550 --sun-zenith-deg 60 -o case.json",
                      "skylut solve case.json -o solved.json",
                      "skylut solve case.json --method monte-carlo --photons 2000 --seed 7"};
  OptionSet& set = command.options;
  set.add("CASE", arguments->input, file_in(), "case file (JSON)").required = true;
  add_output(set, arguments->out, file_out(), "file for the answer as JSON");
  set.add(
      "--method", arguments->method,
      choice<SolveMethod>({{"default", SolveMethod::standard}, {"monte-carlo", SolveMethod::monte_carlo}}),
      "default or monte-carlo (spherical cases)");
  set.add("--quality", arguments->quality, quality_kind(), "draft, default or reference (spherical solver)");
  set.add("--limit", arguments->limits, named_numbers(),
          "refine one number of the quality, for convergence studies: optical-step=0.01 and others")
      .repeatable = true;
  set.add("--photons", arguments->photons, whole_number(domain::kPhotons),
          "Monte Carlo: photons per direction");
  set.add("--seed", arguments->seed, whole_number(domain::kSeed), "Monte Carlo: of its random numbers");
  set.add("--orders", arguments->orders, whole_number(domain::kScatteringOrders),
          "highest order of scattering; 0: all");
  arguments->computing.add_to(set);
  command.run = [arguments](const OptionSet& given) { run(*arguments, given.command_line("skylut solve")); };
  return command;
}

}  // namespace skylut::cli
