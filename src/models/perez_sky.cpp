#include "skylut/models/perez_sky.hpp"

#include <algorithm>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

double perez_zenith_deg(const Direction& view, double horizon_zenith_deg, double largest_B) {
  require_within("view zenith angle", view.zenith_deg, {0.0, horizon_zenith_deg, "deg"});
  const double zenith_deg = std::min(view.zenith_deg * (90.0 / horizon_zenith_deg), 90.0);
  if (zenith_deg == 90.0 && largest_B >= 0.0)
    throw InputError(
        "view at the horizon: Perez coefficient B = {}: must be below 0, or the sky is infinite there",
        largest_B);
  return zenith_deg;
}

void PerezSky::colour(std::span<const Direction> views, std::span<Yxy> colours) const {
  if (views.size() != colours.size())
    throw InputError("sky in {} directions into {} colours: must be as many", views.size(), colours.size());
  const double largest_B = std::max({coefficients_.Y.B, coefficients_.x.B, coefficients_.y.B});
  for (std::size_t i = 0; i < views.size(); ++i) {
    const double zenith_deg = perez_zenith_deg(views[i], horizon_zenith_deg_, largest_B);
    colours[i] =
        perez_sky(coefficients_.Y, coefficients_.x, coefficients_.y, zenith_, zenith_deg * kRadiansPerDegree,
                  angle_between(views[i], sun_), sun_.zenith_deg * kRadiansPerDegree);
  }
}

}  // namespace skylut
