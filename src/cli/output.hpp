#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "options/options.hpp"

/// What leaves the program beside its results' own files.
namespace skylut::cli {

/// A file that an option names indirectly: sky_px.exr of sky.exr.
/// @throws InputError  "OPTION FILE: …" if it could not be written
void require_writable(const std::string& option, const std::filesystem::path& file);

/// --output, -o: a file that is not recorded in what is written to it.
template <class Path>
Option& add_output(OptionSet& options, Path& path, const Kind<std::filesystem::path>& kind,
                   const char* help) {
  Option& out = options.add("--output", path, kind, help);
  out.short_name = "-o";
  out.recorded = false;
  return out;
}

/// Writes a result where file_out() said, "-" being standard output. @throws WorkError naming the file
void write_result(const std::filesystem::path& file, std::string_view text);

/// Whether the file is the screen or pipe to which summaries would go, too.
bool is_standard_output(const std::filesystem::path& file);

/// "skylut: warning: …", one line on standard error; the exit code stays 0.
void warn(const std::string& message);

template <class... Args>
void warn(fmt::format_string<Args...> format, Args&&... args) {
  warn(fmt::format(format, std::forward<Args>(args)...));
}

/// The same text without line breaks: an error is one line whatever its source.
std::string in_one_line(std::string text);

}  // namespace skylut::cli
