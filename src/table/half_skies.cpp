#include "half_skies.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/directions.hpp"

namespace skylut::table_detail {

namespace {

constexpr double kImpossible = 1e5;  // of a direction; possible ones have up to 400
constexpr std::array kZeniths_deg{10.0, 22.5, 35.0, 45.0, 55.0, 67.5, 78.0, 85.0, 88.0, 89.5, 90.0};
constexpr std::array kAzimuths_deg{0.0, 2.0, 10.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0};
static_assert(kImpossible / (kZeniths_deg.size() * kAzimuths_deg.size() + 1.0) > kImpossibleHalf);

}  // namespace

FormulaDome::FormulaDome(double sun_zenith_rad) : sun_zenith_rad_(sun_zenith_rad) {
  const Direction sun{sun_zenith_rad * kDegreesPerRadian, 0.0};
  rings_.push_back({1.0, {sun_zenith_rad}});
  for (const double zenith_deg : kZeniths_deg) {
    Ring& ring =
        rings_.emplace_back(Ring{zenith_deg == 90.0 ? 0.0 : std::cos(zenith_deg * kRadiansPerDegree), {}});
    for (const double azimuth_deg : kAzimuths_deg)
      ring.gamma_rad.push_back(angle_between({zenith_deg, azimuth_deg}, sun));
  }
}

std::vector<double> FormulaDome::relative(const PerezCoefficients& k) const {
  const auto scattering = [&k](double gamma_rad) {
    const double cosine = std::cos(gamma_rad);
    return 1.0 + k.C * std::exp(k.D * gamma_rad) + k.E * cosine * cosine;
  };
  const double scale = 1.0 / ((1.0 + k.A * std::exp(k.B)) * scattering(sun_zenith_rad_));
  std::vector<double> values;
  for (const Ring& ring : rings_) {
    const double gradation = ring.cos_zenith > 0.0 ? 1.0 + k.A * std::exp(k.B / ring.cos_zenith) : 1.0;
    for (const double gamma_rad : ring.gamma_rad) values.push_back(scale * gradation * scattering(gamma_rad));
  }
  return values;
}

double half_misfit(const FormulaDome& half, const PerezCoefficients& one, const std::vector<double>& ln_one,
                   const PerezCoefficients& other, const std::vector<double>& ln_other, double limit) {
  const std::vector<double> values =
      half.relative({0.5 * (one.A + other.A), 0.5 * (one.B + other.B), 0.5 * (one.C + other.C),
                     0.5 * (one.D + other.D), 0.5 * (one.E + other.E)});
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = values[i] > 0.0 ? std::log(values[i]) - 0.5 * (ln_one[i] + ln_other[i]) : limit + 1.0;
    sum += std::abs(off) <= limit ? off * off : kImpossible;  // not a number: impossible, too
  }
  return sum / static_cast<double>(values.size());
}

}  // namespace skylut::table_detail
