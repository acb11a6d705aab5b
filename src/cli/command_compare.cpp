#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "commands.hpp"
#include "options/file_kinds.hpp"
#include "output.hpp"
#include "program_context.hpp"
#include "scene_options.hpp"
#include "skylut/compare/comparisons.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

struct CompareOptions {
  fs::path table;
  fs::path out;
  std::string against;
  std::optional<TurbidityKind> kind;
  bool json = false;
};

// The files that make a table.
std::vector<fs::path> files_of_table(const fs::path& table) {
  if (!fs::is_directory(table)) return {table};
  return {table / "table.csv", table / "table.json"};
}

void run(const CompareOptions& options, const std::string& command_line) {
  const Context context = program_context();
  const CompareReport report =
      compare_table(context, Table::read(options.table, options.kind), options.against);
  Provenance provenance(command_line);
  for (const fs::path& file : files_of_table(options.table))
    if (fs::exists(file)) provenance.add_source(context, file);
  if (!options.out.empty()) write_result(options.out, report.csv(provenance));
  if (options.json)
    fmt::print("{}", report.json(provenance));
  else if (!is_standard_output(options.out))
    fmt::print("{}", report.text());
  if (!options.out.empty() && !options.json && !is_standard_output(options.out))
    fmt::print("\nwrote {}\n", options.out.string());
}

}  // namespace

Command compare_command() {
  const auto options = std::make_shared<CompareOptions>();
  Command command;
  command.name = "compare";
  command.summary = "set a table beside published coefficients";
  command.notes =
      "preetham1999: every row at 0 km; coefficients, zenith, and the difference over 271 directions.\n"
      "utm2005: the legible published rows, with what makes them impossible.";
  command.examples = {"skylut table --out out/table",
                      "skylut compare out/table --against preetham1999 -o preetham.csv"};
  OptionSet& set = command.options;
  set.add("TABLE", options->table, file_in("DIR|FILE"), "folder of a table, or its table.csv").required =
      true;
  Option& against = set.add("--against", options->against, choice(comparison_names()),
                            fmt::format("{}", fmt::join(comparison_names(), " or ")));
  against.required = true;
  against.default_text.clear();
  set.add("--turbidity-kind", options->kind, turbidity_kind_by_name(),
          "of the table, if it has no table.json");
  set.add_flag("--json", options->json, "print the comparison as JSON");
  add_output(set, options->out, file_out(), "CSV file for the comparison");
  command.run = [options](const OptionSet& given) { run(*options, given.command_line("skylut compare")); };
  return command;
}

}  // namespace skylut::cli
