#pragma once

#include <optional>
#include <string>
#include <vector>

#include "particle_optics.hpp"

namespace skylut {

struct Context;

/// What particle_optics() was asked for, as a text that names every number it depends on.
std::string optics_key(const std::vector<AerosolComponent>& components,
                       const std::vector<double>& wavelength_nm);

/// Results of an earlier run for the same key, exactly as they were; nothing if there are none, or none that
/// can be read. Files lie in the context's cache folder (none: nothing is kept) and may be deleted at any
/// time.
std::optional<std::vector<ParticleOptics>> find_in_cache(const Context& context, const std::string& key);

/// Keeps results for later runs. A folder that cannot be written to is no failure.
void keep_in_cache(const Context& context, const std::string& key,
                   const std::vector<ParticleOptics>& results);

}  // namespace skylut
