#pragma once

#include <vector>

#include "first_collision.hpp"
#include "phase_sampler.hpp"
#include "random_stream.hpp"
#include "shell_walk.hpp"

namespace skylut::monte_carlo {

/// Follows single photons backwards from their first collision.
class PhotonTracer {
 public:
  PhotonTracer(const Shells& shells, const OpticalColumn& column, const Vector& to_sun, int orders);

  const ShellWalk& shells() const { return shells_; }

  /// Radiance that one photon finds, sr⁻¹. @param view the direction it left the observer in
  double trace(const FirstCollision::Draw& first, Vector view, RandomStream& random) const;

 private:
  double sunlight_scattered(const PhotonPosition& place, const Vector& direction) const;
  double sunlight_reflected(const PhotonPosition& place) const;
  /// Scatters: new direction; returns the factor on the weight. 0 if the layer only absorbs.
  double scatter(const PhotonPosition& place, Vector& direction, RandomStream& random) const;
  /// Reflects at the ground: the same.
  double reflect(const PhotonPosition& place, Vector& direction, RandomStream& random) const;
  /// Free flight to the next collision.
  WalkEnd fly(PhotonPosition& place, const Vector& direction, RandomStream& random) const;

  ShellWalk shells_;
  Vector to_sun_;
  int orders_;
  double ground_albedo_;
  std::vector<PhaseSampler> samplers_;
  std::size_t most_peaked_ = 0;              ///< of the samplers
  double share_towards_sun_ = 0.0;           ///< of directions drawn about the sun's, see photon_tracer.cpp
  std::vector<std::vector<double>> albedo_;  ///< [layer][scatterer]: share in the extinction
};

}  // namespace skylut::monte_carlo
