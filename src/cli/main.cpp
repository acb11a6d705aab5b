#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "commands.hpp"
#include "signals.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/version.hpp"

namespace {

constexpr int kDone = 0;
constexpr int kWorkFailed = 1;
constexpr int kRequestWrong = 2;

constexpr const char* kExamples = R"(
Examples:
  skylut table --out out/table                      the 75-entry table: table.csv, table.json
  skylut table --out out/high --altitudes-km 10,15 --turbidities 0.05 --suns 30:180,60:180
  skylut map -o sky.exr --sun-zenith-deg 60         one sky as a picture: sky_rgb.exr
  skylut map -o sky.csv --latitude 48:51N --longitude 2:21E --time 2024-06-21T09:00Z

Exit codes: 0 done, 1 the work failed, 2 the request was wrong.
Help on one command: skylut COMMAND --help)";

// An error is one line whatever its source.
std::string in_one_line(std::string text) {
  for (char& character : text)
    if (character == '\n' || character == '\r') character = ' ';
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

int fail(int exit_code, const std::string& message) {
  std::fprintf(stderr, "skylut: %s\n", in_one_line(message).c_str());
  return exit_code;
}

// Output to a full disk or a closed pipe is a failure even when it is only the screen's text.
int finish() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    return fail(kWorkFailed, "standard output: cannot write");
  return kDone;
}

std::string help_of(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? "skylut --help" : "skylut " + chosen.front()->get_name() + " --help";
}

// CLI11 would only say that a command is missing.
void require_known_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == argv[1]) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw skylut::InputError("command '{}': must be one of {}", argv[1], names);
}

int run(int argc, char** argv) {
  CLI::App app{"skylut turns an atmosphere into a fitted sky model.", "skylut"};
  app.set_version_flag("--version", std::string("skylut ") + skylut::kVersion);
  app.require_subcommand(1);
  app.footer(kExamples);
  skylut::cli::add_table_command(app);
  skylut::cli::add_map_command(app);
  skylut::cli::add_fit_command(app);
  skylut::cli::add_compare_command(app);
  skylut::cli::add_profile_command(app);
  skylut::cli::add_aerosol_command(app);
  skylut::cli::add_solve_command(app);
  skylut::cli::add_sun_command(app);
  require_known_command(app, argc, argv);
  try {
    app.parse(argc, argv);
    return finish();
  } catch (const CLI::Success& help_or_version) {
    app.exit(help_or_version);
    return finish();
  } catch (const CLI::ParseError& error) {
    return fail(kRequestWrong, std::string(error.what()) + " (see " + help_of(app) + ")");
  }
}

}  // namespace

int main(int argc, char** argv) {
  skylut::cli::end_cleanly_on_signals();
  try {
    return run(argc, argv);
  } catch (const skylut::InputError& error) {
    return fail(kRequestWrong, error.what());
  } catch (const std::exception& error) {
    return fail(kWorkFailed, error.what());
  }
}
