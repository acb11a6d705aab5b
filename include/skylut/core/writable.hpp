#pragma once

#include <filesystem>

/// Long computations ask here first whether their result could be written at all.
namespace skylut {

/// @throws InputError  without the file's name, if it cannot be written: a directory has its name, its folder
///                     does not exist or is not writable, the file itself is not writable
void require_writable_file(const std::filesystem::path& file);

/// The same for a folder that is created if need be, with its parents.
/// @throws InputError  if a file is in the way or the nearest existing folder is not writable
void require_writable_folder(const std::filesystem::path& folder);

/// Creates the folder and its parents. @throws WorkError naming it
void create_folder(const std::filesystem::path& folder);

}  // namespace skylut
