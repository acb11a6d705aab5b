#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "options/light_kinds.hpp"
#include "options/options.hpp"
#include "scene_options.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/site/sun_series.hpp"

namespace skylut::cli {

/// Where the sun stands: by its angles, or by place and time, which give its distance too. Or many suns, one
/// after the other.
class SunOption {
 public:
  /// Adds --sun-zenith-deg, --sun-azimuth-deg and --time.
  /// @param zenith  what the zenith angle may be
  /// @param time    a moment, or time_or_steps()
  void add_to(OptionSet& options, const Range& zenith, const Kind<TimeOrSteps>& time = one_time());
  /// Adds --apparent, for commands whose scenes hold their altitude and air before the sun is put into them.
  void add_apparent_to(OptionSet& options);

  /// Adds --suns and --times.
  void add_series_to(OptionSet& options);

  bool is_series() const;
  /// The file that times were read from.
  const std::optional<std::filesystem::path>& times_file() const { return times_; }

  /// Puts the sun, and with a time its distance, into a scene.
  /// @throws InputError  no sun, two suns, a time without place
  void put_into(SkyScene& scene, const SunPlace& where);

  /// The suns of a series. @param sun_distance_au  of those that are given by their angles
  /// @throws InputError  as put_into(); none of them lights a sky
  SunSeries series(const SunPlace& where, double sun_distance_au) const;

  /// Refuses a sun that is too low for what is asked of it.
  /// @param limit  "diffuse light ends at 99 deg, use --no-diffuse"
  /// @throws InputError  naming the option, the sun's zenith angle and the limit
  void require_above(double lowest_sun_deg, const Direction& sun, const char* limit) const;

 private:
  /// As it was typed, unless the sun is given by its angles.
  std::string chosen() const;
  void require_alone() const;
  Place place_of(const SunPlace& where) const;

  std::optional<double> zenith_deg_;
  std::optional<double> azimuth_deg_;
  bool apparent_ = false;
  std::optional<TimeOrSteps> time_;
  std::optional<std::filesystem::path> times_;
  std::optional<std::vector<Direction>> suns_;
};

}  // namespace skylut::cli
