#include "scene_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "number_options.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/text.hpp"
#include "skylut/site/sun.hpp"

namespace skylut::cli {

namespace {

Quality parse_quality(const std::string& text) {
  if (text == "draft") return Quality::draft;
  if (text == "default") return Quality::standard;
  if (text == "reference") return Quality::reference;
  throw InputError("--quality '{}': must be draft, default or reference", text);
}

}  // namespace

void SceneOptions::add_to(CLI::App& command) {
  command
      .add_option("--profile", profile_, "layered atmosphere: a name (skylut profile list) or a TOML file")
      ->capture_default_str()
      ->type_name("NAME|FILE")
      ->group("Air");
  add_air_to(command);

  const std::string sun = "Sun";
  command
      .add_option("--solar", solar_,
                  "spectrum above the air: astm-g173, gueymard2003, kurucz1992 or a CSV file")
      ->capture_default_str()
      ->type_name("NAME|FILE")
      ->group(sun);
  command.add_option("--date", date_, "sets the Earth-Sun distance: 2026-06-21 (default: the mean distance)")
      ->type_name("DATE")
      ->group(sun);

  const std::string computing = "Computing";
  command.add_option("--wavelengths-nm", wavelengths_, "first, last and step")
      ->capture_default_str()
      ->type_name("LO:HI:STEP")
      ->group(computing);
  command.add_option("--quality", quality_, "draft, default or reference")
      ->capture_default_str()
      ->type_name("NAME")
      ->group(computing);
  add_count(command, "--threads", threads_, 0, 1024, "0: one per core; changes no result")->group(computing);
}

void SceneOptions::add_air_to(CLI::App& command) {
  const std::string air = "Air";
  command
      .add_option_function<std::string>(
          "--turbidity-kind",
          [this](const std::string& text) {
            turbidity_kind_ = text;
            turbidity_kind_given_ = true;
          },
          "aod500, aod550, angstrom-beta, preetham-t or visibility-km")
      ->default_str(turbidity_kind_)
      ->type_name("KIND")
      ->group(air);
  command
      .add_option("--aerosol", aerosol_, "what the aerosol is: a name (skylut aerosol list) or a TOML file")
      ->capture_default_str()
      ->type_name("NAME|FILE")
      ->group(air);
  command
      .add_option_function<std::string>(
          "--humidity",
          [this](const std::string& text) {
            humidity_percent_ = parse_number("--humidity", text, {0.0, 99.0, "%"});
          },
          "relative humidity in percent that its particles have grown at; default: the aerosol's")
      ->type_name("NUMBER")
      ->group(air);
  command
      .add_option("--albedo", albedo_,
                  "of the ground, Lambertian: a number, grass, sand, snow, water, asphalt or a CSV file")
      ->capture_default_str()
      ->type_name("NUMBER|NAME|FILE")
      ->group(air);
  command
      .add_option_function<std::string>(
          "--ozone-du",
          [this](const std::string& text) {
            ozone_du_ = parse_number("--ozone-du", text, {0.0, 1000.0, "DU"});
          },
          "ozone column in Dobson units; default: the profile's")
      ->type_name("NUMBER")
      ->group(air);
  const auto add_gas = [&](const char* name, std::optional<double>& value, NumberRange range,
                           const char* text) {
    command
        .add_option_function<std::string>(
            name,
            [&value, name, range](const std::string& given) { value = parse_number(name, given, range); },
            text)
        ->type_name("NUMBER")
        ->group(air);
  };
  add_gas("--water-cm", water_cm_, {0.0, 20.0, "cm"}, "precipitable water in cm; default: the profile's");
  add_gas("--no2-du", no2_du_, {0.0, 100.0, "DU"},
          "nitrogen dioxide column in Dobson units; default: the profile's");
  add_gas("--pressure-hpa", surface_pressure_hPa_, {300.0, 1100.0, "hPa"},
          "pressure at the ground: scales the air and its oxygen at all heights; default: the profile's");

  const std::string place =
      "Place: gives gravity and the Earth's radius (default: standard gravity, 6371 km)";
  command.add_option("--latitude", latitude_, "geodetic, decimal degrees or as 48:51:24N")
      ->type_name("ANGLE")
      ->group(place);
  command.add_option("--longitude", longitude_, "decimal degrees or as 2d21'03\"E")
      ->type_name("ANGLE")
      ->group(place);
  add_number(command, "--height-m", height_m_, {-500.0, 9000.0, "m"}, "of the ground above the ellipsoid")
      ->group(place);
}

std::optional<Place> SceneOptions::place() const {
  if (latitude_.empty()) {
    if (!longitude_.empty() || height_m_ != 0.0)
      throw InputError("--{}: needs --latitude too", longitude_.empty() ? "height-m" : "longitude");
    return std::nullopt;
  }
  return parse_place(latitude_, longitude_.empty() ? "0" : longitude_, height_m_);
}

TurbidityKind SceneOptions::turbidity_kind() const { return parse_turbidity_kind(turbidity_kind_); }

SkyScene SceneOptions::scene(const Context& context) const {
  SkyScene scene;
  scene.wavelengths = WavelengthGrid::parse(wavelengths_);
  scene.atmosphere = std::make_shared<const Atmosphere>(build_atmosphere(context, atmosphere()));
  scene.place = place();
  scene.solar = solar_;
  if (has_date()) scene.sun_distance_au = earth_sun_distance_au(parse_date(date_));
  return scene;
}

AtmosphereDescription SceneOptions::atmosphere() const {
  AtmosphereDescription description;
  description.profile = profile_;
  description.aerosol = aerosol_;
  description.humidity_percent = humidity_percent_;
  description.ground_albedo = albedo_;
  description.ozone_du = ozone_du_;
  description.no2_du = no2_du_;
  description.water_cm = water_cm_;
  description.surface_pressure_hPa = surface_pressure_hPa_;
  description.place = place();
  return description;
}

TransferOptions SceneOptions::transfer() const {
  TransferOptions options;
  options.limits = limits_of(parse_quality(quality_));
  options.threads = threads_;
  return options;
}

std::string SceneOptions::command_line() const {
  std::string text = fmt::format("--profile {} --wavelengths-nm {} --quality {} --solar {}", profile_,
                                 wavelengths_, quality_, solar_);
  if (has_date()) text += fmt::format(" --date {}", date_);
  return text + " " + air_command_line();
}

std::string SceneOptions::air_command_line() const {
  std::string text = fmt::format("--turbidity-kind {} --albedo {}", turbidity_kind_, albedo_);
  text += fmt::format(" --aerosol {}", aerosol_);
  if (humidity_percent_) text += fmt::format(" --humidity {}", *humidity_percent_);
  if (ozone_du_) text += fmt::format(" --ozone-du {}", *ozone_du_);
  if (water_cm_) text += fmt::format(" --water-cm {}", *water_cm_);
  if (no2_du_) text += fmt::format(" --no2-du {}", *no2_du_);
  if (surface_pressure_hPa_) text += fmt::format(" --pressure-hpa {}", *surface_pressure_hPa_);
  if (const std::optional<Place> where = place())
    text += fmt::format(" --latitude {} --longitude {} --height-m {}", where->latitude_deg,
                        where->longitude_deg, where->height_m);
  return text;
}

Direction parse_sun(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() != 2)
    throw InputError("sun '{}': must be ZENITH:AZIMUTH in degrees, for example 45:90", text);
  return {parse_number("sun zenith angle", parts[0], {0.0, kLowestSun_deg, "deg"}),
          parse_number("sun azimuth", parts[1], {0.0, 360.0, "deg"})};
}

std::vector<Direction> parse_suns(const std::string& text) {
  std::vector<Direction> suns;
  for (const std::string& part : split(text, ',')) suns.push_back(parse_sun(part));
  return suns;
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
