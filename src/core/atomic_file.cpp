#include "skylut/core/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <deque>
#include <string>

#include "core/unfinished_file.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace fs = std::filesystem;

namespace {

// The descriptor that a name like /dev/stdout or /proc/self/fd/3 stands for; -1 for any other name.
int descriptor_named(fs::path path) {
  std::error_code error;
  for (int links = 0; links < 4; ++links) {
    const fs::path folder = path.parent_path();
    const std::string name = path.filename().string();
    if ((folder == "/proc/self/fd" || folder == "/dev/fd") && !name.empty() && name.size() < 6 &&
        name.find_first_not_of("0123456789") == std::string::npos)
      return std::stoi(name);
    const fs::path target = fs::read_symlink(path, error);
    if (error) return -1;
    path = (folder / target).lexically_normal();
  }
  return -1;
}

// Nothing to replace: a pipe, a device, or a descriptor that is open already.
void write_directly(const fs::path& path, int open_descriptor, std::string_view text) {
  const int descriptor =
      open_descriptor >= 0 ? ::dup(open_descriptor) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) throw WorkError("{}: cannot write: {}", path.string(), std::strerror(errno));
  try {
    write_all(descriptor, text, path);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0) throw WorkError("{}: cannot write: {}", path.string(), std::strerror(errno));
}

}  // namespace

void write_texts_atomically(std::span<const FileText> files) {
  std::deque<UnfinishedFile> unfinished;
  for (const auto& [path, text] : files) {
    if (const int open_descriptor = descriptor_named(path); open_descriptor >= 0) {
      write_directly(path, open_descriptor, text);
      continue;
    }
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status))
      throw WorkError("{}: cannot write, a directory has that name", path.string());
    if (fs::exists(status) && !fs::is_regular_file(status)) {
      write_directly(path, -1, text);
      continue;
    }
    clear_leftovers(path);
    unfinished.emplace_back(temporary_path(path), path).write(text);
  }
  for (UnfinishedFile& file : unfinished) file.flush();
  for (UnfinishedFile& file : unfinished) file.rename_to_final();
}

void write_text_atomically(const fs::path& path, std::string_view text) {
  const FileText file{path, text};
  write_texts_atomically({&file, 1});
}

}  // namespace skylut
