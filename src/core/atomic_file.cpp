#include "skylut/core/atomic_file.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace fs = std::filesystem;

namespace {

// Temporary names of the writes under way, in fixed storage: a signal handler may read nothing else.
struct UnfinishedFile {
  std::atomic<bool> taken{false};
  std::atomic<bool> named{false};
  std::array<char, 4096> name{};
};
std::array<UnfinishedFile, 16> unfinished_files;

// Registers a temporary file for as long as it is being written.
class UnfinishedGuard {
 public:
  explicit UnfinishedGuard(const fs::path& path) {
    const std::string& text = path.native();
    for (UnfinishedFile& file : unfinished_files) {
      if (text.size() >= file.name.size() || file.taken.exchange(true)) continue;
      std::memcpy(file.name.data(), text.c_str(), text.size() + 1);
      file.named = true;
      mine_ = &file;
      return;
    }
  }
  ~UnfinishedGuard() {
    if (mine_ == nullptr) return;
    mine_->named = false;
    mine_->taken = false;
  }
  UnfinishedGuard(const UnfinishedGuard&) = delete;
  UnfinishedGuard& operator=(const UnfinishedGuard&) = delete;

 private:
  UnfinishedFile* mine_ = nullptr;
};

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  if (fs::is_directory(path)) throw WorkError("{}: cannot write, a directory has that name", path.string());
  if (fs::exists(path) && !fs::is_regular_file(path))
    return write(path);  // a pipe or a device: nothing to replace
  fs::path temporary = path;
  temporary += fmt::format(".{}.tmp", ::getpid());
  const UnfinishedGuard guard(temporary);
  std::error_code ignored;
  try {
    write(temporary);
  } catch (...) {
    fs::remove(temporary, ignored);
    throw;
  }
  std::error_code error;
  fs::rename(temporary, path, error);
  if (error) {
    fs::remove(temporary, ignored);
    throw WorkError("{}: cannot write: {}", path.string(), error.message());
  }
}

void write_text_atomically(const fs::path& path, std::string_view text) {
  write_atomically(path, [&](const fs::path& temporary) {
    errno = 0;
    std::ofstream file(temporary, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) throw WorkError("{}: cannot write: {}", path.string(), std::strerror(errno));
  });
}

void remove_unfinished_files() noexcept {
  for (const UnfinishedFile& file : unfinished_files)
    if (file.named) ::unlink(file.name.data());
}

}  // namespace skylut
