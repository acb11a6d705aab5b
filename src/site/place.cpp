#include "skylut/site/place.hpp"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/DMS.hpp>
#include <GeographicLib/Ellipsoid.hpp>
#include <GeographicLib/NormalGravity.hpp>
#include <cmath>
#include <string_view>

#include "place_range.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

using GeographicLib::DMS;

// Blanks as people and documents write them: ASCII, no-break, narrow no-break, thin, figure and hair space.
constexpr std::string_view kBlanks[] = {" ",      "\t",     "\n",     "\r",    "\u00A0",
                                        "\u202F", "\u2009", "\u2007", "\u200A"};

std::size_t blank_at(std::string_view text) {
  for (const std::string_view blank : kBlanks)
    if (text.starts_with(blank)) return blank.size();
  return 0;
}

bool is_digit(char character) { return character >= '0' && character <= '9'; }

// DMS takes no blanks: "48° 51′ 24″ N" becomes "48°51′24″N". A blank that parts two numbers is a colon
// ("48 51 24 N"); one beside a decimal point stays, so that it is refused.
std::string without_blanks(std::string_view text) {
  std::string joined;
  while (!text.empty()) {
    std::size_t blanks = 0;
    while (const std::size_t size = blank_at(text.substr(blanks))) blanks += size;
    if (blanks == 0) {
      joined += text.front();
      text.remove_prefix(1);
      continue;
    }
    const std::string_view before = joined;
    const std::string_view after = text.substr(blanks);
    text = after;
    if (before.empty() || after.empty()) continue;
    if (is_digit(before.back()) && is_digit(after.front()))
      joined += ':';
    else if (before.back() == '.' || (after.front() == '.' && is_digit(before.back())))
      joined += ' ';
  }
  return joined;
}

// One coordinate in [-limit, limit]; a hemisphere letter must be its own.
double parse_coordinate(const char* what, const std::string& text, DMS::flag expected, double limit_deg,
                        const char* example) {
  double value_deg = 0.0;
  DMS::flag found = DMS::NONE;
  try {
    value_deg = DMS::Decode(without_blanks(text), found);
  } catch (const std::exception&) {
    throw InputError("{} '{}': is no angle; expected degrees or DMS, for example {}", what, text, example);
  }
  if (found != DMS::NONE && found != expected)
    throw InputError("{} '{}': has the hemisphere of the other coordinate; expected for example {}", what,
                     text, example);
  if (!(std::abs(value_deg) <= limit_deg))
    throw InputError("{} '{}': must lie within -{} to {} degrees", what, text, limit_deg, limit_deg);
  return value_deg;
}

}  // namespace

void check_place(const Place& place) {
  if (!(std::abs(place.latitude_deg) <= 90.0))
    throw InputError("latitude {}: must lie within -90 to 90 degrees", place.latitude_deg);
  if (!(std::abs(place.longitude_deg) <= 180.0))
    throw InputError("longitude {}: must lie within -180 to 180 degrees", place.longitude_deg);
  require_within("height", place.height_m, domain::kGroundHeight_m);
}

Place parse_place(const std::string& latitude, const std::string& longitude, double height_m) {
  Place place;
  place.latitude_deg = parse_coordinate("latitude", latitude, DMS::LATITUDE, 90.0, "40.5 or 40d30'N");
  place.longitude_deg =
      parse_coordinate("longitude", longitude, DMS::LONGITUDE, 180.0, "-79.98 or 79d58'56\"W");
  place.height_m = height_m;
  check_place(place);
  return place;
}

double normal_gravity_m_s2(const Place& place) {
  check_place(place);
  double northward = 0.0;
  double upward = 0.0;
  GeographicLib::NormalGravity::WGS84().Gravity(place.latitude_deg, place.height_m, northward, upward);
  return std::hypot(northward, upward);
}

double radius_of_curvature_km(const Place& place) {
  check_place(place);
  const GeographicLib::Ellipsoid& earth = GeographicLib::Ellipsoid::WGS84();
  return 1e-3 * std::sqrt(earth.MeridionalCurvatureRadius(place.latitude_deg) *
                          earth.TransverseCurvatureRadius(place.latitude_deg));
}

}  // namespace skylut
