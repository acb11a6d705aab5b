#pragma once

#include <optional>

namespace skylut::transfer {

/// A view and a sun, in degrees; the azimuth is the sun's from the view.
struct ViewAndSun {
  double view_zenith_deg;
  double sun_zenith_deg;
  double relative_azimuth_deg;
};

/// What an observer above the air sees is what one would see where his line of sight enters it: the same
/// light in other angles, those at the vertical there. Above the air light is straight.
/// @param altitude_km  of the observer, at least top_km
/// @return  nothing where the line misses the air: it is black
std::optional<ViewAndSun> view_from_entry(double planet_radius_km, double top_km, double altitude_km,
                                          const ViewAndSun& outside);

}  // namespace skylut::transfer
