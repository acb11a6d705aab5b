#include "skylut/atmosphere/line_absorption.hpp"

#include <algorithm>
#include <utility>

#include "skylut/core/errors.hpp"
#include "spectral_table.hpp"

namespace skylut {

namespace {

LineAbsorption load(const Context& context, const char* file) {
  constexpr std::size_t kColumns = 3 + LineAbsorption::kCoefficients;
  std::vector<LineAbsorption::Row> rows;
  for (const std::vector<double>& cells : read_spectral_table(context, file, kColumns)) {
    LineAbsorption::Row row{cells[0], cells[1], cells[2], {}};
    std::copy(cells.begin() + 3, cells.end(), row.coefficient_m2.begin());
    rows.push_back(row);
  }
  return LineAbsorption(std::move(rows));
}

double mean_coefficient_m2(const LineAbsorption::Row& row) {
  double mean = 0.0;
  for (std::size_t i = 0; i < LineAbsorption::kCoefficients; ++i)
    mean += LineAbsorption::kWeights[i] * row.coefficient_m2[i];
  return mean;
}

}  // namespace

LineAbsorption::LineAbsorption(std::vector<Row> rows) : rows_(std::move(rows)) {
  for (std::size_t i = 1; i < rows_.size(); ++i)
    if (!(rows_[i].wavelength_nm > rows_[i - 1].wavelength_nm))
      throw InputError("line absorption at {} nm: must be greater than the one before, {} nm",
                       rows_[i].wavelength_nm, rows_[i - 1].wavelength_nm);
}

LineBand LineAbsorption::band(double wavelength_nm, double band_nm) const {
  const double lower_nm = wavelength_nm - 0.5 * band_nm;
  const double upper_nm = wavelength_nm + 0.5 * band_nm;
  LineBand band;
  double absorbing = 0.0;  // part of the band
  double strength = 0.0;
  for (const Row& row : rows_) {
    const double overlap_nm =
        std::min(upper_nm, row.wavelength_nm + 0.5) - std::max(lower_nm, row.wavelength_nm - 0.5);
    if (!(overlap_nm > 1e-9)) continue;
    const double part = overlap_nm / band_nm;
    absorbing += part;
    for (std::size_t i = 0; i < kCoefficients; ++i)
      band.sum.push_back({part * kWeights[i], row.coefficient_m2[i]});
    const double share = part * mean_coefficient_m2(row);
    strength += share;
    band.pressure_exponent += share * row.pressure_exponent;
    band.temperature_exponent += share * row.temperature_exponent;
  }
  if (strength > 0.0) {
    band.pressure_exponent /= strength;
    band.temperature_exponent /= strength;
  }
  if (absorbing < 1.0 - 1e-9) band.sum.push_back({1.0 - absorbing, 0.0});
  return band;
}

LineAbsorption load_water_lines(const Context& context) { return load(context, "spectra/water_lines.csv"); }

LineAbsorption load_oxygen_lines(const Context& context) { return load(context, "spectra/oxygen_lines.csv"); }

}  // namespace skylut
