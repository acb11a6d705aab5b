#include "forward_peak_correction.hpp"

#include <cmath>

#include "single_scattering.hpp"
#include "skylut/core/constants.hpp"

namespace skylut::plane_parallel {
namespace {

/// Peaks with less of the scattering than this change no radiance by 1e-6.
constexpr double kNegligiblePeak = 1e-6;

/// Moments of the peak below this share of it are left out.
constexpr double kNegligibleMoment = 1e-5;
constexpr int kMostMoments = 10'000;

/// The truncated peak as the air above one depth has it.
struct Peak {
  double strength = 0.0;   ///< fω, mean
  Eigen::VectorXd series;  ///< (2l+1)(2 g_l - g_l²)
};

Peak mean_peak(const OpticalColumn& column, const ScaledMedium& medium, std::size_t boundary) {
  Peak peak;
  const double depth = medium.boundary_depth[boundary];
  if (depth == 0.0) return peak;
  double truncated = 0.0;
  std::vector<double> scattered(column.scatterers.size(), 0.0);
  for (std::size_t b = 0; b < boundary; ++b) {
    const Slice& slice = medium.slices[b];
    truncated += (1.0 - medium.optics[slice.optics].depth_factor) * slice.depth;
    for (std::size_t s = 0; s < scattered.size(); ++s)
      scattered[s] += medium.optics[slice.optics].scatterer_albedos[s] * slice.depth;
  }
  peak.strength = truncated / depth;
  if (peak.strength < kNegligiblePeak) return peak;
  std::vector<double> series;
  for (int l = 0; l < kMostMoments; ++l) {
    double moment = 1.0;
    if (l >= medium.streams) {
      double sum = 0.0;
      for (std::size_t s = 0; s < scattered.size(); ++s)
        sum += scattered[s] * column.scatterers[s].phase->moment(l);
      moment = sum / truncated;
      if (std::abs(moment) < kNegligibleMoment) break;
    }
    series.push_back((2.0 * l + 1.0) * moment * (2.0 - moment));
  }
  peak.series = Eigen::Map<const Eigen::VectorXd>(series.data(), static_cast<Eigen::Index>(series.size()));
  return peak;
}

double legendre_sum(const Eigen::VectorXd& series, double x) {
  double previous = 0.0;
  double current = 1.0;
  double sum = 0.0;
  for (Eigen::Index l = 0; l < series.size(); ++l) {
    sum += series[l] * current;
    const auto degree = static_cast<double>(l);
    const double next = ((2.0 * degree + 1.0) * x * current - degree * previous) / (degree + 1.0);
    previous = current;
    current = next;
  }
  return sum;
}

}  // namespace

double twice_scattered_path(double a, double b, double depth) {
  const double y = (b - a) * depth;
  if (std::abs(y) < 1e-2)  // Σ y^k / (k! (k+2)); the next term is below 1e-10
    return depth * depth * std::exp(-b * depth) * (0.5 + y * (1.0 / 3.0 + y * (0.125 + y / 30.0)));
  return depth * depth * (std::exp(-a * depth) * (y - 1.0) + std::exp(-b * depth)) / (y * y);
}

void correct_forward_peak(const OpticalColumn& column, const ScaledMedium& medium,
                          const PlaneParallelRequest& request, std::vector<double>& radiance) {
  std::size_t at = 0;
  for (std::size_t bound : medium.output_bounds) {
    const Peak peak = mean_peak(column, medium, bound);
    const double rate = (1.0 - peak.strength) / request.cos_sun_zenith;  // 1/μ0'
    const double scale = peak.strength * peak.strength / (1.0 - peak.strength) / (4.0 * kPi);
    for (const PlaneDirection& direction : request.directions) {
      if (direction.cos_view < 0.0 && peak.strength >= kNegligiblePeak) {
        const double mu = -direction.cos_view;
        const double path = twice_scattered_path(rate, 1.0 / mu, medium.boundary_depth[bound]) * rate / mu;
        const double angle =
            cos_scattering_angle(direction.cos_view, request.cos_sun_zenith, direction.relative_azimuth_rad);
        radiance[at] -= scale * path * legendre_sum(peak.series, angle);
      }
      ++at;
    }
  }
}

}  // namespace skylut::plane_parallel
