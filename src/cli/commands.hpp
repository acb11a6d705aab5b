#pragma once

#include "options/command.hpp"

/// The commands of the program, one file each: command_<name>.cpp. Each declares its options, and checks,
/// calls the library and prints when it runs.
namespace skylut::cli {

/// `skylut table --out DIR`: simulate, fit, write the coefficient table.
Command table_command();

/// `skylut map -o sky.exr|sky.csv`: one sky.
Command map_command();

/// `skylut fit FILE`: Perez coefficients of any sky.
Command fit_command();

/// `skylut eval SOURCE -o sky.exr|sky.csv`: one sky of a table or model.
Command eval_command();

/// `skylut compare DIR|FILE --against NAME`: a table or sky beside a published model.
Command compare_command();

/// `skylut profile list|show NAME|case NAME`: the atmospheres.
Command profile_command();

/// `skylut profile case NAME`: the air at one wavelength as a case for `skylut solve`.
Command profile_case_command();

/// `skylut aerosol list|show NAME|mie`: what particles do to light.
Command aerosol_command();

/// `skylut solve CASE.json`: radiative transfer through explicit layers.
Command solve_command();

/// `skylut sun`: where the sun stands and its spectral irradiance.
Command sun_command();

}  // namespace skylut::cli
