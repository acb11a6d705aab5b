#include "sun_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "number_options.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/site/sun.hpp"

namespace skylut::cli {

void SunOption::add_to(CLI::App& command, double lowest_sun_deg) {
  zenith_option_ = add_number(command, "--sun-zenith-deg", zenith_deg_, {0.0, lowest_sun_deg, "deg"},
                              fmt::format("of the sun, 0 to {}", lowest_sun_deg))
                       ->default_str("");
  azimuth_option_ = add_number(command, "--sun-azimuth-deg", azimuth_deg_, {0.0, 360.0, "deg"},
                               "of the sun, clockwise from north");
  command.add_option("--time", time_, "instead of the sun's angles, with a place: 2024-06-21T09:00Z")
      ->type_name("TIME");
}

void SunOption::put_into(SkyScene& scene, const SceneOptions& place, double lowest_sun_deg) const {
  const bool by_angles = zenith_option_->count() > 0;
  if (time_.empty()) {
    if (!by_angles) throw InputError("no sun: give --sun-zenith-deg, or --latitude, --longitude and --time");
    scene.suns = {{zenith_deg_, azimuth_deg_}};
    return;
  }
  if (place.has_date()) throw InputError("--time {}: gives the date, must not be given with --date", time_);
  if (by_angles || azimuth_option_->count() > 0)
    throw InputError("--time {}: gives the sun, must not be given with {}", time_,
                     by_angles ? "--sun-zenith-deg" : "--sun-azimuth-deg");
  const std::optional<Place> where = place.place();
  if (!where || !place.has_longitude())
    throw InputError("--time {}: needs --latitude and --longitude", time_);
  const UtcTime time = parse_time(time_);
  const Direction sun = sun_direction(*where, time);
  if (sun.zenith_deg > lowest_sun_deg)
    throw InputError("--time {}: the sun is {:.2f} deg from the zenith, must be at most {} deg", time_,
                     sun.zenith_deg, lowest_sun_deg);
  scene.suns = {sun};
  scene.time = time_;
  scene.sun_distance_au = earth_sun_distance_au(time);
}

std::string SunOption::command_line() const {
  if (!time_.empty()) return fmt::format("--time {}", time_);
  return fmt::format("--sun-zenith-deg {} --sun-azimuth-deg {}", zenith_deg_, azimuth_deg_);
}

}  // namespace skylut::cli
