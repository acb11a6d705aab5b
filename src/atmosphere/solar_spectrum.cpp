#include "skylut/atmosphere/solar_spectrum.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"
#include "spectral_table.hpp"

namespace skylut {

namespace {

// More than anything the sun sends; a file in other units would hold greater numbers.
constexpr double kMost_W_m2_nm = 100.0;

constexpr std::array<std::pair<const char*, const char*>, 3> kSpectra{{
    {"astm-g173", "spectra/solar_astm_g173.csv"},
    {"gueymard2003", "spectra/solar_gueymard2003.csv"},
    {"kurucz1992", "spectra/solar_kurucz1992.csv"},
}};

}  // namespace

std::vector<std::string> SolarSpectrum::names() {
  std::vector<std::string> names;
  for (const auto& [name, file] : kSpectra) names.emplace_back(name);
  return names;
}

SolarSpectrum SolarSpectrum::load(const Context& context, const std::string& name_or_file) {
  if (names_a_csv_file(name_or_file)) {
    SolarSpectrum spectrum(read_spectral_curve(name_or_file, "irradiance_W_m2_nm", 0.0, kMost_W_m2_nm));
    spectrum.file_ = name_or_file;
    return spectrum;
  }
  for (const auto& [name, file] : kSpectra) {
    if (name_or_file != name) continue;
    std::vector<double> centre_nm;
    std::vector<double> mean;
    for (const std::vector<double>& row : read_spectral_table(context, file, 2)) {
      centre_nm.push_back(row[0]);
      mean.push_back(row[1]);
    }
    SolarSpectrum spectrum(centre_nm, mean);
    spectrum.file_ = context.data_file(file).string();
    return spectrum;
  }
  throw InputError("solar spectrum '{}': must be one of {}, or a .csv file{}", name_or_file,
                   fmt::join(names(), ", "), suggested(name_or_file, names()));
}

SolarSpectrum::SolarSpectrum(const std::vector<double>& centre_nm, const std::vector<double>& mean_W_m2_nm)
    : curve_(SpectralCurve::of_bands(centre_nm, mean_W_m2_nm)) {
  for (std::size_t i = 0; i < centre_nm.size(); ++i)
    if (!(mean_W_m2_nm[i] > 0.0))
      throw InputError("solar spectrum value {} at {} nm: must be greater than 0", mean_W_m2_nm[i],
                       centre_nm[i]);
}

double SolarSpectrum::integral_W_m2(double lower_nm, double upper_nm) const {
  if (!(lower_nm >= curve_.first_nm() && lower_nm <= upper_nm && upper_nm <= curve_.last_nm()))
    throw InputError("wavelengths {}-{} nm: must lie within {}-{} nm of the solar spectrum", lower_nm,
                     upper_nm, curve_.first_nm(), curve_.last_nm());
  return curve_.integral(lower_nm, upper_nm);
}

double SolarSpectrum::irradiance_W_m2_nm(double wavelength_nm, double band_nm) const {
  if (!(band_nm > 0.0)) throw InputError("band of {} nm: must be greater than 0", band_nm);
  if (!(wavelength_nm >= curve_.first_nm() && wavelength_nm <= curve_.last_nm()))
    throw InputError("wavelength {} nm: must lie within {}-{} nm of the solar spectrum", wavelength_nm,
                     curve_.first_nm(), curve_.last_nm());
  const double lower_nm = wavelength_nm - 0.5 * band_nm;
  const double upper_nm = wavelength_nm + 0.5 * band_nm;
  if (lower_nm >= curve_.first_nm() && upper_nm <= curve_.last_nm())
    return curve_.integral(lower_nm, upper_nm) / band_nm;
  const double first_nm = std::max(lower_nm, curve_.first_nm());
  const double last_nm = std::min(upper_nm, curve_.last_nm());
  return curve_.integral(first_nm, last_nm) / (last_nm - first_nm);
}

}  // namespace skylut
