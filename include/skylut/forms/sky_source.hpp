#pragma once

#include <memory>
#include <string>

#include "skylut/models/sky_model.hpp"

namespace skylut {

/// Whatever gives skies for conditions: the folder or table.csv of a table, a model file of skylut fit, or a
/// published model by its name.
/// @throws InputError  as Table::read and read_model_file; for a text that is none of the three
std::unique_ptr<const SkyModel> open_sky_source(const std::string& source);

}  // namespace skylut
