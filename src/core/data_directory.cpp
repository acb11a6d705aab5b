#include "skylut/core/data_directory.hpp"

#include <cstdlib>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace fs = std::filesystem;

fs::path profile_directory() {
  if (const char* chosen = std::getenv("SKYLUT_PROFILES")) {
    if (!fs::is_directory(chosen)) throw WorkError("SKYLUT_PROFILES={}: no such folder", chosen);
    return chosen;
  }
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path().parent_path() / "share/skylut/profiles";
  if (!program.empty() && fs::is_directory(installed)) return installed;
  if (fs::is_directory(SKYLUT_SOURCE_PROFILES)) return SKYLUT_SOURCE_PROFILES;
  throw WorkError("no profiles found beside {}: set SKYLUT_PROFILES to their folder", program.string());
}

fs::path data_file(const std::string& relative_path) {
  const fs::path path = profile_directory() / relative_path;
  if (!fs::is_regular_file(path)) throw WorkError("{}: data file is missing", path.string());
  return path;
}

}  // namespace skylut
