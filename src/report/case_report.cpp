#include "skylut/report/case_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

namespace skylut {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRows = 40;

double total(const Json& layers, const char* key) {
  double sum = 0.0;
  for (const Json& layer : layers) sum += layer.value(key, 0.0);
  return sum;
}

std::string name_of(const Json& document) {
  const auto id = document.find("id");
  return id != document.end() && id->is_string() ? id->get<std::string>() : "case";
}

// Rows as they come; what is too much is counted.
class Rows {
 public:
  explicit Rows(std::string head) : text_(std::move(head)) {}
  void add(const std::string& row) {
    if (++count_ <= kMostRows) text_ += row;
  }
  std::string text() const {
    return count_ <= kMostRows ? text_ : text_ + fmt::format("  ... and {} more\n", count_ - kMostRows);
  }

 private:
  std::string text_;
  std::size_t count_ = 0;
};

std::string radiances_by_view(const Json& answer) {
  Rows rows(
      fmt::format("{:>10} {:>12} {:>14} {:>12}\n", "zenith/deg", "azimuth/deg", "radiance/sr-1", "std"));
  for (const Json& result : answer.at("results"))
    rows.add(fmt::format("{:10g} {:12g} {:14.6e} {:12.1e}\n", result.at("view_zenith_deg").get<double>(),
                         result.at("relative_azimuth_deg").get<double>(), result.at("radiance").get<double>(),
                         result.value("std", 0.0)));
  return rows.text();
}

std::string stokes_by_view(const Json& answer) {
  Rows rows(fmt::format("{:>10} {:>12} {:>14} {:>14} {:>14} {:>12}\n", "zenith/deg", "azimuth/deg", "I/sr-1",
                        "Q", "U", "std of I"));
  for (const Json& result : answer.at("results"))
    rows.add(fmt::format(
        "{:10g} {:12g} {:14.6e} {:14.6e} {:14.6e} {:12.1e}\n", result.at("view_zenith_deg").get<double>(),
        result.at("relative_azimuth_deg").get<double>(), result.at("radiance").get<double>(),
        result.at("stokes_q").get<double>(), result.at("stokes_u").get<double>(), result.value("std", 0.0)));
  return rows.text();
}

std::string radiances_by_depth(const Json& outputs) {
  Rows rows(fmt::format("{:>12} {:>10} {:>8} {:>14}\n", "tau", "cos view", "phi/deg", "radiance"));
  for (std::size_t depth = 0; depth < outputs.at("taus").size(); ++depth)
    for (std::size_t view = 0; view < outputs.at("umu").size(); ++view)
      for (std::size_t phi = 0; phi < outputs.at("phi_deg").size(); ++phi)
        rows.add(fmt::format("{:12g} {:10g} {:8g} {:14.6e}\n", outputs["taus"][depth].get<double>(),
                             outputs["umu"][view].get<double>(), outputs["phi_deg"][phi].get<double>(),
                             outputs["radiance"][depth][view][phi].get<double>()));
  return rows.text();
}

std::string fluxes(const Json& values) {
  return fmt::format("flux: direct {:.6e}, diffuse down {:.6e}, up {:.6e}\n",
                     values.at("direct_down").get<double>(), values.at("diffuse_down").get<double>(),
                     values.at("diffuse_up").get<double>());
}

}  // namespace

std::string case_text(const Json& document) {
  const Json& layers = document.at("layers");
  const double rayleigh = total(layers, "tau_rayleigh");
  const double aerosol = total(layers, "tau_aerosol");
  const double absorption = total(layers, "tau_absorption");
  std::string text =
      fmt::format("{}: {} spherical layers to {:g} km at {:g} nm\n", name_of(document), layers.size(),
                  document.at("levels_km").back().get<double>(), document.at("wavelength_nm").get<double>());
  text += fmt::format("optical depth {:.5g}: Rayleigh {:.5g}, aerosol {:.5g}, absorption by gases {:.5g}\n",
                      rayleigh + aerosol + absorption, rayleigh, aerosol, absorption);
  const double weight = document.at("absorption_term_weight").get<double>();
  text += weight < 1.0
              ? fmt::format("one term of the lines' absorption: {:.4g} % of the band\n", 100.0 * weight)
              : "no lines absorb: one term holds the whole band\n";
  return text +
         fmt::format("ground albedo {:.4g}, sun {:g} deg from the zenith, observer at {:g} km, {} views\n",
                     document.at("albedo").get<double>(), document.at("sun_zenith_deg").get<double>(),
                     document.at("observer_altitude_km").get<double>(), document.at("results").size());
}

std::string solved_case_text(const Json& answer) {
  const std::string head = fmt::format("{}: {}, {} layers", name_of(answer),
                                       answer.at("geometry").get<std::string>(), answer.at("layers").size());
  if (answer.contains("outputs"))
    return head + fmt::format(", {} streams\n", answer.value("streams_used", 0)) +
           radiances_by_depth(answer.at("outputs"));
  std::string text =
      head +
      fmt::format(", sun {:g} deg from the zenith, observer at {:g} km; per solar irradiance above the air\n",
                  answer.at("sun_zenith_deg").get<double>(),
                  answer.at("observer_altitude_km").get<double>()) +
      (answer.value("polarised", false) ? stokes_by_view(answer) : radiances_by_view(answer));
  if (answer.contains("fluxes")) text += fluxes(answer.at("fluxes"));
  return text;
}

}  // namespace skylut
