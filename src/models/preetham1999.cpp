#include "skylut/models/preetham1999.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/models/preetham_matrices.hpp"

namespace skylut {

Yxy preetham1999_zenith_kcd_m2(double turbidity, double sun_zenith_rad) {
  return preetham1999_matrices().zenith_kcd_m2(turbidity, sun_zenith_rad);
}

const ModelInfo& Preetham1999::info() const {
  static const ModelInfo info{.name = "preetham1999",
                              .title = "Preetham, Shirley, Smits 1999",
                              .source = "doi:10.1145/311535.311545",
                              .quantities = "Y, x, y",
                              .altitude_km = {0.0, 0.0, "km"},
                              .turbidity_kind = TurbidityKind::preetham_t,
                              .turbidity = {2.0, 6.0, ""},
                              .sun_zenith_deg = {0.0, 90.0, "deg"},
                              .view_zenith_deg = {0.0, 90.0, "deg"}};
  return info;
}

std::unique_ptr<const Sky> Preetham1999::at(const SkyConditions& conditions) const {
  const double T = conditions.turbidity.value;
  if (conditions.turbidity.kind != info().turbidity_kind)
    throw InputError("Preetham 1999: turbidity of kind {}: must be preetham-t",
                     turbidity_kind_name(conditions.turbidity.kind));
  if (!(T >= 1.0) || !std::isfinite(T))
    throw InputError("Preetham 1999: turbidity T = {}: must be at least 1", T);
  require_within("Preetham 1999: altitude", conditions.altitude_km, info().altitude_km);
  require_within("Preetham 1999: sun zenith angle", conditions.sun.zenith_deg, info().sun_zenith_deg);
  Yxy zenith = preetham1999_zenith_kcd_m2(T, conditions.sun.zenith_deg * kRadiansPerDegree);
  zenith.Y *= 1000.0;
  return std::make_unique<const PerezSky>(preetham1999_coefficients(T), zenith, conditions.sun);
}

}  // namespace skylut
