#include "skylut/report/fit_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: an error that the data do not limit is null.
Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json channel_json(const FitReport& report, const FittedSky& fitted) {
  const std::array<double, 5> values = report.coefficients.values();
  Json coefficients = Json::object();
  Json errors = Json::object();
  Json determined = Json::object();
  Json at_bound = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i) {
    coefficients[kPerezNames[i]] = values[i];
    errors[kPerezNames[i]] = finite_or_null(report.standard_error[i]);
    determined[kPerezNames[i]] = report.determined[i];
    at_bound[kPerezNames[i]] = report.at_bound[i];
  }
  const SkyCsvRow& worst = fitted.sky.rows[report.worst_direction];
  Json place = {{"line", worst.line}, {"zenith_deg", worst.zenith_deg}};
  if (worst.azimuth_deg) place["azimuth_deg"] = *worst.azimuth_deg;
  place["gamma_deg"] = fitted.views[report.worst_direction].gamma_rad * kDegreesPerRadian;
  return {{"coefficients", coefficients},
          {"standard_errors", errors},
          {"determined", determined},
          {"at_bound", at_bound},
          {"zenith", report.zenith_value},
          {"rmse", report.rmse},
          {"worst_residual", report.worst_residual},
          {"worst_direction", place},
          {"cost", report.cost},
          {"termination", to_string(report.termination)},
          {"message", report.message},
          {"iterations", report.iterations}};
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

std::string fit_json(const FittedSky& fitted) {
  const Json json = {{"format", "skylut fit"},
                     {"format_version", 1},
                     {"file", std::filesystem::path(fitted.file).filename().string()},
                     {"directions", fitted.views.size()},
                     {"sun_zenith_deg", fitted.sun_zenith_deg},
                     {"weights", fitted.weights},
                     {"residuals", {{"Y", "relative"}, {"x", "absolute"}, {"y", "absolute"}}},
                     {"Y", channel_json(fitted.fit.Y, fitted)},
                     {"x", channel_json(fitted.fit.x, fitted)},
                     {"y", channel_json(fitted.fit.y, fitted)}};
  return json.dump(1) + "\n";
}

}  // namespace skylut
