#include "skylut/sky/limb_darkening.hpp"

#include <cmath>
#include <string>

#include "skylut/core/context.hpp"
#include "skylut/core/csv.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"

namespace skylut {

double disc_mean(const LimbDarkeningLaw& law) {
  double mean = 0.0;
  for (std::size_t k = 0; k < law.coefficient.size(); ++k)
    mean += 2.0 * law.coefficient[k] / (static_cast<double>(k) + 2.0);
  return mean;
}

std::filesystem::path LimbDarkening::file(const Context& context) {
  return context.data_file("spectra/solar_limb_darkening.csv");
}

LimbDarkening LimbDarkening::load(const Context& context) {
  constexpr double kPrintedDigits = 2.5e-5;  // six coefficients of five decimals
  const CsvTable table = CsvTable::read(file(context));
  const std::size_t wavelength = table.column("wavelength_nm");
  LimbDarkening darkening;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    LimbDarkeningLaw law;
    for (std::size_t k = 0; k < law.coefficient.size(); ++k)
      law.coefficient[k] = table.number(row, table.column("a" + std::to_string(k)));
    if (!(std::abs(law(1.0) - 1.0) <= kPrintedDigits))
      throw InputError("{}: coefficients sum to {:.5f}: must sum to 1", table.place(row), law(1.0));
    const double mean = disc_mean(law);
    for (double& coefficient : law.coefficient) coefficient /= mean;
    darkening.wavelength_nm_.push_back(table.number(row, wavelength));
    darkening.law_.push_back(law);
  }
  return darkening;
}

LimbDarkeningLaw LimbDarkening::at(double wavelength_nm) const {
  const Bracket between = held_bracket(wavelength_nm_, wavelength_nm);
  LimbDarkeningLaw law;
  for (std::size_t k = 0; k < law.coefficient.size(); ++k)
    law.coefficient[k] =
        linear(law_[between.below].coefficient[k], law_[between.above].coefficient[k], between.part);
  return law;
}

}  // namespace skylut
