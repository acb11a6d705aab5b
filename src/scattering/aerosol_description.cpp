#include "skylut/scattering/aerosol_description.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "aerosol_component.hpp"
#include "core/toml_reader.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"

namespace skylut {

namespace {

constexpr const char* kFolder = "aerosols";

bool is_path(const std::string& text) {
  return text.find('/') != std::string::npos || text.ends_with(".toml");
}

std::vector<std::string> names_in(const Context& context, const std::string& folder) {
  std::vector<std::string> names;
  if (!std::filesystem::is_directory(context.data_folder / folder))
    throw WorkError("{}: data folder is missing", (context.data_folder / folder).string());
  for (const auto& entry : std::filesystem::directory_iterator(context.data_folder / folder))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string file_of(const Context& context, const std::string& name_or_path) {
  if (is_path(name_or_path)) {
    if (!std::filesystem::is_regular_file(name_or_path) && !std::filesystem::is_fifo(name_or_path))
      throw InputError("aerosol '{}': no such file", name_or_path);
    return name_or_path;
  }
  const std::vector<std::string> names = aerosol_names(context);
  if (std::find(names.begin(), names.end(), name_or_path) == names.end())
    throw InputError("aerosol '{}': must be one of {}, or a .toml file{}", name_or_path,
                     fmt::join(names, ", "), suggested(name_or_path, names));
  return context.data_file(fmt::format("{}/{}.toml", kFolder, name_or_path)).string();
}

// A component is written out, or names one that comes with skylut, or a file beside this one.
ReadComponent read_listed_component(const Context& context, const TomlReader& reader, const std::string& file,
                                    std::optional<double> humidity_percent) {
  if (!reader.has("particles")) return read_component(reader, {"number_per_cm3"}, humidity_percent);
  reader.allow_only({"particles", "number_per_cm3"});
  const std::string name = reader.text("particles");
  std::string path;
  if (is_path(name)) {
    const std::filesystem::path beside = std::filesystem::path(file).parent_path() / name;
    if (!std::filesystem::is_regular_file(beside))
      reader.refuse("particles", fmt::format("'{}': no such file", beside.string()));
    path = beside.string();
  } else {
    const std::string folder = fmt::format("{}/components", kFolder);
    const std::vector<std::string> names = names_in(context, folder);
    if (std::find(names.begin(), names.end(), name) == names.end())
      reader.refuse("particles",
                    fmt::format("'{}': unknown; expected {}, or a .toml file", name, fmt::join(names, ", ")));
    path = context.data_file(fmt::format("{}/{}.toml", folder, name)).string();
  }
  const toml::table table = TomlReader::parse(path);
  ReadComponent read = read_component(TomlReader(table, path, ""), {}, humidity_percent);
  read.component.file = path;
  return read;
}

std::vector<AerosolComponent> read_components(const Context& context, const TomlReader& reader,
                                              const std::string& file, std::optional<double> humidity_percent,
                                              bool& takes_up_water) {
  std::vector<AerosolComponent> components;
  double particles = 0.0;
  for (const TomlReader& listed : reader.tables("component")) {
    ReadComponent read = read_listed_component(context, listed, file, humidity_percent);
    takes_up_water = takes_up_water || read.takes_up_water;
    read.component.number_per_cm3 = listed.number("number_per_cm3");
    if (!(read.component.number_per_cm3 >= 0.0))
      listed.refuse("number_per_cm3",
                    fmt::format("is {}; must not be negative", read.component.number_per_cm3));
    particles += read.component.number_per_cm3;
    components.push_back(std::move(read.component));
  }
  if (particles <= 0.0) reader.refuse("component", "number_per_cm3 must not be 0 for all components");
  return components;
}

GivenOptics read_optics(const TomlReader& reader) {
  reader.allow_only({"angstrom_exponent", "wavelength_nm", "single_scattering_albedo", "asymmetry"});
  GivenOptics optics;
  optics.angstrom_exponent = reader.number("angstrom_exponent");
  if (const Range& range = domain::kAngstromExponent; !range.holds(optics.angstrom_exponent))
    reader.refuse("angstrom_exponent", fmt::format("is {}; must lie within {} to {}",
                                                   optics.angstrom_exponent, range.lowest, range.highest));
  optics.wavelength_nm = reader.numbers("wavelength_nm");
  optics.single_scattering_albedo = reader.numbers("single_scattering_albedo");
  optics.asymmetry = reader.numbers("asymmetry");
  const std::size_t count = optics.wavelength_nm.size();
  for (const auto& [key, values] : {std::pair{"single_scattering_albedo", &optics.single_scattering_albedo},
                                    {"asymmetry", &optics.asymmetry}})
    if (values->size() != count)
      reader.refuse(
          key, fmt::format("has {} values; must have {}, one for every wavelength", values->size(), count));
  for (std::size_t i = 0; i < count; ++i) {
    if (!(optics.wavelength_nm[i] > (i == 0 ? 0.0 : optics.wavelength_nm[i - 1])))
      reader.refuse("wavelength_nm", i, optics.wavelength_nm[i],
                    "must be greater than the one before, in nm");
    if (!(optics.single_scattering_albedo[i] >= 0.0 && optics.single_scattering_albedo[i] <= 1.0))
      reader.refuse("single_scattering_albedo", i, optics.single_scattering_albedo[i],
                    "must lie within 0 to 1");
    if (!(std::abs(optics.asymmetry[i]) < 1.0))
      reader.refuse("asymmetry", i, optics.asymmetry[i], "must lie between -1 and 1");
  }
  return optics;
}

void read_shape(const TomlReader& reader, AerosolDescription& aerosol) {
  reader.allow_only({"source", "mixed_layer_km", "scale_height_km", "altitude_km", "relative_extinction"});
  AerosolShape& shape = aerosol.shape;
  if (reader.has("source")) aerosol.shape_source = reader.text("source");
  if (reader.has("altitude_km")) {
    shape.altitude_km = reader.numbers("altitude_km");
    shape.relative_extinction = reader.numbers("relative_extinction");
    for (const char* key : {"mixed_layer_km", "scale_height_km"})
      if (reader.has(key)) reader.refuse(key, "must not be given together with altitude_km");
    return;
  }
  shape.haze_scale_height_km = reader.number("scale_height_km");
  if (reader.has("mixed_layer_km")) shape.mixed_layer_km = reader.number("mixed_layer_km");
}

void read_stratosphere(const Context& context, const TomlReader& reader, AerosolDescription& aerosol) {
  reader.allow_only({"aod500", "centre_km", "width_km", "aerosol"});
  AerosolShape& shape = aerosol.shape;
  if (reader.has("aod500")) shape.stratospheric_aod500 = reader.number("aod500");
  if (reader.has("centre_km")) shape.stratospheric_centre_km = reader.number("centre_km");
  if (reader.has("width_km")) shape.stratospheric_width_km = reader.number("width_km");
  if (!reader.has("aerosol")) return;
  aerosol.stratosphere = reader.text("aerosol");
  const std::vector<std::string> names = aerosol_names(context);
  if (aerosol.stratosphere == aerosol.name)
    aerosol.stratosphere.clear();
  else if (std::find(names.begin(), names.end(), aerosol.stratosphere) == names.end())
    reader.refuse("aerosol", fmt::format("'{}': must be one of {}{}", aerosol.stratosphere,
                                         fmt::join(names, ", "), suggested(aerosol.stratosphere, names)));
}

}  // namespace

AerosolDescription load_aerosol_description(const Context& context, const std::string& name_or_path,
                                            std::optional<double> humidity_percent) {
  const std::string path = file_of(context, name_or_path);
  const toml::table table = TomlReader::parse(path);
  const TomlReader reader(table, path, "");
  reader.allow_only(
      {"name", "description", "source", "humidity_percent", "component", "optics", "shape", "stratosphere"});
  AerosolDescription aerosol;
  aerosol.file = path;
  aerosol.name = reader.text("name");
  aerosol.description = reader.text("description");
  aerosol.source = reader.text("source");
  if (reader.has("humidity_percent")) aerosol.humidity_percent = reader.number("humidity_percent");
  if (humidity_percent) aerosol.humidity_percent = humidity_percent;

  if (reader.has("component") == reader.has("optics"))
    reader.refuse(reader.has("optics") ? "optics" : "component",
                  "one of [[component]] (particles) and [optics] must be given");
  bool takes_up_water = false;
  if (reader.has("component"))
    aerosol.components = read_components(context, reader, path, aerosol.humidity_percent, takes_up_water);
  else
    aerosol.optics = read_optics(reader.table("optics"));
  if (humidity_percent && !takes_up_water)
    throw InputError("humidity {} %: must not be given for '{}', none of whose particles takes up water",
                     *humidity_percent, aerosol.name);
  if (!takes_up_water) aerosol.humidity_percent.reset();

  if (reader.has("shape")) read_shape(reader.table("shape"), aerosol);
  if (reader.has("stratosphere")) read_stratosphere(context, reader.table("stratosphere"), aerosol);
  try {
    aerosol.shape.validate();
  } catch (const InputError& error) {
    throw InputError("{}: {}", path, error.what());
  }
  return aerosol;
}

std::vector<std::string> aerosol_names(const Context& context) { return names_in(context, kFolder); }

}  // namespace skylut
