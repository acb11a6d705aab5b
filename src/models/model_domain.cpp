#include "skylut/models/model_domain.hpp"

#include <fmt/format.h>

namespace skylut {

namespace {

struct Axis {
  std::string what;
  double value = 0.0;
  Range range;

  std::string unit() const { return *range.unit == '\0' ? "" : fmt::format(" {}", range.unit); }
};

std::vector<Axis> axes_of(const ModelInfo& info, const SkyConditions& conditions) {
  std::vector<Axis> axes{{"altitude", conditions.altitude_km, info.altitude_km},
                         {fmt::format("turbidity ({})", turbidity_kind_name(info.turbidity_kind)),
                          conditions.turbidity.value, info.turbidity},
                         {"sun zenith angle", conditions.sun.zenith_deg, info.sun_zenith_deg}};
  if (info.albedo) axes.push_back({"albedo", conditions.albedo, *info.albedo});
  return axes;
}

}  // namespace

std::vector<std::string> outside_domain(const ModelInfo& info, const SkyConditions& conditions) {
  std::vector<std::string> outside;
  for (const Axis& axis : axes_of(info, conditions))
    if (!axis.range.holds(axis.value))
      outside.push_back(fmt::format("{} {:.6g}{} ({:.6g} to {:.6g}{})", axis.what, axis.value, axis.unit(),
                                    axis.range.lowest, axis.range.highest, axis.unit()));
  return outside;
}

}  // namespace skylut
