#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kind.hpp"

/// Names and files on the command line.
namespace skylut::cli {

/// Something by its name, or a file of one's own; the library says which names there are.
Kind<std::string> name_or_file();

/// A file or folder that is read.
Kind<std::filesystem::path> file_in(const std::string& placeholder = "FILE");

/// A file that is written: refused at once where it could not be. "-" is standard output.
Kind<std::filesystem::path> file_out();

/// The name of a file that is written; its ending, in whatever case, must be one of those given.
Kind<std::filesystem::path> file_named(const std::vector<std::string>& endings);

/// A folder that is written, created if need be.
Kind<std::filesystem::path> folder_out();

/// ".csv" of "Sky.CSV".
std::string ending_of(const std::filesystem::path& file);

}  // namespace skylut::cli
