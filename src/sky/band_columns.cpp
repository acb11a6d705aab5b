#include "band_columns.hpp"

#include <utility>

namespace skylut {

BandColumns::BandColumns(const SkyScene& scene) : wavelengths_(scene.wavelengths.size()) {
  const Atmosphere& atmosphere = *scene.atmosphere;
  for (const Turbidity& turbidity : scene.turbidities) {
    const double aod500 = to_aod500(turbidity, atmosphere);
    for (std::size_t i = 0; i < scene.wavelengths.size(); ++i) {
      first.push_back(columns.size());
      const Band band{scene.wavelengths[i], scene.wavelengths.step_nm()};
      for (BandColumn& one : atmosphere.band_columns(band, aod500)) {
        columns.push_back(std::move(one.column));
        weights.push_back(one.weight);
      }
    }
  }
  first.push_back(columns.size());
}

}  // namespace skylut
