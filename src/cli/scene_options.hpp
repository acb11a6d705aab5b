#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "options/options.hpp"
#include "program_context.hpp"
#include "skylut/atmosphere/atmosphere_description.hpp"
#include "skylut/site/place.hpp"
#include "skylut/site/sun.hpp"
#include "skylut/sky/simulate_sky.hpp"

namespace skylut::cli {

/// Where on Earth.
class PlaceOptions {
 public:
  /// Adds --latitude, --longitude and --height-m.
  void add_to(OptionSet& options);

  std::optional<Place> place() const;  ///< @throws InputError  if only a part of a place was given
  bool has_longitude() const { return longitude_deg_.has_value(); }

 private:
  std::optional<double> latitude_deg_;
  std::optional<double> longitude_deg_;
  std::optional<double> height_m_;
};

/// Where a sun that is given by its time is seen from.
struct SunPlace {
  const PlaceOptions& place;
  bool has_date = false;  ///< a date was given too
};

/// The options of the air, its ground and its place.
class AirOptions {
 public:
  void add_to(OptionSet& options);

  /// What the options say of the atmosphere with a profile. @throws InputError  if only a part of a place was
  /// given
  AtmosphereDescription atmosphere(const std::string& profile) const;
  const PlaceOptions& place() const { return place_; }
  TurbidityKind turbidity_kind() const { return turbidity_kind_; }
  void take_turbidities_as(TurbidityKind kind) { turbidity_kind_ = kind; }

 private:
  TurbidityKind turbidity_kind_ = TurbidityKind::aod500;
  AtmosphereDescription description_;  // all but profile and place
  bool refraction_ = false;
  bool no_refraction_ = false;
  PlaceOptions place_;
};

/// The options that every command which simulates skies shares: the profile and its air, the sun's spectrum,
/// the wavelengths, how finely and on how many threads to compute.
class SceneOptions {
 public:
  void add_to(OptionSet& options);

  /// The scene without altitudes, turbidities, suns and directions.
  /// @throws InputError  for what is unknown or broken, a place that cannot be
  SkyScene scene(const Context& context) const;

  /// The scene's air over another ground, of that albedo. @throws InputError  as scene()
  std::shared_ptr<const Atmosphere> air_over_ground(const Context& context, double albedo) const;

  /// How the scene's results come about, with the quality. @param command  that makes them again
  Provenance provenance(const Context& context, const SkyScene& scene, std::string command) const;

  TransferOptions transfer() const;
  /// Whether every direction is to have a line of sight of its own, solved under all sun nodes.
  bool exact() const { return exact_; }
  Context context() const { return program_context(computing_); }
  const AirOptions& air() const { return air_; }
  /// As if --turbidity-kind had been given.
  void take_turbidities_as(TurbidityKind kind) { air_.take_turbidities_as(kind); }
  /// What a sun by its time needs to know.
  SunPlace sun_place() const { return {air_.place(), date_.has_value()}; }

 private:
  std::string profile_ = AtmosphereDescription{}.profile;
  AirOptions air_;
  std::string solar_ = SkyScene{}.solar;
  std::optional<UtcTime> date_;
  WavelengthGrid wavelengths_ = WavelengthGrid::visible();
  Quality quality_ = Quality::standard;
  bool exact_ = false;
  bool scalar_ = false;
  ComputingOptions computing_;
};

/// draft, default or reference.
Kind<Quality> quality_kind();

/// aod500, aod550 and so on.
Kind<TurbidityKind> turbidity_kind_by_name();

/// --turbidity, for commands that take one.
Option& add_turbidity(OptionSet& options, double& turbidity);

/// The default of --turbidity is no turbidity of another kind. @throws InputError  if only the kind was given
void require_turbidity_with_its_kind(const OptionSet& options);

/// One turbidity in all kinds, as far as they exist: "aod500 0.1 = aod550 0.0883 = …".
std::string turbidity_text(const Turbidity& turbidity, const Atmosphere& air);

}  // namespace skylut::cli
