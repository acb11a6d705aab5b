#pragma once

#include "skylut/colour/cie1931.hpp"
#include "skylut/export/projection.hpp"
#include "skylut/sky/sky_map.hpp"
#include "support/test_context.hpp"

namespace skylut {

inline std::vector<Direction> directions_of(const Projection& projection) {
  std::vector<Direction> directions;
  for (int row = 0; row < projection.height(); ++row)
    for (int column = 0; column < projection.width(); ++column)
      directions.push_back(projection.direction(column, row).value());
  return directions;
}

/// A map with a different made-up radiance for every direction and wavelength.
inline SkyMap made_up_map(std::vector<Direction> directions) {
  SkyMap map;
  map.altitude_km = 6.0;
  map.turbidity = {TurbidityKind::aod500, 0.25};
  map.sun = {45.0, 90.0};
  map.directions = std::move(directions);
  map.wavelengths = WavelengthGrid(400.0, 700.0, 50.0);
  const ColourMatching matching = ColourMatching::load(test::context);
  for (std::size_t direction = 0; direction < map.directions.size(); ++direction) {
    std::vector<double> radiance;
    for (std::size_t i = 0; i < map.wavelengths.size(); ++i) {
      map.radiance.push_back(0.01f + 0.001f * static_cast<float>(direction) +
                             0.0001f * static_cast<float>(i));
      radiance.push_back(map.radiance.back());
    }
    map.colour.push_back(to_yxy(matching.integrate(map.wavelengths, radiance)));
  }
  return map;
}

}  // namespace skylut
