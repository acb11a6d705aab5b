#pragma once

namespace CLI {
class App;
}

namespace skylut::cli {

/// `skylut profile case NAME`: the air at one wavelength as a case for `skylut solve`.
void add_profile_case_command(CLI::App& profile);

}  // namespace skylut::cli
