#include "azimuth_series.hpp"

#include <algorithm>
#include <cmath>

namespace skylut::plane_parallel {
namespace {

/// The Fourier series ends when two modes in a row change no radiance by more than this share of it.
constexpr double kAzimuthConvergence = 1e-6;

}  // namespace

bool AzimuthSeries::add(int mode, const Eigen::MatrixXd& at_bounds,
                        const std::vector<std::size_t>& output_bounds) {
  std::vector<double>& radiance = result_.radiance;
  double largest = 0.0;
  for (double value : radiance) largest = std::max(largest, std::abs(value));
  const auto view_count = static_cast<Eigen::Index>(views_.cosines.size());
  double change = 0.0;
  std::size_t at = 0;
  for (std::size_t bound : output_bounds)
    for (std::size_t direction = 0; direction < request_.directions.size(); ++direction) {
      const PlaneDirection& towards = request_.directions[direction];
      const auto row = static_cast<Eigen::Index>(bound);
      const auto view = static_cast<Eigen::Index>(views_.of_direction[direction]);
      double part = at_bounds(row, view);
      const double cosine = std::cos(mode * towards.relative_azimuth_rad);
      radiance[at] += part * cosine;
      if (request_.polarised) {
        const double q = at_bounds(row, view_count + view);
        const double u = at_bounds(row, 2 * view_count + view);
        result_.stokes_q[at] += q * cosine;
        // U of what goes down is kept with its sign changed.
        result_.stokes_u[at] +=
            (towards.cos_view > 0.0 ? u : -u) * std::sin(mode * towards.relative_azimuth_rad);
        part = std::max({std::abs(part), std::abs(q), std::abs(u)});
      }
      // Radiances 1e-10 of the largest carry no information.
      change = std::max(change, std::abs(part) / (std::abs(radiance[at]) + 1e-10 * largest));
      ++at;
    }
  small_in_a_row_ = change < kAzimuthConvergence ? small_in_a_row_ + 1 : 0;
  return small_in_a_row_ >= 2;
}

}  // namespace skylut::plane_parallel
