#include "skylut/atmosphere/absorbing_gas.hpp"

#include <algorithm>
#include <utility>

#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"

namespace skylut {

CrossSection::CrossSection(std::vector<Row> rows, double reference_temperature_K, double lowest_K,
                           double highest_K)
    : rows_(std::move(rows)),
      reference_temperature_K_(reference_temperature_K),
      lowest_K_(lowest_K),
      highest_K_(highest_K) {
  if (rows_.size() < 2)
    throw InputError("cross-section with {} wavelengths: must have at least 2", rows_.size());
  for (std::size_t i = 1; i < rows_.size(); ++i)
    if (!(rows_[i].wavelength_nm > rows_[i - 1].wavelength_nm))
      throw InputError("cross-section wavelength {} nm: must be greater than the one before, {} nm",
                       rows_[i].wavelength_nm, rows_[i - 1].wavelength_nm);
}

double CrossSection::at_m2(double wavelength_nm, double temperature_K) const {
  if (!(wavelength_nm >= rows_.front().wavelength_nm && wavelength_nm <= rows_.back().wavelength_nm))
    throw InputError("wavelength {} nm: must lie within {}-{} nm of the cross-section", wavelength_nm,
                     rows_.front().wavelength_nm, rows_.back().wavelength_nm);
  const std::size_t piece = piece_of(rows_, wavelength_nm, &Row::wavelength_nm);
  const Row& lower = rows_[piece];
  const Row& upper = rows_[piece + 1];
  const double part = (wavelength_nm - lower.wavelength_nm) / (upper.wavelength_nm - lower.wavelength_nm);
  const double t = std::clamp(temperature_K, lowest_K_, highest_K_) - reference_temperature_K_;
  const auto polynomial = [t](const Row& row) {
    return row.constant_m2 + t * (row.linear_m2_K + t * row.quadratic_m2_K2);
  };
  return std::max(0.0, (1.0 - part) * polynomial(lower) + part * polynomial(upper));
}

}  // namespace skylut
