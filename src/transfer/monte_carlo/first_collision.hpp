#pragma once

#include <vector>

#include "shell_walk.hpp"

namespace skylut::monte_carlo {

/// Where along the line of sight photons meet the air for the first time. Drawing the place by the path's own
/// law would put most photons where the air is dense, though in twilight the light comes from high up. So
/// the line is cut in pieces, a piece is drawn half by its extinction and half by the sunlight that
/// it scatters once, a place in it uniformly, and the weight (law / draw) makes the estimate exact.
/// The ground at the end of the line is one more piece.
class FirstCollision {
 public:
  /// @param to_sun  unit vector
  FirstCollision(const ShellWalk& shells, const PhotonPosition& observer, const Vector& view,
                 const Vector& to_sun);

  struct Draw {
    bool ground = false;
    PhotonPosition place;
    double weight = 0.0;  ///< e^{-τ} β_ext / density drawn from; ground: e^{-τ} / share
  };
  /// @param choice  in [0, 1); stratified over a batch: reused within the piece that it falls in
  Draw at(double choice) const;

  /// Nothing along the line meets light: a horizontal glance out of the top, say.
  bool empty() const { return cumulative_.empty(); }

 private:
  struct Piece {
    std::size_t layer = 0;
    double start_km = 0.0;
    double length_km = 0.0;
    double depth_before = 0.0;  ///< optical depth from the observer to its start
  };

  const ShellWalk& shells_;
  PhotonPosition observer_;
  Vector view_;
  std::vector<Piece> pieces_;
  bool hits_ground_ = false;
  double depth_to_ground_ = 0.0;
  PhotonPosition ground_;
  std::vector<double> cumulative_;  ///< shares of pieces, the ground last
};

}  // namespace skylut::monte_carlo
