#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace skylut {

/// The whole of a user's file, a pipe included. @param expected  for messages: "a file in TOML"
/// @throws InputError  if it cannot be read, or holds more than domain::kLargestInput_bytes
std::string read_input_file(const std::filesystem::path& path, const char* expected);

/// The next line of a file, without its end; false where there is none.
/// @throws InputError  for a line longer than domain::kLongestLine_bytes
bool read_input_line(std::istream& file, std::string& line, const std::filesystem::path& path,
                     std::size_t number);

}  // namespace skylut
