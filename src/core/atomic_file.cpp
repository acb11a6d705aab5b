#include "skylut/core/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <string>
#include <vector>

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

struct Closed {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

// Where the bytes go until the file is published.
class AtomicFile::Place {
 public:
  virtual ~Place() = default;
  virtual int descriptor() const = 0;
  virtual void complete() = 0;   ///< all bytes to where nothing can go wrong any more
  virtual void take_name() = 0;  ///< last step
};

namespace {

class Beside final : public AtomicFile::Place {
 public:
  explicit Beside(const fs::path& path) : file_(temporary_path(path), path) {}
  int descriptor() const override { return file_.descriptor(); }
  void complete() override { file_.flush(); }
  void take_name() override { file_.rename_to_final(); }

 private:
  UnfinishedFile file_;
};

// Nothing to replace: a pipe, a device, or a descriptor that is open already.
class Elsewhere final : public AtomicFile::Place {
 public:
  Elsewhere(const fs::path& path, int open_descriptor)
      : path_(path), open_descriptor_(open_descriptor), bytes_(std::tmpfile()) {
    if (!bytes_) fail("cannot make a temporary file");
  }
  int descriptor() const override { return ::fileno(bytes_.get()); }

  void complete() override {
    const int target =
        open_descriptor_ >= 0 ? ::dup(open_descriptor_) : ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (target < 0) fail("cannot write");
    try {
      copy_to(target);
    } catch (...) {
      ::close(target);
      throw;
    }
    if (::close(target) != 0) fail("cannot write");
  }
  void take_name() override {}

 private:
  void copy_to(int target) {
    std::vector<char> piece(1 << 16);
    for (off_t position = 0;;) {
      const ssize_t count = ::pread(descriptor(), piece.data(), piece.size(), position);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail("cannot read back a temporary file");
      if (count == 0) return;
      write_all(target, {piece.data(), static_cast<std::size_t>(count)}, path_);
      position += count;
    }
  }
  [[noreturn]] void fail(const char* what) const {
    throw WorkError("{}: {}: {}", path_.string(), what, std::strerror(errno));
  }

  fs::path path_;
  int open_descriptor_;
  std::unique_ptr<std::FILE, Closed> bytes_;
};

std::unique_ptr<AtomicFile::Place> place_for(const fs::path& path) {
  if (const int open_descriptor = descriptor_named(path); open_descriptor >= 0)
    return std::make_unique<Elsewhere>(path, open_descriptor);
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) throw WorkError("{}: cannot write, a directory has that name", path.string());
  if (fs::exists(status) && !fs::is_regular_file(status)) return std::make_unique<Elsewhere>(path, -1);
  clear_leftovers(path);
  return std::make_unique<Beside>(path);
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : path_(path), place_(place_for(path)) {}

AtomicFile::~AtomicFile() = default;

void AtomicFile::write(std::string_view bytes) {
  try {
    write_all_at(place_->descriptor(), bytes, position_, path_);
  } catch (const WorkError&) {
    broken_ = true;
    throw;
  }
  position_ += bytes.size();
}

void AtomicFile::publish(std::span<AtomicFile* const> files) {
  for (const AtomicFile* file : files)
    if (file->broken_)
      throw WorkError("{}: cannot write: a piece of it could not be written", file->path_.string());
  for (AtomicFile* file : files) file->place_->complete();
  for (AtomicFile* file : files) file->place_->take_name();
}

void write_texts_atomically(std::span<const FileText> files) {
  std::deque<AtomicFile> unfinished;
  std::vector<AtomicFile*> together;
  for (const auto& [path, text] : files) {
    unfinished.emplace_back(path).write(text);
    together.push_back(&unfinished.back());
  }
  AtomicFile::publish(together);
}

void write_text_atomically(const fs::path& path, std::string_view text) {
  const FileText file{path, text};
  write_texts_atomically({&file, 1});
}

}  // namespace skylut
