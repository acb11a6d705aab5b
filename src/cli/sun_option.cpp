#include "sun_option.hpp"

#include "light_kinds.hpp"
#include "options/number_kinds.hpp"

namespace skylut::cli {

void SunOption::add_to(OptionSet& options, const Range& zenith) {
  options.add("--sun-zenith-deg", zenith_deg_, number(zenith),
              fmt::format("of the sun, 0 to {}", zenith.highest));
  options.add("--sun-azimuth-deg", azimuth_deg_, azimuth(), "of the sun, clockwise from north; default: 180");
  options.add("--time", time_, time_of_day(), "instead of the sun's angles, with a place: 2024-06-21T09:00Z");
}

void SunOption::put_into(SkyScene& scene, const SceneOptions& place) {
  if (!time_) {
    if (!zenith_deg_)
      throw InputError("no sun: give --sun-zenith-deg, or --latitude, --longitude and --time");
    azimuth_deg_ = azimuth_deg_.value_or(180.0);  // recorded as it was used
    scene.suns = {{*zenith_deg_, *azimuth_deg_}};
    return;
  }
  const std::string time = format_time(*time_);
  if (place.date()) throw InputError("--time {}: gives the date, must not be given with --date", time);
  if (zenith_deg_ || azimuth_deg_)
    throw InputError("--time {}: gives the sun, must not be given with {}", time,
                     zenith_deg_ ? "--sun-zenith-deg" : "--sun-azimuth-deg");
  const std::optional<Place> where = place.air().place();
  if (!where || !place.air().has_longitude())
    throw InputError("--time {}: needs --latitude and --longitude", time);
  scene.suns = {sun_direction(*where, *time_)};
  scene.time = time;
  scene.sun_distance_au = earth_sun_distance_au(*time_);
}

void SunOption::require_above(double lowest_sun_deg, const Direction& sun, const char* limit) const {
  if (sun.zenith_deg <= lowest_sun_deg) return;
  const std::string what =
      time_ ? "--time " + format_time(*time_) : fmt::format("--sun-zenith-deg {}", sun.zenith_deg);
  throw InputError("{}: the sun is {:.2f} deg from the zenith: {}", what, sun.zenith_deg, limit);
}

}  // namespace skylut::cli
