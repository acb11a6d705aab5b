#include "skylut/models/model_conditions.hpp"

#include "skylut/core/errors.hpp"

namespace skylut {

void require_within_domain(const ModelInfo& info, const SkyConditions& conditions) {
  if (conditions.turbidity.kind != info.turbidity_kind)
    throw InputError("turbidity of kind {}: must be the model's, {}",
                     turbidity_kind_name(conditions.turbidity.kind),
                     turbidity_kind_name(info.turbidity_kind));
  require_within("altitude", conditions.altitude_km, info.altitude_km);
  require_within("turbidity", conditions.turbidity.value, info.turbidity);
  if (info.albedo) require_within("albedo", conditions.albedo, *info.albedo);
  require_within("sun zenith angle", conditions.sun.zenith_deg, info.sun_zenith_deg);
}

void require_views(const ModelInfo& info, std::span<const Direction> views, std::size_t answers) {
  if (views.size() != answers)
    throw InputError("sky in {} directions into {} values: must be as many", views.size(), answers);
  for (const Direction& view : views)
    require_within("view zenith angle", view.zenith_deg, info.view_zenith_deg);
}

}  // namespace skylut
