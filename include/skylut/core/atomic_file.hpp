#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace skylut {

/// Writes a file so that it appears under its name only when it is complete and on the disk: the bytes go to
/// a temporary file beside it (`<name>.skylut-<16 hex digits>.tmp`, new, never through a link), which takes
/// the name when it is done and is removed when anything fails. A file that is replaced hands on its
/// permissions, a new one has those of the umask; a symbolic link of that name is replaced, its target
/// untouched. Temporary files of the same name that a killed run has left are cleared. A pipe, a device or an
/// open descriptor (/dev/stdout) is written to directly.
/// @throws WorkError  naming the file if it cannot be written or renamed (no such folder, no permission, disk
///                    full, a directory in the way)
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

struct FileText {
  std::filesystem::path path;
  std::string_view text;
};

/// Files that belong together, as write_text_atomically: none takes its name before all are on the disk, so
/// that a disk that is full leaves what was there before.
/// @throws WorkError  naming the file that could not be written
void write_texts_atomically(std::span<const FileText> files);

/// Removes the temporary files of writes under way; safe to call from a signal handler that ends the program.
void remove_unfinished_files() noexcept;

}  // namespace skylut
