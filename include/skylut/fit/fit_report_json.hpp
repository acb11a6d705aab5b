#pragma once

#include <nlohmann/json_fwd.hpp>

#include "skylut/fit/fit_perez.hpp"

namespace skylut {

/// A fit's report as every JSON file of skylut has it: coefficients, standard errors, flags, residuals,
/// termination. Numbers that are not finite are written as null.
/// @param worst_direction  where the worst residual lies, as the file names its directions
nlohmann::ordered_json fit_report_json(const FitReport& report, nlohmann::ordered_json worst_direction);

}  // namespace skylut
