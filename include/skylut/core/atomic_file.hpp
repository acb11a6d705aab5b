#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace skylut {

/// A file written piece by piece that appears under its name only when it is complete and on the disk: the
/// bytes go to a temporary file beside it (`<name>.skylut-<16 hex digits>.tmp`, new, never through a link),
/// which takes the name in publish() and is removed when anything fails. A file that is replaced hands on its
/// permissions, a new one has those of the umask; a symbolic link of that name is replaced, its target
/// untouched. Temporary files of the same name that a killed run has left are cleared. What cannot be
/// replaced (a pipe, a device, an open descriptor such as /dev/stdout) is written to by publish(), from an
/// unnamed file in the system's folder for temporary files.
class AtomicFile {
 public:
  /// @throws WorkError  naming the file: no such folder, no permission, a directory in the way
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Writes all of it at the position, which moves on behind it. A failure is remembered: publish() refuses a
  /// file of which a piece is missing, even if the exception was swallowed on its way (OpenEXR's destructors
  /// do that).
  /// @throws WorkError  naming the file (disk full)
  void write(std::string_view bytes);

  /// Bytes from the beginning.
  std::uint64_t position() const { return position_; }
  /// The next write goes there; beyond the end leaves zeros between.
  void seek(std::uint64_t position) { position_ = position; }

  /// Files that belong together: none takes its name before all are complete and on the disk, so that a disk
  /// that is full leaves what was there before.
  /// @throws WorkError  naming the file that failed
  static void publish(std::span<AtomicFile* const> files);

  class Place;  ///< where the bytes go until then

 private:
  std::filesystem::path path_;
  std::unique_ptr<Place> place_;
  std::uint64_t position_ = 0;
  bool broken_ = false;
};

/// Writes a small file as an AtomicFile. @throws WorkError  as AtomicFile
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

struct FileText {
  std::filesystem::path path;
  std::string_view text;
};

/// Files that belong together, as AtomicFile::publish().
/// @throws WorkError  naming the file that could not be written
void write_texts_atomically(std::span<const FileText> files);

/// Removes the temporary files of writes under way; safe to call from a signal handler that ends the program.
void remove_unfinished_files() noexcept;

}  // namespace skylut
