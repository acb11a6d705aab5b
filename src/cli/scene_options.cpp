#include "scene_options.hpp"

#include <memory>
#include <utility>

#include "advice.hpp"
#include "options/file_kinds.hpp"
#include "options/light_kinds.hpp"
#include "options/number_kinds.hpp"

namespace skylut::cli {

void PlaceOptions::add_to(OptionSet& options) {
  options.add("--latitude", latitude_deg_, latitude(), "geodetic, decimal degrees or as 48:51:24N");
  options.add("--longitude", longitude_deg_, longitude(), "decimal degrees or as 2d21'03\"E");
  options.add("--height-m", height_m_, number(domain::kGroundHeight_m),
              "of the ground above the ellipsoid; default: 0");
}

std::optional<Place> PlaceOptions::place() const {
  if (!latitude_deg_) {
    if (longitude_deg_ || height_m_)
      throw InputError("--{}: needs --latitude too", longitude_deg_ ? "longitude" : "height-m");
    return std::nullopt;
  }
  return Place{*latitude_deg_, longitude_deg_.value_or(0.0), height_m_.value_or(0.0)};
}

void AirOptions::add_to(OptionSet& options) {
  options.group("Air");
  options.add("--turbidity-kind", turbidity_kind_, turbidity_kind_by_name(),
              "aod500, aod550, angstrom-beta, preetham-t or visibility-km");
  options.add("--aerosol", description_.aerosol, name_or_file(),
              "what the aerosol is: a name (skylut aerosol list) or a TOML file");
  options.add("--humidity", description_.humidity_percent, number(domain::kHumidity_percent),
              "relative humidity in percent that its particles have grown at; default: the aerosol's");
  options.add("--albedo", description_.ground_albedo, albedo(),
              "of the ground, Lambertian: a number, grass, sand, snow, water, asphalt or a CSV file");
  options.add("--ozone-du", description_.ozone_du, number(domain::kOzone_DU),
              "ozone column in Dobson units; default: the profile's");
  options.add("--water-cm", description_.water_cm, number(domain::kWater_cm),
              "precipitable water in cm; default: the profile's");
  options.add("--no2-du", description_.no2_du, number(domain::kNitrogenDioxide_DU),
              "nitrogen dioxide column in Dobson units; default: the profile's");
  options.add("--pressure-hpa", description_.surface_pressure_hPa, number(domain::kSurfacePressure_hPa),
              "pressure at the ground: scales the air and its oxygen at all heights; default: the profile's");
  options.add_flag("--refraction", refraction_, "the air bends lines of sight and sunbeams");
  options.add_flag("--no-refraction", no_refraction_, "light goes straight");

  options.group("Place: gives gravity and the Earth's radius (default: standard gravity, 6371 km)");
  place_.add_to(options);
}

AtmosphereDescription AirOptions::atmosphere(const std::string& profile) const {
  AtmosphereDescription description = description_;
  description.profile = profile;
  description.place = place_.place();
  if (refraction_ && no_refraction_) throw InputError("--refraction: must not be given with --no-refraction");
  description.refraction = !no_refraction_ && (refraction_ || AtmosphereDescription{}.refraction);
  return description;
}

void SceneOptions::add_to(OptionSet& options) {
  options.group("Air");
  options.add("--profile", profile_, name_or_file(),
              "layered atmosphere: a name (skylut profile list) or a TOML file");
  air_.add_to(options);

  options.group("Sun");
  options.add("--solar", solar_, name_or_file(),
              "spectrum above the air: astm-g173, gueymard2003, kurucz1992 or a CSV file");
  options.add("--date", date_, day(), "sets the Earth-Sun distance: 2026-06-21 (default: the mean distance)");

  options.group("Computing");
  options.add("--wavelengths-nm", wavelengths_, wavelengths(),
              "first, last and step: each the middle of a band; the first and last are clipped at the "
              "spectrum's ends");
  options.add("--quality", quality_, quality_kind(), "draft, default or reference");
  options.add_flag("--scalar", scalar_,
                   "take light for unpolarised: up to 8 % wrong in a clear sky, at half the cost");
  options.add_flag("--exact", exact_,
                   "every direction by its own line of sight, no sky in between: slower, same to 0.3 %");
  computing_.add_to(options);
}

SkyScene SceneOptions::scene(const Context& context) const {
  SkyScene scene;
  scene.wavelengths = wavelengths_;
  scene.atmosphere = std::make_shared<const Atmosphere>(build_atmosphere(context, air_.atmosphere(profile_)));
  advise_on_profile(context, scene.atmosphere->profile());
  scene.place = air_.place().place();
  scene.solar = solar_;
  if (date_) scene.sun_distance_au = earth_sun_distance_au(*date_);
  return scene;
}

std::shared_ptr<const Atmosphere> SceneOptions::air_over_ground(const Context& context, double albedo) const {
  AtmosphereDescription description = air_.atmosphere(profile_);
  description.ground_albedo = written(albedo);
  return std::make_shared<const Atmosphere>(build_atmosphere(context, description));
}

TransferOptions SceneOptions::transfer() const {
  TransferOptions options;
  options.discretisation = discretisation_of(quality_);
  if (exact_) options.discretisation.sun_bands = false;
  if (scalar_) options.discretisation.polarised_degree = 0;
  return options;
}

Provenance SceneOptions::provenance(const Context& context, const SkyScene& scene,
                                    std::string command) const {
  Provenance provenance = scene_provenance(context, scene, std::move(command));
  provenance.describe("quality", quality_kind().write(quality_));
  provenance.describe("light", scalar_ ? "unpolarised" : "polarised");
  return provenance;
}

Kind<TurbidityKind> turbidity_kind_by_name() {
  std::vector<std::pair<std::string, TurbidityKind>> choices;
  for (const TurbidityKind kind : turbidity_kinds()) choices.emplace_back(turbidity_kind_name(kind), kind);
  return choice(std::move(choices));
}

Kind<Quality> quality_kind() {
  return choice<Quality>(
      {{"draft", Quality::draft}, {"default", Quality::standard}, {"reference", Quality::reference}});
}

Option& add_turbidity(OptionSet& options, double& turbidity) {
  return options.add("--turbidity", turbidity, number(domain::kTurbidityValue),
                     "of the kind of --turbidity-kind");
}

void require_turbidity_with_its_kind(const OptionSet& options) {
  if (options.given("--turbidity-kind") && !options.given("--turbidity"))
    throw InputError("--turbidity-kind: needs --turbidity");
}

std::string turbidity_text(const Turbidity& turbidity, const Atmosphere& air) {
  const double aod500 = to_aod500(turbidity, air);
  std::string text = fmt::format("{} {}", turbidity_kind_name(turbidity.kind), turbidity.value);
  for (const TurbidityKind kind : turbidity_kinds())
    if (kind != turbidity.kind)
      text += fmt::format(" = {} {:.4g}", turbidity_kind_name(kind), from_aod500(aod500, kind, air));
  return text;
}

}  // namespace skylut::cli
