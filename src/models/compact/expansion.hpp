#pragma once

#include <span>
#include <vector>

#include "skylut/core/wavelength_grid.hpp"
#include "skylut/models/compact/cubic_spline.hpp"
#include "skylut/models/compact/tables.hpp"

namespace skylut::compact {

/// Tables with the products over the conditions multiplied out, so that a sky needs only the neighbours of
/// its conditions.
class Expansion {
 public:
  explicit Expansion(Tables tables);

  const Tables& tables() const { return tables_; }
  const Layout& layout() const { return layout_; }
  const ZenithGrid& zenith() const { return zenith_; }

  /// The molecules' phase function, P(90°) and P(0°) - P(90°). [channel]
  std::span<const float> rayleigh_90() const { return rayleigh_90_; }
  std::span<const float> rayleigh_rise() const { return rayleigh_rise_; }

  /// The spline coefficients of one sky, [zenith node][number of the layout].
  std::vector<float> features(double altitude_km, double aod500, double sun_zenith_deg) const;

  /// S of the air, by which a ground of albedo A counts w = A (1 - S)/(1 - A S) of a white one. [channel] The
  /// light of the sky and of the ground itself have other spectra: each has its own S.
  std::vector<float> ground_share(double aod500, double albedo, bool of_ground) const;

 private:
  struct LoadTaps {
    std::size_t first = 0;
    std::vector<double> weight;
  };
  LoadTaps load_taps(double aod500) const;

  Tables tables_;
  Layout layout_;
  ZenithGrid zenith_;
  CubicSpline altitude_;
  CubicSpline load_;  // of all but the first load
  CubicSpline sun_;
  std::vector<float> rayleigh_90_;
  std::vector<float> rayleigh_rise_;
  std::vector<float> conditions_;  // [load][altitude][sun][rank]
};

}  // namespace skylut::compact
