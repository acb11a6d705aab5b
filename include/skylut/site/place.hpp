#pragma once

#include <string>

namespace skylut {

/// A place on the Earth, geodetic on the WGS84 ellipsoid.
struct Place {
  double latitude_deg = 45.0;  ///< north positive, [-90, 90]
  double longitude_deg = 0.0;  ///< east positive, [-180, 180]
  double height_m = 0.0;       ///< above the ellipsoid, [-500, 9000]

  bool operator==(const Place&) const = default;
};

/// Reads a place from texts as GeographicLib's DMS class does: decimal degrees ("-33.9", "33.9S") or
/// degrees, minutes and seconds ("40d26'47\"N", "79:58:56W"), with or without blanks between its parts
/// ("N 40° 26′ 47″", "40 26 47 N").
/// @throws InputError  naming the coordinate and its text if it is no coordinate, if a latitude is
///                     given for the longitude or the other way round, or if it is out of range
Place parse_place(const std::string& latitude, const std::string& longitude, double height_m);

/// Normal gravity γ at the place's latitude and height, m/s²: gravity and centrifugal acceleration of
/// the WGS84 ellipsoid along its own field line (GeographicLib::NormalGravity; Heiskanen & Moritz
/// 1967, §2-7). 9.7803 at the equator, 9.8062 at 45°, 9.8322 at the poles, less 3.1e-6 per metre.
/// @throws InputError  for a place out of range
double normal_gravity_m_s2(const Place& place);

/// Radius of the sphere that fits the ellipsoid best at the place, km: the Gaussian radius √(M N) of
/// the meridional (M) and the transverse (N) radius of curvature. 6356.75 at the equator, 6378.10 at
/// 45°, 6399.59 at the poles (the flattened pole is curved least).
/// @throws InputError  for a place out of range
double radius_of_curvature_km(const Place& place);

}  // namespace skylut
