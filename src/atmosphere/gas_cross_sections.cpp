#include "skylut/atmosphere/gas_cross_sections.hpp"

#include "spectral_table.hpp"

namespace skylut {

namespace {

CrossSection load_quadratic(const Context& context, const char* path, double reference_K, double lowest_K,
                            double highest_K) {
  std::vector<CrossSection::Row> rows;
  for (const std::vector<double>& row : read_spectral_table(context, path, 4))
    rows.push_back({row[0], row[1], row[2], row[3]});
  return {std::move(rows), reference_K, lowest_K, highest_K};
}

}  // namespace

// Temperatures as the files' headers state.
CrossSection load_ozone_cross_section(const Context& context) {
  return load_quadratic(context, "spectra/ozone_cross_section.csv", 228.0, 203.0, 293.0);
}

CrossSection load_nitrogen_dioxide_cross_section(const Context& context) {
  return load_quadratic(context, "spectra/nitrogen_dioxide_cross_section.csv", 243.0, 223.0, 293.0);
}

CrossSection load_oxygen_pair_cross_section(const Context& context) {
  constexpr double kMeasured_K = 296.0;
  std::vector<CrossSection::Row> rows;
  for (const std::vector<double>& row :
       read_spectral_table(context, "spectra/oxygen_pair_cross_section.csv", 2))
    rows.push_back({row[0], row[1], 0.0, 0.0});
  return {std::move(rows), kMeasured_K, kMeasured_K, kMeasured_K};
}

}  // namespace skylut
