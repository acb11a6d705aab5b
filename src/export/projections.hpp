#pragma once

#include <memory>
#include <vector>

#include "skylut/core/directions.hpp"
#include "skylut/export/projection.hpp"

/// The projections there are, for make_projections() alone: one file each.
namespace skylut {

enum class FisheyeLaw {
  equidistant,  ///< r ∝ θ
  equisolid     ///< r ∝ sin(θ/2)
};

std::unique_ptr<Projection> latlong_projection(int height, SkyPart part);
std::unique_ptr<Projection> fisheye_projection(int diameter, SkyPart part, FisheyeLaw law);
std::vector<std::unique_ptr<Projection>> cube_face_projections(int edge);
std::unique_ptr<Projection> cube_cross_projection(int edge);
std::unique_ptr<Projection> octahedral_projection(int edge);

/// A vector of length 1.
struct Unit {
  double east;
  double north;
  double up;
};
Unit unit_of(const Direction& direction);

/// The direction of a vector, of any length but 0.
Direction direction_of(double east, double north, double up);

}  // namespace skylut
