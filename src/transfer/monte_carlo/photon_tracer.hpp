#pragma once

#include <vector>

#include "first_collision.hpp"
#include "intensity_path.hpp"
#include "phase_sampler.hpp"
#include "random_stream.hpp"
#include "shell_walk.hpp"
#include "stokes_path.hpp"

namespace skylut::monte_carlo {

/// Follows single photons backwards from their first collision.
class PhotonTracer {
 public:
  PhotonTracer(const Shells& shells, const OpticalColumn& column, const Vector& to_sun, int orders);

  const ShellWalk& shells() const { return shells_; }

  /// Radiance that one photon finds, sr⁻¹. @param view the direction it left the observer in
  /// @param path  what it carries: an IntensityPath or a StokesPath
  template <typename Path>
  typename Path::Found trace(const FirstCollision::Draw& first, Vector view, Path path,
                             RandomStream& random) const;

 private:
  /// What one scattering has drawn.
  struct Scattering {
    double albedo = 0.0;        ///< of the layer; 0: it only absorbs
    std::size_t scatterer = 0;  ///< index
    Vector direction{};         ///< new
    double cos_angle = 0.0;
    double density = 0.0;  ///< of the draw, per unit of the cosine
  };
  template <typename Path>
  void find_sunlight(const PhotonPosition& place, const Vector& direction, Path& path) const;
  double sunlight_reflected(const PhotonPosition& place) const;
  Scattering scatter(const PhotonPosition& place, const Vector& direction, RandomStream& random) const;
  /// Reflects at the ground: new direction; returns the factor on the weight.
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
