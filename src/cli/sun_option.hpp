#pragma once

#include <optional>

#include "options/options.hpp"
#include "scene_options.hpp"
#include "skylut/core/domain.hpp"

namespace skylut::cli {

/// Where the sun stands: by its angles, or by place and time, which give its distance too.
class SunOption {
 public:
  /// Adds --sun-zenith-deg, --sun-azimuth-deg and --time.
  /// @param zenith  what the zenith angle may be
  void add_to(OptionSet& options, const Range& zenith);

  /// Puts the sun, and with a time its distance, into a scene.
  /// @throws InputError  no sun, two suns, a time without place
  void put_into(SkyScene& scene, const SceneOptions& place);

  /// Refuses a sun that is too low for what is asked of it.
  /// @param limit  "diffuse light ends at 96 deg, use --no-diffuse"
  /// @throws InputError  naming the option, the sun's zenith angle and the limit
  void require_above(double lowest_sun_deg, const Direction& sun, const char* limit) const;

 private:
  std::optional<double> zenith_deg_;
  std::optional<double> azimuth_deg_;
  std::optional<UtcTime> time_;
};

}  // namespace skylut::cli
