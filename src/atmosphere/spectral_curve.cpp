#include "skylut/atmosphere/spectral_curve.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "skylut/core/csv.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"

namespace skylut {

namespace {

void check(const std::vector<double>& wavelength_nm, const std::vector<double>& value) {
  if (wavelength_nm.size() < 2 || wavelength_nm.size() != value.size())
    throw InputError("spectrum of {} wavelengths and {} values: must have two or more of each, as many",
                     wavelength_nm.size(), value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!std::isfinite(wavelength_nm[i]) || (i > 0 && !(wavelength_nm[i] > wavelength_nm[i - 1])))
      throw InputError("spectrum wavelength {} nm: must be greater than the one before", wavelength_nm[i]);
    if (!std::isfinite(value[i]))
      throw InputError("spectrum value {} at {} nm: must be finite", value[i], wavelength_nm[i]);
  }
}

}  // namespace

SpectralCurve SpectralCurve::through_points(std::vector<double> wavelength_nm,
                                            const std::vector<double>& value) {
  check(wavelength_nm, value);
  SpectralCurve curve;
  curve.edge_nm_ = std::move(wavelength_nm);
  double integral = 0.0;
  for (std::size_t i = 0; i + 1 < value.size(); ++i) {
    curve.left_.push_back(value[i]);
    curve.right_.push_back(value[i + 1]);
    curve.start_integral_.push_back(integral);
    integral += 0.5 * (value[i] + value[i + 1]) * (curve.edge_nm_[i + 1] - curve.edge_nm_[i]);
  }
  return curve;
}

SpectralCurve SpectralCurve::of_bands(const std::vector<double>& centre_nm, const std::vector<double>& mean) {
  check(centre_nm, mean);
  const double step_nm = centre_nm[1] - centre_nm[0];
  SpectralCurve curve;
  curve.edge_nm_.push_back(centre_nm[0] - 0.5 * step_nm);
  double integral = 0.0;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const double expected_nm = centre_nm[0] + static_cast<double>(i) * step_nm;
    if (!(std::abs(centre_nm[i] - expected_nm) < 1e-6 * step_nm))
      throw InputError("spectrum wavelength {} nm: must be {} nm, equal steps upwards", centre_nm[i],
                       expected_nm);
    curve.edge_nm_.push_back(expected_nm + 0.5 * step_nm);
    curve.left_.push_back(mean[i]);
    curve.right_.push_back(mean[i]);
    curve.start_integral_.push_back(integral);
    integral += mean[i] * step_nm;
  }
  return curve;
}

double SpectralCurve::lowest() const {
  return std::min(*std::min_element(left_.begin(), left_.end()),
                  *std::min_element(right_.begin(), right_.end()));
}

double SpectralCurve::highest() const {
  return std::max(*std::max_element(left_.begin(), left_.end()),
                  *std::max_element(right_.begin(), right_.end()));
}

void SpectralCurve::require_inside(double lower_nm, double upper_nm) const {
  if (!(lower_nm >= first_nm() && lower_nm <= upper_nm && upper_nm <= last_nm()))
    throw InputError("wavelengths {}-{} nm: must lie within {}-{} nm of the spectrum", lower_nm, upper_nm,
                     first_nm(), last_nm());
}

double SpectralCurve::at(double wavelength_nm) const {
  require_inside(wavelength_nm, wavelength_nm);
  const std::size_t piece = piece_of(edge_nm_, wavelength_nm);
  const double part = (wavelength_nm - edge_nm_[piece]) / (edge_nm_[piece + 1] - edge_nm_[piece]);
  return (1.0 - part) * left_[piece] + part * right_[piece];
}

double SpectralCurve::integral_from_start(double wavelength_nm) const {
  const std::size_t piece = piece_of(edge_nm_, wavelength_nm);
  const double width = wavelength_nm - edge_nm_[piece];
  const double slope = (right_[piece] - left_[piece]) / (edge_nm_[piece + 1] - edge_nm_[piece]);
  return start_integral_[piece] + width * (left_[piece] + 0.5 * slope * width);
}

double SpectralCurve::integral(double lower_nm, double upper_nm) const {
  require_inside(lower_nm, upper_nm);
  return integral_from_start(upper_nm) - integral_from_start(lower_nm);
}

SpectralCurve read_spectral_curve(const std::string& path, const std::string& column, double lowest,
                                  double highest) {
  const CsvTable table = CsvTable::read(path);
  const std::size_t at_wavelength = table.column("wavelength_nm");
  const std::size_t at_value = table.column(column);
  std::vector<double> wavelength_nm;
  std::vector<double> value;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    wavelength_nm.push_back(table.number(row, at_wavelength));
    value.push_back(table.number(row, at_value));
    if (row > 0 && !(wavelength_nm[row] > wavelength_nm[row - 1]))
      throw InputError("{}: wavelength {} nm: must be greater than the one before, {} nm", table.place(row),
                       wavelength_nm[row], wavelength_nm[row - 1]);
    if (!(value[row] >= lowest && value[row] <= highest))
      throw InputError("{}: {} {}: must lie within {} to {}", table.place(row), column, value[row], lowest,
                       highest);
  }
  if (value.size() < 2) throw InputError("{}: {} rows: must have two or more", path, value.size());
  return SpectralCurve::through_points(std::move(wavelength_nm), value);
}

bool names_a_csv_file(const std::string& text) {
  return text.find('/') != std::string::npos || std::string_view(text).ends_with(".csv");
}

}  // namespace skylut
