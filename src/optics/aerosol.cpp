#include "skylut/optics/aerosol.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

constexpr double kReferenceWavelength_nm = 500.0;

// Part of an exponential exp(-z/H), normalised on [0, top], below an altitude.
double exponential_below(double scale_height_km, double altitude_km, double top_km) {
  return std::expm1(-altitude_km / scale_height_km) / std::expm1(-top_km / scale_height_km);
}

// ∫₀^z of a Gaussian of unit area.
double gaussian_below(const AerosolShape& shape, double altitude_km) {
  const auto cumulative = [&](double z) {
    return 0.5 *
           std::erf((z - shape.stratospheric_centre_km) / (shape.stratospheric_width_km * std::sqrt(2.0)));
  };
  return cumulative(altitude_km) - cumulative(0.0);
}

double stratospheric_part(const AerosolShape& shape, double aod500) {
  return aod500 > shape.stratospheric_aod500 ? shape.stratospheric_aod500 / aod500 : 1.0;
}

double linear_held(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (at <= x.front()) return y.front();
  if (at >= x.back()) return y.back();
  const auto i = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

}  // namespace

double AerosolShape::part_between(double lower_km, double upper_km, double top_km, double aod500) const {
  const double stratospheric = stratospheric_part(*this, aod500);
  const double haze = exponential_below(haze_scale_height_km, upper_km, top_km) -
                      exponential_below(haze_scale_height_km, lower_km, top_km);
  const double layer =
      (gaussian_below(*this, upper_km) - gaussian_below(*this, lower_km)) / gaussian_below(*this, top_km);
  return stratospheric * layer + (1.0 - stratospheric) * haze;
}

double AerosolShape::density_per_km(double altitude_km, double top_km, double aod500) const {
  const double stratospheric = stratospheric_part(*this, aod500);
  const double haze = std::exp(-altitude_km / haze_scale_height_km) /
                      (-haze_scale_height_km * std::expm1(-top_km / haze_scale_height_km));
  const double distance = (altitude_km - stratospheric_centre_km) / stratospheric_width_km;
  const double layer = std::exp(-0.5 * distance * distance) /
                       (stratospheric_width_km * std::sqrt(2.0 * kPi) * gaussian_below(*this, top_km));
  return stratospheric * layer + (1.0 - stratospheric) * haze;
}

void AerosolOptics::validate() const {
  if (!(angstrom_exponent >= -1.0 && angstrom_exponent <= 4.0))
    throw InputError("Angstrom exponent {}: must lie within -1 to 4", angstrom_exponent);
  if (wavelength_nm.empty() || single_scattering_albedo.size() != wavelength_nm.size() ||
      asymmetry.size() != wavelength_nm.size())
    throw InputError(
        "aerosol with {} wavelengths, {} albedos, {} asymmetries: must have as many of each, at least 1",
        wavelength_nm.size(), single_scattering_albedo.size(), asymmetry.size());
  for (std::size_t i = 0; i < wavelength_nm.size(); ++i) {
    if (!(wavelength_nm[i] > (i == 0 ? 0.0 : wavelength_nm[i - 1])))
      throw InputError("aerosol wavelength {} nm: must be greater than the one before", wavelength_nm[i]);
    if (!(single_scattering_albedo[i] >= 0.0 && single_scattering_albedo[i] <= 1.0))
      throw InputError("aerosol single-scattering albedo {} at {} nm: must lie within 0-1",
                       single_scattering_albedo[i], wavelength_nm[i]);
    if (!(std::abs(asymmetry[i]) < 1.0))
      throw InputError("aerosol asymmetry {} at {} nm: must lie between -1 and 1", asymmetry[i],
                       wavelength_nm[i]);
  }
  if (!(shape.haze_scale_height_km >= 0.1 && shape.haze_scale_height_km <= 20.0))
    throw InputError("haze scale height {} km: must lie within 0.1-20 km", shape.haze_scale_height_km);
  if (!(shape.stratospheric_aod500 >= 0.0 && shape.stratospheric_aod500 <= 1.0))
    throw InputError("stratospheric aerosol optical depth {}: must lie within 0-1",
                     shape.stratospheric_aod500);
  if (!(shape.stratospheric_centre_km >= 5.0 && shape.stratospheric_centre_km <= 40.0))
    throw InputError("stratospheric aerosol altitude {} km: must lie within 5-40 km",
                     shape.stratospheric_centre_km);
  if (!(shape.stratospheric_width_km >= 0.5 && shape.stratospheric_width_km <= 10.0))
    throw InputError("stratospheric aerosol width {} km: must lie within 0.5-10 km",
                     shape.stratospheric_width_km);
}

double AerosolOptics::single_scattering_albedo_at(double at_nm) const {
  return linear_held(wavelength_nm, single_scattering_albedo, at_nm);
}

double AerosolOptics::asymmetry_at(double at_nm) const {
  return linear_held(wavelength_nm, asymmetry, at_nm);
}

std::shared_ptr<const PhaseFunction> AerosolOptics::phase_function(double at_nm) const {
  return std::make_shared<HenyeyGreensteinPhaseFunction>(asymmetry_at(at_nm));
}

double AerosolOptics::relative_depth(double at_nm) const {
  return std::pow(at_nm / kReferenceWavelength_nm, -angstrom_exponent);
}

}  // namespace skylut
