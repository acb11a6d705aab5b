#include "skylut/core/context.hpp"

#include "skylut/core/errors.hpp"

namespace skylut {

namespace fs = std::filesystem;

fs::path Context::default_data_folder() {
  for (const char* folder : {SKYLUT_INSTALLED_PROFILES, SKYLUT_SOURCE_PROFILES}) {
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) return folder;
  }
  return {};
}

fs::path Context::data_file(const std::string& relative_path) const {
  if (data_folder.empty() || !fs::is_directory(data_folder))
    throw WorkError("data folder '{}': is missing: install skylut's profiles, or name their folder",
                    data_folder.string());
  fs::path path = data_folder / relative_path;
  if (!fs::is_regular_file(path)) throw WorkError("{}: data file is missing", path.string());
  return path;
}

}  // namespace skylut
