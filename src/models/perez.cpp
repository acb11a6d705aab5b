#include "skylut/models/perez.hpp"

namespace skylut {

Yxy perez_sky(const PerezCoefficients& Y, const PerezCoefficients& x, const PerezCoefficients& y,
              const Yxy& zenith, double view_zenith_rad, double gamma_rad, double sun_zenith_rad) {
  return {zenith.Y * perez_relative(Y, view_zenith_rad, gamma_rad, sun_zenith_rad),
          zenith.x * perez_relative(x, view_zenith_rad, gamma_rad, sun_zenith_rad),
          zenith.y * perez_relative(y, view_zenith_rad, gamma_rad, sun_zenith_rad)};
}

}  // namespace skylut
