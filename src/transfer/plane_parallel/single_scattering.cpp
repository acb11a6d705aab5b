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

PlaneTurn turn_to_vertical(double cos_view, double cos_sun, double azimuth) {
  // The beam (sinθ0, 0, -μ0) on the direction's e_θ (down, away from the zenith) and e_φ; what of it lies
  // across the direction points along the plane of scattering.
  const double sin_view = std::sqrt(1.0 - cos_view * cos_view);
  const double sin_sun = std::sqrt(1.0 - cos_sun * cos_sun);
  const double along = sin_sun * cos_view * std::cos(azimuth) + cos_sun * sin_view;
  const double across = -sin_sun * std::sin(azimuth);
  const double square = along * along + across * across;
  // Straight on or back any plane will do: nothing is polarised there.
  if (square < 1e-30) return {};
  return {(along * along - across * across) / square, 2.0 * along * across / square};
}

void set_exact_single_scattering(const OpticalColumn& column, const ScaledMedium& medium,
                                 const PlaneParallelRequest& request, const ViewList& views,
                                 PlaneParallelResult& result) {
  const std::size_t directions = request.directions.size();
  std::vector<std::vector<std::size_t>> of_view(views.cosines.size());
  for (std::size_t i = 0; i < directions; ++i) of_view[views.of_direction[i]].push_back(i);
  result.radiance.assign(request.output_depths.size() * directions, 0.0);
  if (request.polarised) result.stokes_q = result.stokes_u = result.radiance;
  const std::size_t scatterers = column.scatterers.size();
  std::vector<double> phase(scatterers);
  // Mixed as each material mixes its scatterers, per material.
  const auto mixed = [&medium, scatterers](const std::vector<double>& values) {
    Eigen::VectorXd scattering(static_cast<Eigen::Index>(medium.optics.size()));
    for (std::size_t i = 0; i < medium.optics.size(); ++i) {
      double sum = 0.0;
      for (std::size_t s = 0; s < scatterers; ++s) sum += medium.optics[i].scatterer_albedos[s] * values[s];
      scattering[static_cast<Eigen::Index>(i)] = sum / (4.0 * kPi * medium.optics[i].depth_factor);
    }
    return scattering;
  };
  for (std::size_t view = 0; view < views.cosines.size(); ++view) {
    const double cos_view = views.cosines[view];
    const Eigen::MatrixXd integral = beam_integrals(medium, cos_view, request.cos_sun_zenith);
    const auto at_depth = [&](std::size_t depth, const Eigen::VectorXd& scattering) {
      return integral.row(static_cast<Eigen::Index>(medium.output_bounds[depth])).dot(scattering);
    };
    for (const std::size_t direction : of_view[view]) {
      const double azimuth = request.directions[direction].relative_azimuth_rad;
      const double angle = cos_scattering_angle(cos_view, request.cos_sun_zenith, azimuth);
      for (std::size_t s = 0; s < scatterers; ++s) phase[s] = column.scatterers[s].phase->value(angle);
      const Eigen::VectorXd scattering = mixed(phase);
      for (std::size_t depth = 0; depth < request.output_depths.size(); ++depth)
        result.radiance[depth * directions + direction] = at_depth(depth, scattering);
      if (!request.polarised) continue;
      for (std::size_t s = 0; s < scatterers; ++s) phase[s] = column.scatterers[s].phase->matrix(angle).f12;
      const Eigen::VectorXd polarising = mixed(phase);
      const PlaneTurn turn = turn_to_vertical(cos_view, request.cos_sun_zenith, azimuth);
      for (std::size_t depth = 0; depth < request.output_depths.size(); ++depth) {
        const double polarised = at_depth(depth, polarising);
        result.stokes_q[depth * directions + direction] = turn.cos_twice * polarised;
        result.stokes_u[depth * directions + direction] = turn.sin_twice * polarised;
      }
    }
  }
}

}  // namespace skylut::plane_parallel
