#pragma once

#include <string>
#include <vector>

namespace skylut {

/// Equally spaced wavelengths, both ends included. Valid within 300-1000 nm.
class WavelengthGrid {
 public:
  /// @throws InputError if first_nm > last_nm, step_nm <= 0, the range leaves 300-1000 nm,
  ///         or (last - first) is not a whole number of steps.
  WavelengthGrid(double first_nm, double last_nm, double step_nm);

  /// The default of the project: 380-780 nm in 5 nm steps, 81 wavelengths.
  static WavelengthGrid visible();

  /// Reads "LO:HI:STEP" in nm. @throws InputError naming the text.
  static WavelengthGrid parse(const std::string& text);

  double first_nm() const { return first_nm_; }
  double last_nm() const { return last_nm_; }
  double step_nm() const { return step_nm_; }
  std::size_t size() const { return size_; }
  double operator[](std::size_t i) const { return first_nm_ + static_cast<double>(i) * step_nm_; }
  std::vector<double> values_nm() const;

 private:
  double first_nm_;
  double last_nm_;
  double step_nm_;
  std::size_t size_;
};

}  // namespace skylut
