#include "sun_option.hpp"

#include "options/file_kinds.hpp"
#include "options/number_kinds.hpp"
#include "skylut/transfer/refraction.hpp"

namespace skylut::cli {

void SunOption::add_to(OptionSet& options, const Range& zenith, const Kind<TimeOrSteps>& time) {
  options.add("--sun-zenith-deg", zenith_deg_, number(zenith),
              fmt::format("of the sun, 0 to {}", zenith.highest));
  options.add("--sun-azimuth-deg", azimuth_deg_, azimuth(), "of the sun, clockwise from north; default: 180");
  options.add("--time", time_, time, "instead of the sun's angles, with a place: 2024-06-21T09:00Z");
}

void SunOption::add_apparent_to(OptionSet& options) {
  options.add_flag("--apparent", apparent_,
                   "--sun-zenith-deg is where refraction shows the sun; default: its true place");
}

void SunOption::add_series_to(OptionSet& options) {
  options.add("--suns", suns_, suns(),
              "numbered pictures: a list of suns, zenith angle:azimuth, 45:90,60:100");
  options.add("--times", times_, file_in(), "the same by the column time of a CSV file, with a place");
}

bool SunOption::is_series() const {
  return suns_ || times_ || (time_ && std::holds_alternative<TimeSteps>(*time_));
}

std::string SunOption::chosen() const {
  if (time_) return "--time " + time_or_steps().write(*time_);
  if (times_) return "--times " + times_->string();
  return suns_ ? "--suns" : "";
}

void SunOption::require_alone() const {
  const std::string sun = chosen();
  if (sun.empty()) return;
  const auto refuse = [&sun](bool given, const char* other) {
    if (given) throw InputError("{}: gives the sun, must not be given with {}", sun, other);
  };
  refuse(zenith_deg_.has_value(), "--sun-zenith-deg");
  refuse(azimuth_deg_.has_value(), "--sun-azimuth-deg");
  refuse(time_ && times_, "--times");
  refuse((time_ || times_) && suns_, "--suns");
}

Place SunOption::place_of(const SunPlace& where) const {
  if (where.has_date) throw InputError("{}: gives the date, must not be given with --date", chosen());
  const std::optional<Place> place = where.place.place();
  if (!place || !where.place.has_longitude())
    throw InputError("{}: needs --latitude and --longitude", chosen());
  return *place;
}

void SunOption::put_into(SkyScene& scene, const SunPlace& where) {
  require_alone();
  if (apparent_ && !zenith_deg_) throw InputError("--apparent: says what --sun-zenith-deg is, needs it");
  if (!time_) {
    if (!zenith_deg_)
      throw InputError("no sun: give --sun-zenith-deg, or --latitude, --longitude and --time");
    azimuth_deg_ = azimuth_deg_.value_or(180.0);  // recorded as it was used
    const double zenith_deg =
        apparent_ ? true_sun_zenith_deg(scene.atmosphere->shells(), scene.altitudes_km.at(0), *zenith_deg_)
                  : *zenith_deg_;
    scene.suns = {{zenith_deg, *azimuth_deg_}};
    return;
  }
  const auto& time = std::get<UtcTime>(*time_);
  scene.suns = {sun_direction(place_of(where), time)};
  scene.time = format_time(time);
  scene.sun_distance_au = earth_sun_distance_au(time);
}

SunSeries SunOption::series(const SunPlace& where, double sun_distance_au) const {
  require_alone();
  if (apparent_)
    throw InputError("--apparent: says what --sun-zenith-deg is, must not be given with {}", chosen());
  SunSeries series = suns_ ? sun_series(*suns_, sun_distance_au)
                           : sun_series(place_of(where), times_ ? read_times_csv(*times_)
                                                                : times_of(std::get<TimeSteps>(*time_)));
  if (series.frames.empty())
    throw InputError("{}: {} suns, all more than {} deg from the zenith (night)", chosen(), series.too_dark,
                     domain::kSunZenith_deg.highest);
  return series;
}

void SunOption::require_above(double lowest_sun_deg, const Direction& sun, const char* limit) const {
  if (sun.zenith_deg <= lowest_sun_deg) return;
  const std::string what = time_ ? chosen() : fmt::format("--sun-zenith-deg {}", sun.zenith_deg);
  throw InputError("{}: the sun is {:.2f} deg from the zenith: {}", what, sun.zenith_deg, limit);
}

}  // namespace skylut::cli
