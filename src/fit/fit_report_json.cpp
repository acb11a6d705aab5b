#include "skylut/fit/fit_report_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace skylut {

namespace {

using Json = nlohmann::ordered_json;

template <class Values>
Json by_coefficient(const Values& values) {
  Json json = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i) json[kPerezNames[i]] = values[i];
  return json;
}

}  // namespace

Json fit_report_json(const FitReport& report, Json worst_direction) {
  return {{"coefficients", by_coefficient(report.coefficients.values())},
          {"standard_errors", by_coefficient(report.standard_error)},
          {"determined", by_coefficient(report.determined)},
          {"at_bound", by_coefficient(report.at_bound)},
          {"rmse", report.rmse},
          {"worst_residual", report.worst_residual},
          {"worst_direction", std::move(worst_direction)},
          {"termination", to_string(report.termination)},
          {"message", report.message},
          {"cost", report.cost},
          {"iterations", report.iterations}};
}

}  // namespace skylut
