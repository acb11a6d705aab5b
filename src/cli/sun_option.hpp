#pragma once

#include <string>

#include "scene_options.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace skylut::cli {

/// Where the sun stands: by its angles, or by place and time, which give its distance too.
class SunOption {
 public:
  /// Adds --sun-zenith-deg, --sun-azimuth-deg and --time; this object must outlive the parsing.
  /// @param lowest_sun_deg  greatest zenith angle that may be given
  void add_to(CLI::App& command, double lowest_sun_deg);

  /// Puts the sun, and with a time its distance, into a scene.
  /// @param place           the options that may hold the place
  /// @param lowest_sun_deg  greatest zenith angle that a time may lead to
  /// @throws InputError  no sun, two suns, a time without place, a sun that is too low
  void put_into(SkyScene& scene, const SceneOptions& place, double lowest_sun_deg) const;

  /// These options as a command line.
  std::string command_line() const;

 private:
  double zenith_deg_ = 0.0;
  double azimuth_deg_ = 180.0;
  std::string time_;
  // Which of them were typed.
  const CLI::Option* zenith_option_ = nullptr;
  const CLI::Option* azimuth_option_ = nullptr;
};

}  // namespace skylut::cli
