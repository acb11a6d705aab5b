#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace skylut {

struct Context;

/// Reads a table of profiles/spectra: lines of comment (#), one line of column names, then numbers
/// separated by commas, the wavelength first and ascending.
/// @param relative_path  below the profile folder
/// @return rows of `columns` numbers
/// @throws WorkError  naming file and line if the table is missing or damaged
std::vector<std::vector<double>> read_spectral_table(const Context& context, const std::string& relative_path,
                                                     std::size_t columns);

}  // namespace skylut
