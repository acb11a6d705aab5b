#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skylut {

/// A comma-separated file: a header line that names the columns, then one line per row. Empty lines and lines
/// that begin with # are passed over, the latter kept as comments; spaces around a field, a byte order mark
/// and CR LF line ends do not matter. Numbers are read the same way in every locale.
class CsvTable {
 public:
  /// @throws InputError  no such file, not readable, no header, a column named twice, or a row of another
  ///                     number of fields than the header; "file:line: …"
  static CsvTable read(const std::filesystem::path& path);

  /// Index of the column of that name. @throws InputError naming the file, the columns there are and the one
  /// wanted
  std::size_t column(std::string_view name) const;
  std::optional<std::size_t> find_column(std::string_view name) const;

  std::size_t rows() const { return rows_.size(); }
  const std::vector<std::string>& columns() const { return columns_; }

  const std::string& text(std::size_t row, std::size_t column) const { return rows_[row].fields[column]; }
  /// @throws InputError  "file:line: column 'Y': 'abc': must be a finite number"
  double number(std::size_t row, std::size_t column) const;

  /// Value of a comment "# name=value"; absent if there is none.
  std::optional<std::string> comment(std::string_view name) const;
  /// The same as a number. @throws InputError if it is not one
  std::optional<double> comment_number(std::string_view name) const;

  /// "file:line" of a row, for messages.
  std::string place(std::size_t row) const;
  std::size_t line(std::size_t row) const { return rows_[row].line; }
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Row {
    std::size_t line = 0;
    std::vector<std::string> fields;
  };
  struct Comment {
    std::size_t line = 0;
    std::string name;
    std::string value;
  };
  std::filesystem::path path_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
  std::vector<Comment> comments_;
};

}  // namespace skylut
