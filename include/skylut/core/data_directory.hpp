#pragma once

#include <filesystem>
#include <string>

namespace skylut {

/// Folder with the profiles and data tables that come with skylut. The first that exists of:
/// the environment variable SKYLUT_PROFILES; ../share/skylut/profiles beside the program
/// (an installed copy, wherever it was moved); the source tree that the program was built from.
/// @throws WorkError  if there is none
std::filesystem::path profile_directory();

/// Path of one file below profile_directory(). @throws WorkError if it does not exist.
std::filesystem::path data_file(const std::string& relative_path);

}  // namespace skylut
