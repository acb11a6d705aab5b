#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace skylut {

/// Writes a file so that it appears under its final name only when it is complete: `write` gets a
/// temporary path in the same folder, which is renamed when it returns and removed when it throws
/// or when the program is interrupted. A pipe or a device (/dev/stdout) is written to directly.
/// @throws WorkError  naming the file if it cannot be written or renamed (no such folder, no
///                    permission, disk full, a directory in the way)
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for a text that is already in memory.
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

/// Removes the temporary files of writes under way; safe to call from a signal handler.
void remove_unfinished_files() noexcept;

}  // namespace skylut
