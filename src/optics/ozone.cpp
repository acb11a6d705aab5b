#include "skylut/optics/ozone.hpp"

#include "spectral_table.hpp"

namespace skylut {

CrossSection load_ozone_cross_section() {
  // As the file's header states.
  constexpr double kReference_K = 228.0;
  constexpr double kLowest_K = 203.0;
  constexpr double kHighest_K = 293.0;
  std::vector<CrossSection::Row> rows;
  for (const std::vector<double>& row : read_spectral_table("spectra/ozone_cross_section.csv", 4))
    rows.push_back({row[0], row[1], row[2], row[3]});
  return {std::move(rows), kReference_K, kLowest_K, kHighest_K};
}

}  // namespace skylut
