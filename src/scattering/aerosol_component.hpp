#pragma once

#include <optional>

#include "core/toml_reader.hpp"
#include "skylut/scattering/aerosol_description.hpp"

namespace skylut {

/// A component as read, at one humidity.
struct ReadComponent {
  AerosolComponent component;
  bool takes_up_water = false;  ///< the file gives it for several humidities
};

/// Reads the particles of a component: sizes and refractive index, for one humidity or for several
/// [[humidity]] states, between which the logarithms of the radii and the index are linear.
/// @param extra_keys  keys of the table that the caller reads
/// @param humidity_percent  wanted; needed if there are several states
/// @throws InputError  one line naming file, line, key, value and what would be right
ReadComponent read_component(const TomlReader& reader, std::initializer_list<std::string_view> extra_keys,
                             std::optional<double> humidity_percent);

}  // namespace skylut
