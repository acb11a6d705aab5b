#include "skylut/scattering/aerosol_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace skylut {

using Json = nlohmann::ordered_json;

namespace {

Json component_json(const AerosolComponent& component) {
  const SizeDistribution& size = component.size;
  Json json{{"name", component.name}, {"number_per_cm3", component.number_per_cm3}};
  if (size.kind == SizeDistribution::Kind::lognormal) {
    json["mode_radius_um"] = size.mode_radius_um;
    json["sigma_g"] = size.sigma_g;
  } else {
    json["exponent"] = size.exponent;
  }
  json["r_min_um"] = size.r_min_um;
  json["r_max_um"] = size.r_max_um;
  json["wavelength_nm"] = component.wavelength_nm;
  json["n"] = component.n;
  json["k"] = component.k;
  return json;
}

void add_description(const AerosolDescription& description, Json& json) {
  json["description"] = description.description;
  json["source"] = description.source;
  if (description.humidity_percent) json["humidity_percent"] = *description.humidity_percent;
  for (const AerosolComponent& component : description.components)
    json["components"].push_back(component_json(component));
}

void add_shape(const AerosolOptics& optics, Json& json) {
  const AerosolShape& shape = optics.shape;
  Json& where = json["shape"] = Json::object();
  if (optics.description) where["source"] = optics.description->shape_source;
  if (shape.altitude_km.empty()) {
    where["mixed_layer_km"] = shape.mixed_layer_km;
    where["scale_height_km"] = shape.haze_scale_height_km;
  } else {
    where["altitude_km"] = shape.altitude_km;
    where["relative_extinction"] = shape.relative_extinction;
  }
  json["stratosphere"] = {{"aerosol", optics.stratospheric_optics().name},
                          {"aod500", shape.stratospheric_aod500},
                          {"centre_km", shape.stratospheric_centre_km},
                          {"width_km", shape.stratospheric_width_km}};
}

}  // namespace

Json aerosol_json(const AerosolOptics& optics) {
  Json json{{"name", optics.name}};
  if (optics.description) add_description(*optics.description, json);
  json["wavelength_nm"] = optics.wavelength_nm;
  for (const double nm : optics.wavelength_nm)
    json["relative_extinction"].push_back(optics.relative_depth(nm));
  json["single_scattering_albedo"] = optics.single_scattering_albedo;
  json["asymmetry"] = optics.asymmetry;
  json["phase_function"] = optics.phase.empty() ? "henyey-greenstein" : "mie";
  add_shape(optics, json);
  if (optics.stratosphere) {
    Json above = aerosol_json(*optics.stratosphere);
    above.erase("shape");
    above.erase("stratosphere");
    json["stratosphere"]["optics"] = std::move(above);
  }
  return json;
}

std::vector<std::string> files_of(const AerosolOptics& optics) {
  std::vector<std::string> files;
  if (optics.description) {
    files.push_back(optics.description->file);
    for (const AerosolComponent& component : optics.description->components)
      if (!component.file.empty()) files.push_back(component.file);
  }
  if (optics.stratosphere)
    for (std::string& file : files_of(*optics.stratosphere)) files.push_back(std::move(file));
  return files;
}

}  // namespace skylut
