#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace skylut {

struct Context;

/// How the sun's radiance falls from the centre of its disc to the limb, at one wavelength: a polynomial of
/// μ = cos(angle between the sun's surface normal and the line of sight), whose mean over the disc is 1.
/// μ = √(1 - r²) at the distance r from the centre, in radii.
struct LimbDarkeningLaw {
  std::array<double, 6> coefficient{};  ///< of μ⁰ … μ⁵

  double operator()(double mu) const {
    double value = 0.0;
    for (auto a = coefficient.rbegin(); a != coefficient.rend(); ++a) value = value * mu + *a;
    return value;
  }
};

/// Mean over the disc of Σ a_k μ^k, which is 2 ∫ Σ a_k μ^k μ dμ = Σ 2 a_k / (k + 2).
double disc_mean(const LimbDarkeningLaw& law);

/// The sun's limb darkening as it was observed from 303 to 1099 nm, in the continuum (Neckel & Labs 1994,
/// Solar Physics 153, 91, doi:10.1007/BF00712494; profiles/spectra/solar_limb_darkening.csv). Single scans
/// scatter by 1 % around their means. Between the 30 wavelengths straight lines; below 303.3 nm the first
/// one's law is held. Within spectral lines the sun darkens less towards the limb than its continuum, which
/// is not told apart.
class LimbDarkening {
 public:
  /// @throws WorkError   if the table is missing
  /// @throws InputError  "file:line: …" if the law there is not 1 at the centre, as it must be
  static LimbDarkening load(const Context& context);
  /// What it reads, for the provenance. @throws WorkError  if it is missing
  static std::filesystem::path file(const Context& context);

  /// @param wavelength_nm  [300, 1000]
  LimbDarkeningLaw at(double wavelength_nm) const;

 private:
  std::vector<double> wavelength_nm_;
  std::vector<LimbDarkeningLaw> law_;  // mean 1
};

}  // namespace skylut
