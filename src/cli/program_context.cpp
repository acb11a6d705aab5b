#include "program_context.hpp"

#include <cstdlib>

#include "skylut/core/errors.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

fs::path data_folder() {
  if (const char* chosen = std::getenv("SKYLUT_PROFILES")) {
    if (!fs::is_directory(chosen)) throw WorkError("SKYLUT_PROFILES={}: no such folder", chosen);
    return chosen;
  }
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path().parent_path() / "share/skylut/profiles";
  if (!program.empty() && fs::is_directory(installed, ignored)) return installed;
  return Context::default_data_folder();
}

fs::path cache_folder() {
  if (const char* chosen = std::getenv("XDG_CACHE_HOME"); chosen != nullptr && *chosen == '/')
    return fs::path(chosen) / "skylut";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
    return fs::path(home) / ".cache/skylut";
  return {};
}

}  // namespace

Context program_context() {
  Context context;
  context.data_folder = data_folder();
  context.cache_folder = cache_folder();
  return context;
}

}  // namespace skylut::cli
