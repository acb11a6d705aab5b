#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skylut/atmosphere/atmosphere_description.hpp"
#include "skylut/site/place.hpp"
#include "skylut/sky/simulate_sky.hpp"

namespace CLI {
class App;
}

namespace skylut::cli {

/// The options that every command which simulates skies shares: the air, its place, the wavelengths and
/// how finely and on how many threads to compute.
class SceneOptions {
 public:
  /// Adds the options to a command; this object must outlive its parsing.
  void add_to(CLI::App& command);

  /// Adds only the options of the air, its ground and its place.
  void add_air_to(CLI::App& command);

  /// The scene without altitudes, turbidities, suns and directions.
  /// @throws InputError  for an unknown profile, a place or range that cannot be
  SkyScene scene(const Context& context) const;

  TransferOptions transfer() const;
  std::optional<Place> place() const;  ///< @throws InputError if it is no place
  TurbidityKind turbidity_kind() const;
  bool turbidity_kind_given() const { return turbidity_kind_given_; }
  /// What the options say of the atmosphere. @throws InputError if the place is none
  AtmosphereDescription atmosphere() const;
  bool has_date() const { return !date_.empty(); }
  bool has_longitude() const { return !longitude_.empty(); }
  const std::string& quality() const { return quality_; }
  int threads() const { return threads_; }

  /// These options as a command line, defaults spelled out; without threads, which change no result.
  std::string command_line() const;
  /// The part that add_air_to adds.
  std::string air_command_line() const;

 private:
  std::string profile_ = "ussa1976";
  std::string turbidity_kind_ = "aod500";
  bool turbidity_kind_given_ = false;
  std::string wavelengths_ = "380:780:5";
  std::string aerosol_ = "rural";
  std::optional<double> humidity_percent_;
  std::string albedo_ = "0.2";
  std::optional<double> ozone_du_;
  std::optional<double> water_cm_;
  std::optional<double> no2_du_;
  std::optional<double> surface_pressure_hPa_;
  std::string solar_ = "astm-g173";
  std::string date_;
  std::string latitude_;
  std::string longitude_;
  double height_m_ = 0.0;
  std::string quality_ = "default";
  int threads_ = 0;
};

/// A sun as "Z:A", zenith angle and azimuth in degrees. @throws InputError naming the text
Direction parse_sun(const std::string& text);

/// Suns separated by commas. @throws InputError as parse_sun
std::vector<Direction> parse_suns(const std::string& text);

/// One turbidity in all kinds, as far as they exist: "aod500 0.1 = aod550 0.0883 = …".
std::string turbidity_text(const Turbidity& turbidity, const Atmosphere& atmosphere);

/// What sun zenith angles, azimuths and observers' altitudes may be.
inline constexpr double kLowestSun_deg = 96.0;
inline constexpr double kHighestAltitude_km = 30.0;

}  // namespace skylut::cli
