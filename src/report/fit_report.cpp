#include "skylut/report/fit_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "skylut/core/constants.hpp"
#include "skylut/fit/fit_report_json.hpp"

namespace skylut {

namespace {

using Json = nlohmann::ordered_json;

Json channel_json(const FitReport& report, const FittedSky& fitted) {
  const SkyCsvRow& worst = fitted.sky.rows[report.worst_direction];
  Json place{{"line", worst.line}, {"zenith_deg", worst.zenith_deg}};
  if (worst.azimuth_deg) place["azimuth_deg"] = *worst.azimuth_deg;
  place["gamma_deg"] = fitted.views[report.worst_direction].gamma_rad * kDegreesPerRadian;
  Json json = fit_report_json(report, std::move(place));
  json["zenith"] = report.zenith_value;
  return json;
}

std::string channel_text(const char* name, const FitReport& report, const FittedSky& fitted) {
  const std::array<double, 5> values = report.coefficients.values();
  std::string text = fmt::format("\n{}: zenith {:.6g}, RMSE {:.4g}{}\n", name, report.zenith_value,
                                 report.rmse, name[0] == 'Y' ? " of the value" : "");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const char* note = report.at_bound[i]     ? "on its bound"
                       : report.determined[i] ? ""
                                              : "not determined by the data";
    text += fmt::format("  {} {:>14.7g} +- {:<10.3g} {}\n", kPerezNames[i], values[i],
                        report.standard_error[i], note);
  }
  const SkyCsvRow& worst = fitted.sky.rows[report.worst_direction];
  text += fmt::format("  worst: {:+.4g} at zenith angle {:g} deg, {:.4g} deg from the sun (line {})\n",
                      report.worst_residual, worst.zenith_deg,
                      fitted.views[report.worst_direction].gamma_rad * kDegreesPerRadian, worst.line);
  return text + fmt::format("  {} after {} iterations\n", to_string(report.termination), report.iterations);
}

}  // namespace

std::string fit_text(const FittedSky& fitted) {
  return fmt::format("{}: {} directions, sun at zenith angle {:g} deg, {} weights\n", fitted.file,
                     fitted.views.size(), fitted.sun_zenith_deg, fitted.weights) +
         "v = v_zenith F(theta,gamma)/F(0,theta_sun), F = (1 + A exp(B/cos theta)) (1 + C exp(D gamma) + E "
         "cos^2 "
         "gamma)\n" +
         channel_text("Y", fitted.fit.Y, fitted) + channel_text("x", fitted.fit.x, fitted) +
         channel_text("y", fitted.fit.y, fitted);
}

std::string fit_json(const FittedSky& fitted, const Provenance& provenance) {
  Json json{{"format", "skylut fit"}, {"format_version", 1}};
  const Json how = provenance.json();
  for (const auto& [key, value] : how.items()) json[key] = value;
  json["file"] = std::filesystem::path(fitted.file).filename().string();
  json["directions"] = fitted.views.size();
  json["sun_zenith_deg"] = fitted.sun_zenith_deg;
  json["weights"] = fitted.weights;
  json["residuals"] = {{"Y", "relative"}, {"x", "absolute"}, {"y", "absolute"}};
  json["Y"] = channel_json(fitted.fit.Y, fitted);
  json["x"] = channel_json(fitted.fit.x, fitted);
  json["y"] = channel_json(fitted.fit.y, fitted);
  return json.dump(1) + "\n";
}

}  // namespace skylut
