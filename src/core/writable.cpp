#include "skylut/core/writable.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace fs = std::filesystem;

namespace {

void require_access(const fs::path& path, int mode) {
  if (::access(path.c_str(), mode) != 0)
    throw InputError("cannot write {}: {}", path.string(), std::strerror(errno));
}

}  // namespace

void require_writable_file(const fs::path& file) {
  std::error_code ignored;
  if (!file.has_filename() || fs::is_directory(file, ignored))
    throw InputError("is a directory, must be the name of a file");
  if (fs::exists(file, ignored)) require_access(file, W_OK);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) throw InputError("no such folder: {}", folder.string());
  if (!fs::exists(file, ignored) || fs::is_regular_file(file, ignored)) require_access(folder, W_OK | X_OK);
}

void require_writable_folder(const fs::path& folder) {
  std::error_code error;
  fs::path nearest = fs::absolute(folder).lexically_normal();
  while (!fs::exists(nearest, error)) {
    if (error && error != std::errc::not_a_directory) throw InputError("cannot write: {}", error.message());
    nearest = nearest.parent_path();
  }
  if (!fs::is_directory(nearest, error)) throw InputError("a file is in the way: {}", nearest.string());
  require_access(nearest, W_OK | X_OK);
}

void create_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw WorkError("{}: cannot create the folder: {}", folder.string(), error.message());
}

}  // namespace skylut
