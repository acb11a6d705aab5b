#include "skylut/core/wavelength_grid.hpp"

#include <charconv>
#include <cmath>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {
constexpr double kShortest_nm = 300.0;
constexpr double kLongest_nm = 1000.0;
}  // namespace

WavelengthGrid::WavelengthGrid(double first_nm, double last_nm, double step_nm)
    : first_nm_(first_nm), last_nm_(last_nm), step_nm_(step_nm) {
  if (!(step_nm > 0.0) || !std::isfinite(step_nm))
    throw InputError("wavelength step {} nm: must be greater than 0", step_nm);
  if (!(first_nm <= last_nm))
    throw InputError("wavelength range {}:{} nm is empty: the first must not exceed the last", first_nm,
                     last_nm);
  if (first_nm < kShortest_nm || last_nm > kLongest_nm)
    throw InputError("wavelength range {}:{} nm: must lie within {}-{} nm", first_nm, last_nm, kShortest_nm,
                     kLongest_nm);
  const double steps = (last_nm - first_nm) / step_nm;
  const double whole = std::round(steps);
  if (std::abs(steps - whole) > 1e-6 * (1.0 + whole))
    throw InputError("wavelength range {}:{} nm is not a whole number of {} nm steps", first_nm, last_nm,
                     step_nm);
  if (whole > 10000.0) throw InputError("wavelength step {} nm: gives more than 10000 wavelengths", step_nm);
  size_ = static_cast<std::size_t>(whole) + 1;
}

WavelengthGrid WavelengthGrid::visible() { return {380.0, 780.0, 5.0}; }

WavelengthGrid WavelengthGrid::parse(const std::string& text) {
  double part[3];
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto [stop, error] = std::from_chars(at, end, part[i]);
    const bool separated = i < 2 ? (stop != end && *stop == ':') : stop == end;
    if (error != std::errc{} || !separated)
      throw InputError("wavelengths '{}': expected LO:HI:STEP in nm, for example 380:780:5", text);
    at = stop + 1;
  }
  return {part[0], part[1], part[2]};
}

std::vector<double> WavelengthGrid::values_nm() const {
  std::vector<double> values(size_);
  for (std::size_t i = 0; i < size_; ++i) values[i] = (*this)[i];
  return values;
}

}  // namespace skylut
