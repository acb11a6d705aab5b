#pragma once

#include <cstdint>

#include "../geometry/ray_view.hpp"
#include "angular_grid.hpp"
#include "sweep_stencil.hpp"

namespace skylut::transfer {

// Plain views of the geometry and the optics of one block, as the kernels see them. The kernels are
// compiled for several instruction sets, so they may call no inline function that the rest of the
// program shares: hence pointers and counts instead of containers.

/// Where a grazing direction near the ground lies between the polar nodes and levels of HorizonNodes.
struct HorizonWeights {
  bool near = false;  ///< whether it is one
  std::int32_t hemisphere = 0;
  InterpolationWeights nodes;
  std::int32_t level = 0;  ///< among those that are kept
  float fraction = 0.0f;   ///< of the way to the next one
};

/// See HorizonPeakTables.
struct HorizonView {
  int nodes;                  ///< polar nodes near the horizon
  int degrees;                ///< that are summed
  const float* synthesis;     ///< [m][l >= m][node]: (2l+1) Λ_lm(|μ|)
  const float* analysis;      ///< [m][l >= m][polar]: Σ analysis I_m = ½ ∫ Λ_lm(|μ|) I_m d|μ|
  int levels;                 ///< that are kept
  const int* place_of_level;  ///< [level of the sweep]: among those that are kept; -1: it is not
  const int* layer_of_level;  ///< [level that is kept]: merged layer above it (of the top level, below)
};

/// See PolarisedAngles.
struct PolarisedView {
  int moments;                     ///< of Q and of U, each; 0: light is taken for unpolarised
  int orders;                      ///< azimuthal
  int degrees;                     ///< highest + 1
  const int* moment_offset;        ///< [m], of its least degree
  const int* moment_degree;        ///< [moment]
  const int* moment_of_intensity;  ///< [moment]: of the same l and m
  /// [hemisphere][Q + U, Q - U] → [m], panels
  const float* const* polar_synthesis[2][2];
  const float* const* polar_analysis[2][2];
  const float* cosine_synthesis[2];  ///< [parity of m], panels
  const float* cosine_analysis[2];
  const float* sine_synthesis[2];
  const float* sine_analysis[2];
};

struct SweepView {
  SlantDepthView slant_depth;
  int sublayers;  ///< of the sweep; levels = sublayers + 1
  int sun_nodes;
  int polar_nodes;
  int azimuth_nodes;
  int azimuthal_orders;
  int moments;
  int legendre_terms;  ///< max_l + 1
  int chord_nodes;

  const int* layer_of_sublayer;            ///< merged layer
  const int* moment_offset;                ///< [m], of (m, m)
  const int* moment_degree;                ///< [moment]: its l
  const float* const* polar_synthesis[2];  ///< [hemisphere] → [m], panels
  const float* const* polar_analysis[2];
  const float* azimuth_synthesis[2];  ///< [parity of m], panels
  const float* azimuth_analysis[2];
  const float* flux_weight;                    ///< [polar][azimuth]: irradiance = Σ weight I
  const float* beam_moment;                    ///< [sun node][moment]: Λ_lm(-μs)/4π
  const float* sun_cosine;                     ///< [sun node]
  const PolarStep* polar_step[2];              ///< [hemisphere][sublayer][polar]
  const InterpolationWeights* sun_weights[2];  ///< [hemisphere][sublayer][sun node][polar][azimuth]
  const SlantDepthWeights* beam_weights;       ///< [point][sun node]: see BeamGeometry
  const int* first_piece;                      ///< [sublayer], one past the last
  const int* piece_layer;
  const float* piece_thickness_km;
  HorizonView horizon;  ///< nodes 0: no column cuts off a peak
  PolarisedView polarised;
};

/// See ScaledLayers.
struct LayerView {
  const float* extinction_per_km;
  const float* source_factor;
  const float* polarised_factor;  ///< null: unpolarised light
};

/// See BlockOptics.
struct OpticsView {
  int scatterers;
  LayerView layers;
  LayerView sweep_layers;
  const float* scattering_per_km;
  const float* peak_per_km;     ///< [layer][lane]: what delta-M takes for unscattered
  int horizon_peaks;            ///< see HorizonPeaks; 0: no lane is corrected
  const float* horizon_moment;  ///< [peak][degree][lane]
  const float* horizon_share;   ///< [layer of the sweep][peak][lane]
  const float* ground_albedo;
};

struct IterationLimits {
  int scattering_orders;  ///< 0: until converged
  int max_iterations;
  float tolerance;  ///< relative error of the mean diffuse radiance left by the orders not summed
  /// Asked before every iteration with `token`: whether to stop. (A plain pointer, so that the kernels share
  /// no inline function with the program.)
  bool (*cancelled)(const void* token);
  const void* token;
};

/// How the iteration of one block ended.
struct IterationReport {
  enum End { kConverged, kNotConverged, kCancelled };
  End end = kNotConverged;
  int iterations = 0;
  float error_left = 0.0f;  ///< the largest of the lanes' and sun nodes' own estimates at the end [I2]
};

/// Point of a line of sight where the diffuse field is asked.
struct SourcePoint {
  int sublayer;
  float fraction;  ///< height within the sublayer, 0 at its lower level, 1 at its upper
};

/// Piece of a line of sight within one layer of the medium, between a source point and the next. Its ends lie
/// at these fractions of the way between the two.
struct SourcePiece {
  int layer;
  float length_km;
  int source;  ///< the nearer one
  float near_fraction;
  float far_fraction;
};

/// The diffuse field along a line of sight, for all its pairs.
struct RaySourcesView {
  int pieces;
  int sources;
  int azimuth_stride;
  const SourcePiece* piece;
  const SourcePoint* source;                       ///< the last one is the ray's end
  const float* polar_moment;                       ///< [source][moment]: Λ_lm(μ) of the light there
  const HorizonWeights* horizon;                   ///< [source]
  const InterpolationWeights* const* sun_weights;  ///< [source] → [pair], among the sun nodes
  const float* const* azimuth_factor;  ///< [source] → [pair][m], azimuth_stride apart: (2-δ_m0) cos mφ
  const float* const* azimuth_sine;    ///< the same with sin mφ; null: Q and U are not asked for
  const float* rotation[2];  ///< [source][polarised moment]: R and T of the light there, for Q and U
};

/// What Q and U of singly scattered light follow from, for all pairs of a line of sight.
struct PolarisedScattering {
  const float* f12;       ///< [pair][scatterer][lane]
  const float* rotation;  ///< [pair][2]: what makes Q and U of it
};

/// The diffuse field of one block, solved, which answers lines of sight. Calls may run in parallel.
class SolvedBlock {
 public:
  virtual ~SolvedBlock() = default;
  /// @param phase     exact phase functions at the pairs' scattering angles, [pair][scatterer][lane]
  /// @param peaks     ForwardPeakCorrection's coefficients, [aureole][first, second][scatterer][lane]
  /// @param polarised  null: I alone is asked for
  /// @param radiance   sr⁻¹, [I, then Q and U if asked for][pair][lane]
  virtual void line_of_sight(const RayView& ray, const RaySourcesView& diffuse, const float* phase,
                             const float* peaks, const PolarisedScattering* polarised,
                             float* radiance) const = 0;

  /// The radiance in parts that know no phase function: Σ_i P_i A_i - Q1_i B_i + Q2_i C_i + D with the
  /// scatterers' amplitudes A, B, C (see single_scattering_amplitudes) and the diffuse light D, which may
  /// undershoot 0 where line_of_sight clamps. Several lines at a time.
  /// @param parts  sr⁻¹, [line] → [A of each scatterer, B of each, C of each, D, then the diffuse Q and U if
  ///               the sources ask for them][pair][lane]
  virtual void parts_of_sights(int lines, const RayView* rays, const RaySourcesView* diffuse,
                               float* const* parts) const = 0;
};

/// Solves the diffuse field of one block; the views must outlive the result. The caller owns it.
/// @return null unless the orders of scattering converged
using SolveBlock = SolvedBlock* (*)(const SweepView&, const OpticsView&, const IterationLimits&,
                                    IterationReport&);

/// One build of the solver: how many lanes it works on at once.
struct Kernel {
  const char* name;
  int lanes;
  SolveBlock solve_block;
};

SolvedBlock* solve_block_reference(const SweepView&, const OpticsView&, const IterationLimits&,
                                   IterationReport&);
SolvedBlock* solve_block_portable(const SweepView&, const OpticsView&, const IterationLimits&,
                                  IterationReport&);
SolvedBlock* solve_block_avx2(const SweepView&, const OpticsView&, const IterationLimits&, IterationReport&);
SolvedBlock* solve_block_avx512(const SweepView&, const OpticsView&, const IterationLimits&,
                                IterationReport&);

}  // namespace skylut::transfer
