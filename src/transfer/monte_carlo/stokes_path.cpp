#include "stokes_path.hpp"

#include "skylut/core/constants.hpp"

namespace skylut::monte_carlo {
namespace {

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Normal of the plane of scattering; straight on or back, where every plane is one, the given axis.
Vector normal_of(const Vector& before, const Vector& after, const Vector& axis) {
  const Vector normal = cross(before, after);
  return dot(normal, normal) > 1e-24 ? normalised(normal) : axis;
}

}  // namespace

void StokesPath::add(Law& sum, double share, const Law& law) {
  sum.f11 += share * law.f11;
  sum.f12 += share * law.f12;
  sum.f22 += share * law.f22;
  sum.f33 += share * law.f33;
}

StokesPath::StokesPath(const Vector& view, double azimuth_deg) {
  const double azimuth = azimuth_deg * kRadiansPerDegree;
  take_axes(view, {-std::sin(azimuth), std::cos(azimuth), 0.0});
}

void StokesPath::take_axes(const Vector& direction, const Vector& across) {
  first_axis_ = cross(direction, across);
  second_axis_ = across;
}

void StokesPath::divide_weight(double divisor) {
  for (auto& row : product_)
    for (double& element : row) element /= divisor;
}

StokesPath::Turn StokesPath::turn_to(const Vector& direction, const Vector& across) const {
  const double cosine = dot(first_axis_, cross(direction, across));
  const double sine = dot(first_axis_, across);
  return {cosine * cosine - sine * sine, 2.0 * cosine * sine};
}

void StokesPath::find_scattered(const Vector& direction, const Vector& to_sun, const Law& law,
                                double transmitted) {
  const Turn turn = turn_to(direction, normal_of(direction, to_sun, second_axis_));
  const double scale = transmitted / (4.0 * kPi);
  for (std::size_t i = 0; i < 3; ++i)
    found_[i] += scale * (product_[i][0] * law.f11 +
                          law.f12 * (product_[i][1] * turn.cosine - product_[i][2] * turn.sine));
}

void StokesPath::find_reflected(double radiance) {
  for (std::size_t i = 0; i < 3; ++i) found_[i] += product_[i][0] * radiance;
}

void StokesPath::scatter(const Vector& before, const Vector& after, double albedo, const Law& law,
                         double density) {
  const Vector across = normal_of(before, after, second_axis_);
  const Turn turn = turn_to(before, across);
  const double scale = albedo * 0.5 / density;
  for (auto& row : product_) {
    const double in_plane = row[1] * turn.cosine - row[2] * turn.sine;
    const double diagonal = row[1] * turn.sine + row[2] * turn.cosine;
    row = {scale * (row[0] * law.f11 + in_plane * law.f12), scale * (row[0] * law.f12 + in_plane * law.f22),
           scale * diagonal * law.f33};
  }
  take_axes(after, across);
}

void StokesPath::reflect(const Vector& after, double factor) {
  for (auto& row : product_) row = {row[0] * factor, 0.0, 0.0};
  // Any axes: nothing polarised is carried on.
  const Vector axis = std::abs(after[2]) < 0.7 ? Vector{0.0, 0.0, 1.0} : Vector{1.0, 0.0, 0.0};
  take_axes(after, normalised(cross(after, axis)));
}

StokesPath::Found StokesPath::found(double first_weight) const {
  return {first_weight * found_[0], first_weight * found_[1], first_weight * found_[2]};
}

}  // namespace skylut::monte_carlo
