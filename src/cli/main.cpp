#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "commands.hpp"
#include "output.hpp"
#include "signals.hpp"
#include "skylut/core/errors.hpp"

namespace {

constexpr int kDone = 0;
constexpr int kWorkFailed = 1;
constexpr int kRequestWrong = 2;

int fail(int exit_code, const std::string& message) {
  std::fprintf(stderr, "skylut: %s\n", skylut::cli::in_one_line(message).c_str());
  return exit_code;
}

// Output to a full disk or a closed pipe is a failure even when it is only the screen's text.
int finish() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    return fail(kWorkFailed, "standard output: cannot write");
  return kDone;
}

skylut::cli::Command program() {
  using namespace skylut::cli;
  Command program;
  program.name = "skylut";
  program.summary = "skylut turns an atmosphere into a fitted sky model.";
  program.notes =
      "Exit codes: 0 done, 1 the work failed, 2 the request was wrong.\n"
      "Help on one command: skylut COMMAND --help";
  program.examples = {
      "skylut table --out out/table",
      "skylut table --out out/high --altitudes-km 10,15 --turbidities 0.05 --suns 30:180,60:180",
      "skylut map -o sky.exr --sun-zenith-deg 60",
      "skylut map -o sky.csv --latitude 48:51N --longitude 2:21E --time 2024-06-21T09:00Z"};
  program.subcommands = {table_command(),   map_command(),     fit_command(),
                         eval_command(),    compare_command(), profile_command(),
                         aerosol_command(), solve_command(),   sun_command()};
  return program;
}

std::string as_typed(int argc, char** argv) {
  std::string line = "skylut";
  for (int i = 1; i < argc; ++i) line += " " + skylut::cli::shell_quoted(argv[i]);
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  skylut::cli::end_cleanly_on_signals();
  try {
    skylut::cli::Command skylut = program();
    skylut::cli::run_command_line(skylut, argc, argv);
    return finish();
  } catch (const skylut::InputError& error) {
    return fail(kRequestWrong, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kWorkFailed, as_typed(argc, argv) + ": not enough memory, ask for less at a time");
  } catch (const std::exception& error) {
    return fail(kWorkFailed, error.what());
  }
}
