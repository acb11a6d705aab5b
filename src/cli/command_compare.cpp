#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "program_context.hpp"
#include "skylut/compare/compare_report.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/table/table_csv.hpp"
#include "skylut/table/table_turbidity.hpp"

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
  const fs::path csv = fs::is_directory(options.table) ? options.table / "table.csv" : options.table;
  const std::vector<TableEntry> entries = read_table_csv(csv);
  const CompareReport report =
      options.against == "utm2005"
          ? compare_with_utm2005(program_context(), entries)
          : compare_with_preetham1999(entries,
                                      TableTurbidity(csv.parent_path() / "table.json", options.kind));
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
  command.add_option("--against", options->against, "preetham1999 or utm2005")
      ->required()
      ->check(CLI::IsMember({"preetham1999", "utm2005"}));
  command
      .add_option("--turbidity-kind", options->kind,
                  "of the table, if it has no table.json: aod500, aod550, angstrom-beta, preetham-t")
      ->type_name("KIND");
  command.add_flag("--json", options->json, "print the comparison as JSON");
  command.add_option("-o,--output", options->out, "CSV file for the comparison")->type_name("FILE");
  command.callback([options] { run(*options); });
}

}  // namespace skylut::cli
