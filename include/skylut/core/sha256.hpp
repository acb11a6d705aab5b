#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace skylut {

/// SHA-256 of bytes (FIPS 180-4, doi:10.6028/NIST.FIPS.180-4) as 64 hexadecimal digits: by it a file is known
/// again.
std::string sha256_hex(std::string_view bytes);

/// The same of a file's content. @throws WorkError  if it cannot be read
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace skylut
