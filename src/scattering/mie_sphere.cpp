#include "skylut/scattering/mie_sphere.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

using Complex = std::complex<double>;

// D_n(z) = d ln ψ_n(z) / dz for n = 0 … count [P2]. Downward, D_{n-1} = n/z - 1/(D_n + n/z), forgets its
// start once n has passed |z| from above; the turning region is some |z|^(1/3) wide.
std::vector<Complex> logarithmic_derivatives(Complex z, int count) {
  const double size = std::abs(z);
  const int start = std::max(count, static_cast<int>(size + 8.0 * std::cbrt(size))) + 16;
  std::vector<Complex> derivative(static_cast<std::size_t>(count) + 1);
  Complex at = 0.0;
  for (int n = start; n >= 1; --n) {
    const Complex order_over_z = static_cast<double>(n) / z;
    if (n <= count) derivative[static_cast<std::size_t>(n)] = at;
    at = order_over_z - 1.0 / (at + order_over_z);
  }
  derivative[0] = at;
  return derivative;
}

// Riccati-Bessel ψ_n(x) = x j_n(x), n = 0 … count [P3]. Upward recurrence as long as n < x, where it is
// stable; above, ratios ψ_n/ψ_{n-1} by downward recurrence, positive there.
std::vector<double> riccati_bessel(double x, int count) {
  const int turn = std::min(count, static_cast<int>(x));
  std::vector<double> psi(static_cast<std::size_t>(count) + 1);
  double before = std::cos(x);
  psi[0] = std::sin(x);
  for (int n = 1; n <= turn; ++n) {
    const auto i = static_cast<std::size_t>(n);
    psi[i] = (2.0 * n - 1.0) / x * psi[i - 1] - before;
    before = psi[i - 1];
  }
  std::vector<double> ratio(static_cast<std::size_t>(count) + 1);
  double at = 0.0;
  for (int n = std::max(count, static_cast<int>(x + 8.0 * std::cbrt(x))) + 16; n > turn; --n) {
    at = 1.0 / ((2.0 * n + 1.0) / x - at);
    if (n <= count) ratio[static_cast<std::size_t>(n)] = at;
  }
  for (int n = turn + 1; n <= count; ++n) {
    const auto i = static_cast<std::size_t>(n);
    psi[i] = ratio[i] * psi[i - 1];
  }
  return psi;
}

void check(double x, Complex m) {
  if (!(x >= 1e-6 && x <= 1e5)) throw InputError("size parameter {}: must lie within 1e-06 to 100000", x);
  if (!(m.real() >= 0.05 && m.real() <= 20.0))
    throw InputError("real part {} of the refractive index: must lie within 0.05-20", m.real());
  if (!(m.imag() >= 0.0 && m.imag() <= 20.0))
    throw InputError(
        "imaginary part {} of the refractive index: must lie within 0-20 (absorbing is positive)", m.imag());
  if (m == Complex(1.0))
    throw InputError(
        "refractive index 1: must differ from that of the medium, 1; such a sphere is invisible");
}

}  // namespace

int MieSphere::terms(double x) { return static_cast<int>(x + 4.6 * std::cbrt(x)) + 6; }

MieSphere::MieSphere(double size_parameter, Complex m) : size_parameter_(size_parameter) {
  check(size_parameter, m);
  const double x = size_parameter;
  const int count = terms(x);
  const std::vector<Complex> derivative = logarithmic_derivatives(m * x, count);
  const std::vector<double> psi = riccati_bessel(x, count);
  a_.reserve(static_cast<std::size_t>(count));
  b_.reserve(static_cast<std::size_t>(count));

  // ξ_n = ψ_n - i χ_n; χ grows with n, so that upward recurrence is stable throughout.
  double chi_before = -std::sin(x);
  double chi = std::cos(x);
  double extinction = 0.0;
  double scattering = 0.0;
  double forward = 0.0;
  for (int n = 1; n <= count; ++n) {
    const auto i = static_cast<std::size_t>(n);
    const double chi_next = (2.0 * n - 1.0) / x * chi - chi_before;
    chi_before = chi;
    chi = chi_next;
    const Complex xi_before(psi[i - 1], -chi_before);
    const Complex xi(psi[i], -chi);
    const Complex electric = derivative[i] / m + n / x;
    const Complex magnetic = derivative[i] * m + n / x;
    const Complex a = (electric * psi[i] - psi[i - 1]) / (electric * xi - xi_before);
    const Complex b = (magnetic * psi[i] - psi[i - 1]) / (magnetic * xi - xi_before);

    extinction += (2.0 * n + 1.0) * (a.real() + b.real());
    scattering += (2.0 * n + 1.0) * (std::norm(a) + std::norm(b));
    forward += (2.0 * n + 1.0) / (n * (n + 1.0)) * (a * std::conj(b)).real();
    if (n > 1)
      forward += (n - 1.0) * (n + 1.0) / n * (a_.back() * std::conj(a) + b_.back() * std::conj(b)).real();
    a_.push_back(a);
    b_.push_back(b);
  }
  q_ext_ = 2.0 / (x * x) * extinction;
  q_sca_ = 2.0 / (x * x) * scattering;
  asymmetry_ = 2.0 * forward / scattering;
}

MieSphere::Amplitudes MieSphere::amplitudes(double mu) const {
  // π_n and τ_n, upward [P4].
  Amplitudes sum;
  double pi_before = 0.0;
  double pi = 1.0;
  for (std::size_t i = 0; i < a_.size(); ++i) {
    const double n = static_cast<double>(i) + 1.0;
    const double tau = n * mu * pi - (n + 1.0) * pi_before;
    const double weight = (2.0 * n + 1.0) / (n * (n + 1.0));
    sum.s1 += weight * (a_[i] * pi + b_[i] * tau);
    sum.s2 += weight * (a_[i] * tau + b_[i] * pi);
    const double pi_next = ((2.0 * n + 1.0) * mu * pi - (n + 1.0) * pi_before) / n;
    pi_before = pi;
    pi = pi_next;
  }
  return sum;
}

double MieSphere::phase_function(double mu) const {
  const Amplitudes at = amplitudes(mu);
  return 2.0 * (std::norm(at.s1) + std::norm(at.s2)) / (size_parameter_ * size_parameter_ * q_sca_);
}

}  // namespace skylut
