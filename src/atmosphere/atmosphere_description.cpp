#include "skylut/atmosphere/atmosphere_description.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "skylut/core/context.hpp"
#include "skylut/profile/profile_json.hpp"
#include "skylut/scattering/aerosol_json.hpp"

namespace skylut {

namespace {

// The data tables that every atmosphere reads.
constexpr const char* kTables[] = {
    "spectra/ozone_cross_section.csv", "spectra/nitrogen_dioxide_cross_section.csv",
    "spectra/oxygen_pair_cross_section.csv", "spectra/oxygen_lines.csv", "spectra/water_lines.csv"};

}  // namespace

Atmosphere build_atmosphere(const Context& context, const AtmosphereDescription& description) {
  AtmosphereOptions options;
  options.ground_albedo = GroundAlbedo::parse(context, description.ground_albedo);
  options.ozone_du = description.ozone_du;
  options.no2_du = description.no2_du;
  options.water_cm = description.water_cm;
  options.surface_pressure_hPa = description.surface_pressure_hPa;
  options.refraction = description.refraction;
  Profile profile = load_profile(context, description.profile);
  if (description.place) {
    Place place = *description.place;
    options.planet_radius_km = radius_of_curvature_km(place);
    // A mountain has a mountain's air: where neither the pressure is given nor the profile knows its own
    // ground, the place's height is where the air begins. The decrease of gravity up to there is in the
    // profile already.
    if (!description.surface_pressure_hPa && !profile.ground_height_km) {
      profile = raised_to(profile, 1e-3 * place.height_m);
      place.height_m = 0.0;
    }
    options.gravity_m_s2 = normal_gravity_m_s2(place);
  }
  options.aerosol = load_aerosol(context, description.aerosol, description.humidity_percent);
  return {context, std::move(profile), std::move(options)};
}

void describe_into(const Context& context, const Atmosphere& atmosphere, Provenance& provenance) {
  provenance.describe("profile", profile_json(atmosphere.profile()));
  provenance.describe("air", atmosphere.describe());
  std::vector<std::string> files{atmosphere.profile().file, atmosphere.options().ground_albedo.file()};
  for (std::string& file : files_of(atmosphere.aerosol())) files.push_back(std::move(file));
  for (const char* table : kTables) files.push_back(context.data_file(table).string());
  for (const std::string& file : files)
    if (!file.empty()) provenance.add_source(context, file);
}

}  // namespace skylut
