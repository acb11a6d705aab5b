#pragma once

#include <cstdint>

#include "interpolation.hpp"

namespace skylut::transfer {

// Plain views of rays and of the depth towards the sun, as the kernels see them: pointers and counts instead
// of containers (spherical/kernel_problem.hpp says why).

/// Interpolation of the optical depth between a point and the sun: see SlantDepthGrid.
struct SlantDepthWeights {
  /// First of four entries of the table of sunbeams that rise from a level; kShadow: no sun here.
  std::int32_t from_level = 0;
  /// First of four entries of the table of half-lines from their lowest point; -1: the sunbeam comes from
  /// above.
  std::int32_t from_perigee = -1;
  std::int32_t layer = 0;    ///< of the medium, that holds the point
  float to_level_km = 0.0f;  ///< way from the point, upwards along the sunbeam's line, to the next level
  float spread = 0.0f;  ///< what refraction's spreading of the beam adds to the depth: -ln(concentration)
  float from_level_weight[4] = {};
  float from_perigee_weight[4] = {};
};
inline constexpr std::int32_t kShadow = -1;

/// Where the depth towards the sun is tabulated, and the paths through the layers from there.
struct SlantDepthView {
  int layers;  ///< of the medium
  int level_points;
  int perigee_points;
  const float* from_level_path_km;    ///< [point][layer]
  const float* from_perigee_path_km;  ///< [point][layer]
};

/// One segment of a line of sight within one layer of the common.
struct RaySegment {
  int layer;
  float length_km;
};

/// Part of a segment that one pair's sun reaches.
struct LitPart {
  int pair;
  int near_end;    ///< index of its near end among the lit ends; the far end is the next one
  bool continues;  ///< its near end is the far end of the pair's part before it
  float start_km;  ///< of its near end, from the segment's near end
  float length_km;
};

/// A line of sight through the medium and all the (sun, azimuth) pairs under which it is wanted.
struct RayView {
  int segments;
  int pairs;
  bool hits_ground;
  const RaySegment* segment;
  const LitPart* lit;    ///< of the first segment, then of the next
  const int* first_lit;  ///< [segment], with one past the last
  const int* aureole;    ///< [pair]: its place in the phase functions' peaks; -1: too far from the sun
  const SlantDepthWeights* lit_end;     ///< ends of the lit parts
  const SlantDepthWeights* ground_sun;  ///< [pair], where the ray ends on the ground
  const float* ground_sun_cosine;       ///< [pair]
};

}  // namespace skylut::transfer
