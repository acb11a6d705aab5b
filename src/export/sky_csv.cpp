#include "skylut/export/sky_csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "skylut/core/constants.hpp"
#include "skylut/core/version.hpp"

namespace skylut {

std::string sky_csv(const SkyMap& map, const Provenance& provenance) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "zenith_deg,azimuth_deg,gamma_deg,Y_cd_m2,x,y");
  const bool spectral = !map.radiance.empty();
  for (std::size_t i = 0; spectral && i < map.wavelengths.size(); ++i)
    fmt::format_to(out, ",L_{}", map.wavelengths[i]);
  text.push_back('\n');
  fmt::format_to(out, "# skylut {} sky map: diffuse light, without the solar disc\n", kVersion);
  fmt::format_to(out, "# altitude_km={}\n", map.altitude_km);
  fmt::format_to(out, "# turbidity={}\n", map.turbidity.value);
  fmt::format_to(out, "# turbidity_kind={}\n", turbidity_kind_name(map.turbidity.kind));
  fmt::format_to(out, "# sun_zenith_deg={}\n", map.sun.zenith_deg);
  fmt::format_to(out, "# sun_azimuth_deg={}\n", map.sun.azimuth_deg);
  fmt::format_to(out,
                 "# units: angles in degrees, azimuth clockwise from north, gamma to the sun; Y in cd m-2; "
                 "x and y CIE 1931 2 deg; L_<nm> in W m-2 sr-1 nm-1\n");
  fmt::format_to(out, "{}", provenance.comment_lines());
  for (std::size_t i = 0; i < map.directions.size(); ++i) {
    const Direction& direction = map.directions[i];
    const Yxy& colour = map.colour[i];
    const double gamma_deg = angle_between(direction, map.sun) * kDegreesPerRadian;
    fmt::format_to(out, "{},{},{},{},{},{}", direction.zenith_deg, direction.azimuth_deg, gamma_deg, colour.Y,
                   colour.x, colour.y);
    if (spectral)
      for (const float radiance : map.spectrum(i)) fmt::format_to(out, ",{}", radiance);
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

}  // namespace skylut
