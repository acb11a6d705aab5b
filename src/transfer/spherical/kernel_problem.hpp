#pragma once

#include <cstdint>

#include "angular_grid.hpp"
#include "interpolation.hpp"
#include "sweep_stencil.hpp"

namespace skylut::transfer {

// Plain views of the geometry and the optics of one block, as the kernels see them. The kernels are
// compiled for several instruction sets, so they may call no inline function that the rest of the
// program shares: hence pointers and counts instead of containers.

struct SweepView {
  int layers;     ///< homogeneous layers of the medium
  int sublayers;  ///< of the sweep; levels = sublayers + 1
  int sun_nodes;
  int polar_nodes;
  int azimuth_nodes;
  int azimuthal_orders;
  int moments;
  int degrees;  ///< max_l + 1
  int chord_nodes;

  const int* layer_of_sublayer;         ///< merged layer
  const int* moment_offset;             ///< [m], of (m, m)
  const int* moment_degree;             ///< [moment]: its l
  const float* polar_synthesis[2][32];  ///< [hemisphere][m], panels
  const float* polar_analysis[2][32];
  const float* azimuth_synthesis;
  const float* azimuth_analysis;
  const float* flux_weight;          ///< [polar][azimuth]: irradiance = Σ weight I
  const float* beam_moment;          ///< [sun node][moment]: Λ_lm(-μs)/4π
  const float* sun_cosine;           ///< [sun node]
  const PolarStep* polar_step[2];    ///< [hemisphere][sublayer][polar]
  const SunTaps* sun_taps[2];        ///< [hemisphere][sublayer][sun node][polar][azimuth]
  const float* const* beam_path_km;  ///< [point][sun node] → [layer], null in the shadow: see BeamGeometry
  const int* first_piece;            ///< [sublayer], one past the last
  const int* piece_layer;
  const float* piece_thickness_km;
};

/// See ScaledLayers.
struct LayerView {
  const float* extinction_per_km;
  const float* source_factor;
};

/// See BlockOptics.
struct OpticsView {
  int scatterers;
  LayerView layers;
  LayerView sweep_layers;
  const float* scattering_per_km;
  const float* ground_albedo;
};

struct IterationLimits {
  int orders;  ///< 0: until converged
  int max_iterations;
  float tolerance;  ///< relative error of the mean diffuse radiance left by the orders not summed
};

/// One segment of a line of sight, within one sublayer and one layer of the medium, from its near end to its
/// far end.
struct RaySegment {
  int sublayer;
  int layer;
  float length_km;
  float near_fraction;  ///< height of the end within the sublayer, 0 at its lower level, 1 at its upper
  float far_fraction;
};

/// What differs between the suns and azimuths of a line of sight, at one end of a segment.
struct RaySource {
  std::int32_t first_node;
  float node_weight[4];
};

/// Part of a segment that the sun reaches, with the exact altitudes and sun angles of its ends.
struct LitPart {
  int segment;
  float length_km;
  float start_km;  ///< of its near end, from the segment's near end
  float near_altitude_km, far_altitude_km;
  float near_perigee_km, far_perigee_km;  ///< lowest altitude of the sunbeam's line (below the ground: steep)
  bool continues;                         ///< its near end is the far end of the part before it
  bool near_down, far_down;               ///< the way to the sun goes down first
};

/// A line of sight and all the (sun, azimuth) pairs under which it is wanted.
struct RayView {
  int segments;
  int pairs;
  bool hits_ground;
  float planet_radius_km;
  const RaySegment* segment;
  const float* polar_moment;  ///< [end: 2 segment + (0 near, 1 far)][moment]: Λ_lm(μ) of the light there
  const RaySource* source;    ///< [end][pair]
  const RaySource* ground_source;  ///< [pair], where the ray ends
  const float* azimuth_factor;     ///< [end][pair][m]: (2-δ_m0) cos mφ
  const LitPart* lit;              ///< all pairs in turn
  const int* first_lit;            ///< [pair], with one past the last
  const float* level_altitude_km;  ///< [layer + 1] of the medium
  const float* ground_perigee_km;  ///< [pair], of the sunbeam's line through the ray's end on the ground
  const float* ground_sun_cosine;  ///< [pair]
};

/// The diffuse field of one block, solved, which answers lines of sight. Calls may run in parallel.
class SolvedBlock {
 public:
  virtual ~SolvedBlock() = default;
  /// @param phase     exact phase functions at the pairs' scattering angles, [pair][scatterer][lane]
  /// @param radiance  sr⁻¹, [pair][lane]
  virtual void line_of_sight(const RayView& ray, const float* phase, float* radiance) const = 0;
};

/// Solves the diffuse field of one block; the views must outlive the result. The caller owns it.
/// @return null if the orders of scattering did not converge
using SolveBlock = SolvedBlock* (*)(const SweepView&, const OpticsView&, const IterationLimits&);

/// One build of the solver: how many lanes it works on at once.
struct Kernel {
  const char* instruction_set;
  int lanes;
  SolveBlock solve_block;
};

SolvedBlock* solve_block_sse2(const SweepView&, const OpticsView&, const IterationLimits&);
SolvedBlock* solve_block_avx2(const SweepView&, const OpticsView&, const IterationLimits&);
SolvedBlock* solve_block_avx512(const SweepView&, const OpticsView&, const IterationLimits&);

/// The widest build that this machine can run; SKYLUT_SIMD=sse2|avx2|avx512 chooses a narrower one.
const Kernel& best_kernel();

}  // namespace skylut::transfer
