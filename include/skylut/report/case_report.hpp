#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace skylut {

/// What a case of explicit layers holds, in a few lines: layers, optical depths by constituent, ground, sun,
/// observer.
/// @param document  as optical_case() makes it
std::string case_text(const nlohmann::ordered_json& document);

/// What the solver answered: the case in a line, then its radiances, some forty lines at most, and fluxes.
/// @param answer  as solve_case() gives it, in either schema
std::string solved_case_text(const nlohmann::ordered_json& answer);

}  // namespace skylut
