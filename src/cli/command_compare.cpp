#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "options/file_kinds.hpp"
#include "output.hpp"
#include "scene_options.hpp"
#include "skylut/compare/compare_report.hpp"
#include "skylut/table/table_csv.hpp"
#include "skylut/table/table_turbidity.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

enum class Published { preetham1999, utm2005 };

struct CompareOptions {
  fs::path table;
  fs::path out;
  std::optional<Published> against;
  std::optional<TurbidityKind> kind;
  bool json = false;
};

void run(const CompareOptions& options) {
  const fs::path csv = fs::is_directory(options.table) ? options.table / "table.csv" : options.table;
  const std::vector<TableEntry> entries = read_table_csv(csv);
  std::optional<std::string> kind;
  if (options.kind) kind = turbidity_kind_name(*options.kind);
  const CompareReport report =
      options.against == Published::utm2005
          ? compare_with_utm2005(program_context(), entries)
          : compare_with_preetham1999(entries, TableTurbidity(csv.parent_path() / "table.json", kind));
  if (!options.out.empty()) write_result(options.out, report.csv());
  if (options.json)
    fmt::print("{}", report.json());
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
  set.add("--against", options->against,
          choice<Published>({{"preetham1999", Published::preetham1999}, {"utm2005", Published::utm2005}}),
          "preetham1999 or utm2005")
      .required = true;
  set.add("--turbidity-kind", options->kind, turbidity_kind_by_name(),
          "of the table, if it has no table.json: aod500, aod550, angstrom-beta or preetham-t");
  set.add_flag("--json", options->json, "print the comparison as JSON");
  set.add("--output", options->out, file_out(), "CSV file for the comparison").short_name = "-o";
  command.run = [options](const OptionSet&) { run(*options); };
  return command;
}

}  // namespace skylut::cli
