#include "program_context.hpp"

#include <cstdlib>
#include <memory>

#include "options/number_kinds.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/report/progress.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

Kind<Simd> instruction_set() {
  return choice<Simd>(
      {{"best", Simd::best}, {"portable", Simd::portable}, {"avx2", Simd::avx2}, {"avx512", Simd::avx512}});
}

fs::path data_folder() {
  if (const char* chosen = std::getenv("SKYLUT_PROFILES")) {
    if (!fs::is_directory(chosen)) throw WorkError("SKYLUT_PROFILES={}: no such folder", chosen);
    return chosen;
  }
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  fs::path installed = program.parent_path().parent_path() / "share/skylut/profiles";
  if (!program.empty() && fs::is_directory(installed, ignored)) return installed;
  return Context::default_data_folder();
}

// As the XDG base directory specification says; a relative path is to be ignored.
fs::path cache_folder() {
  if (const char* chosen = std::getenv("XDG_CACHE_HOME"); chosen != nullptr && *chosen == '/')
    return fs::path(chosen) / "skylut";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
    return fs::path(home) / ".cache/skylut";
  return {};
}

Simd simd_of_environment() {
  const char* wanted = std::getenv("SKYLUT_SIMD");
  if (wanted == nullptr) return Simd::best;
  if (std::string_view(wanted) == "sse2") return Simd::portable;  // its name before there were others
  try {
    return instruction_set().read(wanted);
  } catch (const InputError& error) {
    throw InputError("SKYLUT_SIMD={}: {}", wanted, error.what());
  }
}

}  // namespace

void ComputingOptions::add_to(OptionSet& options) {
  options.group("Computing");
  options.add("--threads", threads, whole_number(domain::kThreads), "0: one per core; changes no result")
      .recorded = false;
  options.add("--simd", simd, instruction_set(),
              "instruction set of the solver: best of this machine, portable, avx2 or avx512");
  options.add_flag("--no-cache", no_cache, "compute Mie's theory anew, keep nothing in the cache").recorded =
      false;
}

Context program_context(const ComputingOptions& options) {
  Context context;
  context.data_folder = data_folder();
  if (!options.no_cache) context.cache_folder = cache_folder();
  context.simd = options.simd ? *options.simd : simd_of_environment();
  context.threads = static_cast<int>(options.threads);
  const auto progress = std::make_shared<Progress>();
  context.progress = [progress](std::string_view stage, std::size_t done, std::size_t all) {
    progress->show(stage, done, all);
  };
  return context;
}

}  // namespace skylut::cli
