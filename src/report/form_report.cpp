#include "skylut/report/form_report.hpp"

#include <fmt/format.h>

#include <utility>

#include "skylut/models/preetham_model.hpp"

namespace skylut {

namespace {

using Json = nlohmann::ordered_json;

std::string range_text(const Range& range) {
  if (range.lowest == range.highest) return fmt::format("{}", range.lowest);
  return fmt::format("{}-{}", range.lowest, range.highest);
}

std::string domain_text(const ModelInfo& info) {
  std::string text = fmt::format("altitude {} km, {} {}", range_text(info.altitude_km),
                                 turbidity_kind_name(info.turbidity_kind), range_text(info.turbidity));
  if (info.albedo) text += fmt::format(", albedo {}", range_text(*info.albedo));
  return text + fmt::format(", sun {} deg from the zenith, views to {} deg\n",
                            range_text(info.sun_zenith_deg), info.view_zenith_deg.highest);
}

std::string error_text(const char* against, const Json& error) {
  const auto row = [&](const char* name, const char* key, double scale, const char* unit) {
    const Json& part = error.at(key);
    return fmt::format("  {:<18} {:>9.4g} {:>9.4g} {:>9.4g} {}\n", name,
                       scale * part.at("median").get<double>(), scale * part.at("p90").get<double>(),
                       scale * part.at("worst").get<double>(), unit);
  };
  const std::size_t skies = error.at("skies").get<std::size_t>();
  return fmt::format("against {} {}{}:  median, 90th percentile, worst sky\n", skies,
                     skies == 1 ? "sky" : "skies", against) +
         row("Y, RMS", "rms_Y_rel", 100.0, "%") +
         row("Y, worst direction", "worst_direction_Y_rel", 100.0, "%") + row("x, RMS", "rms_x", 1.0, "") +
         row("y, RMS", "rms_y", 1.0, "");
}

// The errors that the form `skylut` states by the sun's zenith angle.
std::string by_sun_text(const Json& error) {
  std::string text =
      "at held-out conditions: RMS of Y, median and worst sky; 99 of 100 directions; x, y, worst\n";
  for (const auto& [key, name] : {std::pair("sun_0_90", "sun 0-90"), std::pair("sun_90_92", "90-92"),
                                  std::pair("sun_92_96", "92-96")}) {
    const Json& of = error.at(key);
    if (of.at("skies").get<std::size_t>() == 0) continue;
    text +=
        fmt::format("  {:<9} {:>3} skies {:>7.2f} {:>6.2f} %  {:>6.2f} %  {:>7.4f}\n", name,
                    of.at("skies").get<std::size_t>(), 100.0 * of.at("rms_Y_rel_median").get<double>(),
                    100.0 * of.at("rms_Y_rel_worst").get<double>(),
                    100.0 * of.at("direction_Y_rel_p99").get<double>(), of.at("rms_xy_worst").get<double>());
  }
  return text;
}

std::string linear_text(double slope, double offset) {
  return fmt::format("{:>9.4f} T {:>+9.4f}", slope, offset);
}

std::string perez_text(const char* channel, const PreethamMatrices::Perez& ours,
                       const PreethamMatrices::Perez& published) {
  std::string text;
  for (std::size_t i = 0; i < ours.size(); ++i)
    text +=
        fmt::format("  {}_{}  {}   {}\n", kPerezNames[i], channel, linear_text(ours[i].slope, ours[i].offset),
                    linear_text(published[i].slope, published[i].offset));
  return text;
}

std::string zenith_text(const char* channel, const PreethamMatrices::Chromaticity& ours,
                        const PreethamMatrices::Chromaticity& published) {
  constexpr const char* kPowers[] = {"T^2", "T  ", "1  "};
  std::string text =
      fmt::format("{}_zenith: [T^2 T 1] M [t^3 t^2 t 1], t the sun's zenith angle in radians\n", channel);
  for (std::size_t row = 0; row < ours.size(); ++row)
    text += fmt::format("  {} {:>9.4f}{:>9.4f}{:>9.4f}{:>9.4f}   {:>9.4f}{:>9.4f}{:>9.4f}{:>9.4f}\n",
                        kPowers[row], ours[row][0], ours[row][1], ours[row][2], ours[row][3],
                        published[row][0], published[row][1], published[row][2], published[row][3]);
  return text;
}

std::string luminance_text(const PreethamMatrices::ZenithLuminance& z) {
  return fmt::format("  ({:.4f} T {:+.4f}) tan chi {:+.4f} T {:+.4f}, chi = ({:.5f} - T/{:.2f}) (pi - 2 t)\n",
                     z.tangent.slope, z.tangent.offset, z.rest.slope, z.rest.offset, z.chi_offset,
                     z.chi_divisor);
}

// Regenerated and published numbers side by side.
std::string preetham_text(const PreethamLevel& level) {
  const PreethamMatrices& ours = level.matrices;
  const PreethamMatrices& published = preetham1999_matrices();
  return fmt::format("\naltitude {} km: regenerated beside published\n", level.altitude_km) +
         perez_text("Y", ours.Y, published.Y) + perez_text("x", ours.x, published.x) +
         perez_text("y", ours.y, published.y) + "Y_zenith in kcd/m2, regenerated, then published\n" +
         luminance_text(ours.zenith_Y) + luminance_text(published.zenith_Y) +
         zenith_text("x", ours.zenith_x, published.zenith_x) +
         zenith_text("y", ours.zenith_y, published.zenith_y);
}

std::string side_text(const Json& side) {
  return fmt::format("{:>8.1f} {:>+8.1f} {:>8.4f} {:>8.4f}", 100.0 * side.at("rms_Y_rel").get<double>(),
                     100.0 * side.at("mean_Y_rel").get<double>(), side.at("rms_x").get<double>(),
                     side.at("rms_y").get<double>());
}

std::string beside_published_text(const Json& error) {
  std::string text =
      "\nagainst the skies of the fit, regenerated, then published: RMS and mean of Y in %, RMS of x, of y\n";
  for (const Json& row : error.at("by_turbidity"))
    text += fmt::format("  T {:<6} {}   {}\n", row.at("turbidity").get<double>(),
                        side_text(row.at("regenerated")), side_text(row.at("published")));
  for (const Json& row : error.at("by_sun"))
    text += fmt::format("  sun {:<4} {}   {}\n", row.at("sun_zenith_deg").get<double>(),
                        side_text(row.at("regenerated")), side_text(row.at("published")));
  return text;
}

}  // namespace

std::string form_text(const ModelFile& file) {
  std::string text = fmt::format("{}: {}\n{}", file.form, file.info.title, domain_text(file.info));
  if (file.error.contains("held_out")) text += error_text(" held back", file.error.at("held_out"));
  if (file.error.contains("sun_0_90")) text += by_sun_text(file.error);
  if (file.error.contains("fitted")) text += error_text(" that it was fitted to", file.error.at("fitted"));
  const std::unique_ptr<const SkyModel> model = make_model(file);
  if (const auto* const preetham = dynamic_cast<const PreethamModel*>(model.get()))
    for (const PreethamLevel& level : preetham->levels()) text += preetham_text(level);
  if (file.error.contains("beside_published"))
    text += beside_published_text(file.error.at("beside_published"));
  return text;
}

}  // namespace skylut
