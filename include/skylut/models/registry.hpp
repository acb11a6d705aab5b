#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skylut/models/sky_model.hpp"

namespace skylut {

/// Names of the published sky models that skylut computes.
std::vector<std::string> sky_model_names();

/// @throws InputError  naming the text and the models there are
std::unique_ptr<const SkyModel> make_sky_model(const std::string& name);

}  // namespace skylut
