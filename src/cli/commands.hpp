#pragma once

namespace CLI {
class App;
}

/// The subcommands of the program, one file each: command_<name>.cpp. Each adds itself with its options
/// and runs when it was asked for, once all its options are read.
namespace skylut::cli {

/// `skylut table --out DIR`: simulate, fit, write the coefficient table.
void add_table_command(CLI::App& program);

/// `skylut map -o sky.exr|sky.csv`: one sky.
void add_map_command(CLI::App& program);

/// `skylut fit FILE`: Perez coefficients of any sky.
void add_fit_command(CLI::App& program);

/// `skylut compare DIR|FILE --against NAME`: a table or sky beside a published model.
void add_compare_command(CLI::App& program);

/// `skylut profile list|show NAME`: the atmospheres.
void add_profile_command(CLI::App& program);

/// `skylut aerosol list|show NAME|mie`: what particles do to light.
void add_aerosol_command(CLI::App& program);

/// `skylut solve CASE.json`: radiative transfer through explicit layers.
void add_solve_command(CLI::App& program);

/// `skylut sun`: where the sun stands and its spectral irradiance.
void add_sun_command(CLI::App& program);

}  // namespace skylut::cli
