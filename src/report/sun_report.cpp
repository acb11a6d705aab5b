#include "skylut/report/sun_report.hpp"

#include <fmt/format.h>

namespace skylut {

namespace {

std::string line(const char* what, const std::vector<double>& irradiance, const SunIrradiance& sun) {
  if (irradiance.empty()) return {};
  return fmt::format("  {:<20} {:10.3f} W/m2 {:11.0f} lux\n", what,
                     broadband_W_m2(irradiance, sun.wavelengths),
                     illuminance_lux(irradiance, sun.luminous_weight));
}

}  // namespace

std::string sun_sums_text(const SunIrradiance& sun) {
  const double half_nm = 0.5 * sun.wavelengths.step_nm();
  return fmt::format("sums over {}-{} nm\n", sun.wavelengths.first_nm() - half_nm,
                     sun.wavelengths.last_nm() + half_nm) +
         line("direct normal", sun.direct_normal, sun) +
         line("circumsolar normal", sun.circumsolar_normal, sun) +
         line("diffuse horizontal", sun.diffuse_horizontal, sun) +
         line("global horizontal", sun.global_horizontal(), sun) +
         line("extraterrestrial", sun.extraterrestrial, sun);
}

std::string sun_spectrum_text(const SunIrradiance& sun) {
  constexpr std::size_t kMostLines = 21;
  const std::vector<double> global = sun.global_horizontal();
  std::string text = fmt::format("{:>8} {:>9}", "nm", "direct");
  if (!global.empty()) text += fmt::format(" {:>9} {:>9}", "diffuse", "global");
  for (const ConstituentTransmittance& constituent : sun.transmittance)
    text += fmt::format(" {:>9}", constituent.name);
  text += "   (W m-2 nm-1; transmittances)\n";
  const std::size_t stride = (sun.wavelengths.size() + kMostLines - 1) / kMostLines;
  for (std::size_t i = 0; i < sun.wavelengths.size(); i += stride) {
    text += fmt::format("{:8g} {:9.5f}", sun.wavelengths[i], sun.direct_normal[i]);
    if (!global.empty()) text += fmt::format(" {:9.5f} {:9.5f}", sun.diffuse_horizontal[i], global[i]);
    for (const ConstituentTransmittance& constituent : sun.transmittance)
      text += fmt::format(" {:9.5f}", constituent.band_mean[i]);
    text += "\n";
  }
  return text;
}

}  // namespace skylut
