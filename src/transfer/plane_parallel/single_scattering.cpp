#include "single_scattering.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "source_integration.hpp"

namespace skylut::plane_parallel {
namespace {

/// ∫ e^{-τ/μ0} e^{-|τ-τ_b|/μ} dτ/μ over each material, at every boundary: boundaries × materials.
Eigen::MatrixXd beam_integrals(const ScaledMedium& medium, double cos_view, double cos_sun) {
  const std::size_t count = medium.slices.size();
  const bool upward = cos_view > 0.0;
  const double mu = std::abs(cos_view);
  Eigen::MatrixXd integral = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(count + 1),
                                                   static_cast<Eigen::Index>(medium.optics.size()));
  for (std::size_t step = 0; step < count; ++step) {
    const std::size_t b = upward ? count - 1 - step : step;
    const Slice& slice = medium.slices[b];
    const auto from = static_cast<Eigen::Index>(upward ? b + 1 : b);
    const auto to = static_cast<Eigen::Index>(upward ? b : b + 1);
    integral.row(to) = integral.row(from) * std::exp(-slice.scaled_depth / mu);
    const double own = upward ? attenuated_towards_start(1.0 / cos_sun, mu, slice.scaled_depth)
                              : attenuated_towards_end(1.0 / cos_sun, mu, slice.scaled_depth);
    integral(to, static_cast<Eigen::Index>(slice.optics)) +=
        std::exp(-medium.boundary_scaled[b] / cos_sun) * own;
  }
  return integral;
}

}  // namespace

double cos_scattering_angle(double cos_view, double cos_sun, double azimuth) {
  // The beam travels with cosine -μ0.
  const double sines = std::sqrt((1.0 - cos_view * cos_view) * (1.0 - cos_sun * cos_sun));
  return std::clamp(-cos_view * cos_sun + sines * std::cos(azimuth), -1.0, 1.0);
}

std::vector<double> exact_single_scattering(const OpticalColumn& column, const ScaledMedium& medium,
                                            const PlaneParallelRequest& request, const ViewList& views) {
  const std::size_t directions = request.directions.size();
  std::vector<std::vector<std::size_t>> of_view(views.cosines.size());
  for (std::size_t i = 0; i < directions; ++i) of_view[views.of_direction[i]].push_back(i);
  std::vector<double> radiance(request.output_depths.size() * directions);
  Eigen::VectorXd scattering(static_cast<Eigen::Index>(medium.optics.size()));
  std::vector<double> phase(column.scatterers.size());
  for (std::size_t view = 0; view < views.cosines.size(); ++view) {
    const Eigen::MatrixXd integral = beam_integrals(medium, views.cosines[view], request.cos_sun_zenith);
    for (const std::size_t direction : of_view[view]) {
      const double angle = cos_scattering_angle(views.cosines[view], request.cos_sun_zenith,
                                                request.directions[direction].relative_azimuth_rad);
      for (std::size_t s = 0; s < phase.size(); ++s) phase[s] = column.scatterers[s].phase->value(angle);
      for (std::size_t i = 0; i < medium.optics.size(); ++i) {
        double sum = 0.0;
        for (std::size_t s = 0; s < phase.size(); ++s)
          sum += medium.optics[i].scatterer_albedos[s] * phase[s];
        scattering[static_cast<Eigen::Index>(i)] = sum / (4.0 * kPi * medium.optics[i].depth_factor);
      }
      for (std::size_t depth = 0; depth < request.output_depths.size(); ++depth)
        radiance[depth * directions + direction] =
            integral.row(static_cast<Eigen::Index>(medium.output_bounds[depth])).dot(scattering);
    }
  }
  return radiance;
}

}  // namespace skylut::plane_parallel
