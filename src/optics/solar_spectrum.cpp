#include "skylut/optics/solar_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skylut/core/errors.hpp"
#include "spectral_table.hpp"

namespace skylut {

SolarSpectrum SolarSpectrum::load_default() {
  std::vector<double> centre_nm;
  std::vector<double> mean;
  for (const std::vector<double>& row : read_spectral_table("spectra/solar_astm_g173.csv", 2)) {
    centre_nm.push_back(row[0]);
    mean.push_back(row[1]);
  }
  return {std::move(centre_nm), std::move(mean)};
}

SolarSpectrum::SolarSpectrum(std::vector<double> centre_nm, std::vector<double> mean_W_m2_nm)
    : mean_W_m2_nm_(std::move(mean_W_m2_nm)) {
  if (centre_nm.size() < 2 || centre_nm.size() != mean_W_m2_nm_.size())
    throw InputError("solar spectrum of {} wavelengths and {} values: must have two or more of each, as many",
                     centre_nm.size(), mean_W_m2_nm_.size());
  step_nm_ = centre_nm[1] - centre_nm[0];
  first_edge_nm_ = centre_nm[0] - 0.5 * step_nm_;
  cumulative_W_m2_.push_back(0.0);
  for (std::size_t i = 0; i < centre_nm.size(); ++i) {
    const double expected_nm = centre_nm[0] + static_cast<double>(i) * step_nm_;
    if (!(step_nm_ > 0.0) || !(std::abs(centre_nm[i] - expected_nm) < 1e-6 * step_nm_))
      throw InputError("solar spectrum wavelength {} nm: must be {} nm, equal steps upwards", centre_nm[i],
                       expected_nm);
    if (!(mean_W_m2_nm_[i] > 0.0) || !std::isfinite(mean_W_m2_nm_[i]))
      throw InputError("solar spectrum value {} at {} nm: must be greater than 0", mean_W_m2_nm_[i],
                       centre_nm[i]);
    cumulative_W_m2_.push_back(cumulative_W_m2_.back() + step_nm_ * mean_W_m2_nm_[i]);
  }
}

double SolarSpectrum::integral_W_m2(double lower_nm, double upper_nm) const {
  const auto bands = static_cast<double>(mean_W_m2_nm_.size());
  const double from = (lower_nm - first_edge_nm_) / step_nm_;
  const double to = (upper_nm - first_edge_nm_) / step_nm_;
  if (!(from >= 0.0 && from <= to && to <= bands))
    throw InputError("wavelengths {}-{} nm: must lie within {}-{} nm of the solar spectrum", lower_nm,
                     upper_nm, first_edge_nm_, first_edge_nm_ + bands * step_nm_);
  const auto cumulative = [&](double position) {
    const auto band = static_cast<std::size_t>(std::min(position, bands - 1.0));
    return cumulative_W_m2_[band] + (position - static_cast<double>(band)) * step_nm_ * mean_W_m2_nm_[band];
  };
  return cumulative(to) - cumulative(from);
}

double SolarSpectrum::irradiance_W_m2_nm(double wavelength_nm, double band_nm) const {
  if (!(band_nm > 0.0)) throw InputError("band of {} nm: must be greater than 0", band_nm);
  return integral_W_m2(wavelength_nm - 0.5 * band_nm, wavelength_nm + 0.5 * band_nm) / band_nm;
}

}  // namespace skylut
