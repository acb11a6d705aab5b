#include "core/unfinished_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <random>

#include "skylut/core/atomic_file.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMark = ".skylut-";
constexpr std::string_view kEnding = ".tmp";
constexpr std::size_t kDigits = 16;
constexpr std::size_t kLongestName = 255;  // NAME_MAX of Linux's file systems

// The one thing that the library keeps for the whole process: the names of temporary files under way, in
// fixed storage, because a signal handler may read nothing else. When all entries are taken a file is merely
// not removed by a signal.
struct ListEntry {
  std::atomic<bool> taken{false};
  std::atomic<bool> named{false};
  std::array<char, 4096> name{};
};
std::array<ListEntry, 32> unfinished_files;  // six faces of a cube in four kinds of channels

int enter_in_list(const std::string& name) {
  for (std::size_t i = 0; i < unfinished_files.size(); ++i) {
    ListEntry& entry = unfinished_files[i];
    if (name.size() >= entry.name.size() || entry.taken.exchange(true)) continue;
    std::memcpy(entry.name.data(), name.c_str(), name.size() + 1);
    entry.named = true;
    return static_cast<int>(i);
  }
  return -1;
}

void strike_from_list(int index) {
  if (index < 0) return;
  ListEntry& entry = unfinished_files[static_cast<std::size_t>(index)];
  entry.named = false;
  entry.taken = false;
}

[[noreturn]] void fail(const fs::path& path, int error) {
  throw WorkError("{}: cannot write: {}", path.string(), std::strerror(error));
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// What the names of a file's temporary files begin with; a long name is cut so that the whole fits.
std::string beginning_of_name(const fs::path& final_path) {
  const std::size_t room = kLongestName - kMark.size() - kDigits - kEnding.size();
  return final_path.filename().string().substr(0, room).append(kMark);
}

bool is_temporary_name(std::string_view name, std::string_view beginning) {
  if (name.size() != beginning.size() + kDigits + kEnding.size()) return false;
  const std::string_view digits = name.substr(beginning.size(), kDigits);
  return name.starts_with(beginning) && name.ends_with(kEnding) &&
         digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

// Whoever writes a temporary file holds its lock: who can take the lock has found a leftover.
void clear_if_left_over(const fs::path& path) noexcept {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat status {};
  const bool ours =
      ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
  if (ours && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
  ::close(descriptor);
}

}  // namespace

UnfinishedFile::UnfinishedFile(fs::path path, const fs::path& final_path)
    : path_(std::move(path)), final_path_(final_path), list_entry_(enter_in_list(path_.native())) {
  struct stat created {};
  do {
    if (descriptor_ >= 0) ::close(descriptor_);
    // O_NOFOLLOW says again what O_EXCL implies on every system but old network file systems.
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      const int error = errno;
      strike_from_list(list_entry_);
      fail(final_path_, error);
    }
    // Without locks (some network file systems) leftovers cannot be told apart and are not cleared either.
    ::flock(descriptor_, LOCK_EX);
    // Another run that clears leftovers may have come between the two calls: then once more.
  } while (::fstat(descriptor_, &created) == 0 && created.st_nlink == 0);
  struct stat replaced {};
  if (::stat(final_path_.c_str(), &replaced) == 0 && ::fchmod(descriptor_, replaced.st_mode & 0777) != 0) {
    // A file system without permissions: those of the new file stay.
    errno = 0;
  }
}

UnfinishedFile::~UnfinishedFile() {
  if (!renamed_) ::unlink(path_.c_str());
  ::close(descriptor_);
  strike_from_list(list_entry_);
}

void UnfinishedFile::flush() {
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(final_path_, errno);
}

void UnfinishedFile::rename_to_final() {
  if (::rename(path_.c_str(), final_path_.c_str()) != 0) fail(final_path_, errno);
  renamed_ = true;
  // The new name reaches the disk with its folder; a file system that cannot flush one has the file all the
  // same.
  const int folder = ::open(folder_of(final_path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

fs::path temporary_path(const fs::path& final_path) {
  std::random_device random;
  const auto digits = (static_cast<std::uint64_t>(random()) << 32) | random();
  return folder_of(final_path) / fmt::format("{}{:016x}{}", beginning_of_name(final_path), digits, kEnding);
}

void clear_leftovers(const fs::path& final_path) noexcept {
  try {
    const std::string beginning = beginning_of_name(final_path);
    std::error_code error;
    for (fs::directory_iterator at(folder_of(final_path), error), end; !error && at != end;
         at.increment(error))
      if (is_temporary_name(at->path().filename().native(), beginning)) clear_if_left_over(at->path());
  } catch (const std::exception&) {
    // Out of memory for a name: what is left over stays for the next run.
    return;
  }
}

void write_all(int descriptor, std::string_view text, const fs::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void write_all_at(int descriptor, std::string_view text, std::uint64_t position, const fs::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::pwrite(descriptor, text.data(), text.size(), static_cast<off_t>(position));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
    position += static_cast<std::uint64_t>(written);
  }
}

void remove_unfinished_files() noexcept {
  for (const ListEntry& entry : unfinished_files)
    if (entry.named) ::unlink(entry.name.data());
}

}  // namespace skylut
