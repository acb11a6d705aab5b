#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace skylut {

/// A temporary file under way: removed at the end of its life unless it was renamed. While it lives it holds
/// a lock (flock), so that another run can tell it from the leftover of a killed one, and stands in the list
/// that remove_unfinished_files() reads.
class UnfinishedFile {
 public:
  /// Creates `path`, which must not exist: a file or link of that name is an error, not overwritten or
  /// followed.
  /// @throws WorkError  "<final_path>: cannot write: ..."
  UnfinishedFile(std::filesystem::path path, const std::filesystem::path& final_path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  int descriptor() const { return descriptor_; }
  /// To the disk. @throws WorkError
  void flush();
  /// Gives the flushed file its final name and flushes the folder. @throws WorkError
  void rename_to_final();

 private:
  std::filesystem::path path_;
  std::filesystem::path final_path_;
  int descriptor_ = -1;
  int list_entry_ = -1;
  bool renamed_ = false;
};

/// `<name>.skylut-<16 hex digits>.tmp` beside the final path; the digits are random.
std::filesystem::path temporary_path(const std::filesystem::path& final_path);

/// Removes temporary files of this final path that no process is writing any more. Links and files of other
/// users stay.
void clear_leftovers(const std::filesystem::path& final_path) noexcept;

/// Writes all of it at that many bytes from the beginning, wherever the descriptor stands.
/// @throws WorkError  "<path>: cannot write: ..."
void write_all_at(int descriptor, std::string_view text, std::uint64_t position,
                  const std::filesystem::path& path);

/// Writes all of it where the descriptor stands. @throws WorkError  "<path>: cannot write: ..."
void write_all(int descriptor, std::string_view text, const std::filesystem::path& path);

}  // namespace skylut
