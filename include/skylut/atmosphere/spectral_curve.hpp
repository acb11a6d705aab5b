#pragma once

#include <string>
#include <vector>

namespace skylut {

/// A quantity by wavelength whose integral over any band is exact. Either straight lines between points or
/// constant values of touching bands.
class SpectralCurve {
 public:
  /// Straight lines between points. @param wavelength_nm  at least two, ascending
  /// @throws InputError  wavelengths that do not ascend, a value that is not finite, unequal counts
  static SpectralCurve through_points(std::vector<double> wavelength_nm, const std::vector<double>& value);

  /// Means over bands that touch. @param centre_nm  at least two, ascending in equal steps
  /// @throws InputError  as above, or for unequal steps
  static SpectralCurve of_bands(const std::vector<double>& centre_nm, const std::vector<double>& mean);

  double first_nm() const { return edge_nm_.front(); }
  double last_nm() const { return edge_nm_.back(); }
  /// Edges of its pieces, ascending: the points it goes through, or the ends of its bands.
  const std::vector<double>& edges_nm() const { return edge_nm_; }
  double lowest() const;
  double highest() const;

  /// Value at one wavelength; at a step between bands, the upper band's.
  /// @throws InputError  outside [first_nm, last_nm]
  double at(double wavelength_nm) const;

  /// ∫ value dλ, value's unit times nm. @throws InputError  unless first <= lower <= upper <= last
  double integral(double lower_nm, double upper_nm) const;

 private:
  SpectralCurve() = default;
  std::size_t piece_of(double wavelength_nm) const;
  void require_inside(double lower_nm, double upper_nm) const;
  double integral_from_start(double wavelength_nm) const;

  std::vector<double> edge_nm_;         // of the pieces, one more than these
  std::vector<double> left_;            // value at the lower edge of each piece
  std::vector<double> right_;           // at its upper edge
  std::vector<double> start_integral_;  // up to the lower edge of each piece
};

/// Reads a curve through points from a CSV file with a column `wavelength_nm` and one of that name.
/// @throws InputError  as CsvTable::read, or naming the line with a value outside [lowest, highest] or a
///                     wavelength that does not ascend
SpectralCurve read_spectral_curve(const std::string& path, const std::string& column, double lowest,
                                  double highest);

/// A text that names a file, not something that comes with skylut: it ends in .csv or holds a slash.
bool names_a_csv_file(const std::string& text);

}  // namespace skylut
