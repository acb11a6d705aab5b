#include "skylut/models/perez_sky.hpp"

#include <algorithm>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

constexpr Range kViewZenith_deg{0.0, 90.0, "deg"};

}  // namespace

void require_in_perez_dome(const Direction& view, double largest_B) {
  require_within("view zenith angle", view.zenith_deg, kViewZenith_deg);
  if (view.zenith_deg == kViewZenith_deg.highest && largest_B >= 0.0)
    throw InputError(
        "view at the horizon: Perez coefficient B = {}: must be below 0, or the sky is infinite there",
        largest_B);
}

void PerezSky::colour(std::span<const Direction> views, std::span<Yxy> colours) const {
  if (views.size() != colours.size())
    throw InputError("sky in {} directions into {} colours: must be as many", views.size(), colours.size());
  const double largest_B = std::max({coefficients_.Y.B, coefficients_.x.B, coefficients_.y.B});
  for (std::size_t i = 0; i < views.size(); ++i) {
    require_in_perez_dome(views[i], largest_B);
    colours[i] = perez_sky(coefficients_.Y, coefficients_.x, coefficients_.y, zenith_,
                           views[i].zenith_deg * kRadiansPerDegree, angle_between(views[i], sun_),
                           sun_.zenith_deg * kRadiansPerDegree);
  }
}

}  // namespace skylut
