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

std::string plane_text(const SunIrradiance& sun) {
  if (!sun.plane) return {};
  return fmt::format("on a plane tilted by {} deg that faces azimuth {} deg\n", sun.plane->tilt_deg,
                     sun.plane->azimuth_deg) +
         line("direct", sun.plane_direct, sun) + line("sky", sun.plane_sky, sun) +
         line("from the ground", sun.plane_ground, sun) + line("all of it", sun.plane_global(), sun);
}

std::string colour_line(const char* what, const std::optional<LightColour>& light) {
  if (!light) return {};
  const std::string temperature =
      light->temperature ? fmt::format("{:.0f}", light->temperature->temperature_K) : "none";
  return fmt::format("  {:<22} {:7.4f} {:7.4f} {:>7} {:11.0f} {:9.0f} {:9.0f}\n", what, light->x, light->y,
                     temperature, light->rgb.r, light->rgb.g, light->rgb.b);
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
         line("extraterrestrial", sun.extraterrestrial, sun) + plane_text(sun);
}

std::string refracted_sun_text(const std::optional<RefractedSun>& sun) {
  if (!sun) return {};
  std::string text = fmt::format("refraction: true zenith angle {:.4f} deg, apparent {:.4f} deg",
                                 sun->true_zenith_deg, sun->apparent_zenith_deg);
  if (sun->true_zenith_deg > sun->last_zenith_deg) text += ", below the horizon";
  text += fmt::format("; lifted by {:.4f} deg (450 nm: {:.4f}, 650 nm: {:.4f})\n", sun->refraction_deg,
                      sun->blue_refraction_deg, sun->red_refraction_deg);
  if (sun->vertical_diameter_deg > 0.0)
    text += fmt::format("disc {:.4f} deg high, {:.4f} deg wide as it is seen\n", sun->vertical_diameter_deg,
                        sun->horizontal_diameter_deg);
  return text;
}

std::string sun_appearance_text(const SunAppearance& appearance) {
  std::string text = fmt::format("disc {:.4f} deg across", appearance.angular_diameter_deg);
  if (appearance.visible_part == 0.0)
    text += ", below the horizon";
  else if (appearance.visible_part < 1.0)
    text += fmt::format(", {:.1f} % of it above the horizon", 100.0 * appearance.visible_part);
  if (appearance.visible_part > 0.0)
    text += fmt::format(", {:.4g} cd/m2 on average", appearance.mean_luminance_cd_m2);
  text += "\n";
  if (!appearance.disc && !appearance.sky) return text;
  return text +
         fmt::format("{:<24} {:>7} {:>7} {:>7} {:>11} {:>9} {:>9}   (Rec. 709, linear, lux)\n", "colours",
                     "x", "y", "CCT/K", "R", "G", "B") +
         colour_line("sun, normal to it", appearance.disc) +
         colour_line("sky, on the horizontal", appearance.sky);
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
