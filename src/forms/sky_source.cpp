#include "skylut/forms/sky_source.hpp"

#include <filesystem>

#include "skylut/models/model_file.hpp"
#include "skylut/models/registry.hpp"
#include "skylut/table/table_model.hpp"

namespace skylut {

std::unique_ptr<const SkyModel> open_sky_source(const std::string& source) {
  const std::filesystem::path path(source);
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return make_sky_model(source);
  if (std::filesystem::is_directory(path, ignored) || !is_model_file(path))
    return std::make_unique<const TableModel>(Table::read(path));
  return read_model_file(path);
}

}  // namespace skylut
