#pragma once

#include <string>

#include "skylut/models/model_file.hpp"

namespace skylut {

/// What was fitted: its domain, its measured error, and what the form has to say of its numbers.
std::string form_text(const ModelFile& file);

}  // namespace skylut
