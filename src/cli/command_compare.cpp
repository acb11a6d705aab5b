#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "program_context.hpp"
#include "skylut/compare/comparisons.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/errors.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

struct CompareOptions {
  fs::path table;
  fs::path out;
  std::string against;
  std::optional<std::string> kind;
  bool json = false;
};

void run(const CompareOptions& options) {
  std::optional<TurbidityKind> kind;
  if (options.kind) kind = parse_turbidity_kind(*options.kind);
  const CompareReport report =
      compare_table(program_context(), Table::read(options.table, kind), options.against);
  if (!options.out.empty()) write_text_atomically(options.out, report.csv());
  if (options.json) {
    fmt::print("{}", report.json());
    return;
  }
  fmt::print("{}", report.text());
  if (!options.out.empty()) fmt::print("\nwrote {}\n", options.out.string());
}

}  // namespace

void add_compare_command(CLI::App& program) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& command = *program.add_subcommand("compare", "set a table beside published coefficients");
  command.footer(
      "\npreetham1999: every row at 0 km; coefficients, zenith, and the difference over 271 directions.\n"
      "utm2005: the legible published rows, with what makes them impossible.\n"
      "Example:\n  skylut compare out/table --against preetham1999 -o preetham.csv");
  command.add_option("TABLE", options->table, "folder of a table, or its table.csv")->required();
  command.add_option("--against", options->against, fmt::format("{}", fmt::join(comparison_names(), " or ")))
      ->required()
      ->check(CLI::IsMember(comparison_names()));
  command.add_option("--turbidity-kind", options->kind, "of the table, if it has no table.json")
      ->type_name("KIND");
  command.add_flag("--json", options->json, "print the comparison as JSON");
  command.add_option("-o,--output", options->out, "CSV file for the comparison")->type_name("FILE");
  command.callback([options] { run(*options); });
}

}  // namespace skylut::cli
