#pragma once

#include <array>
#include <vector>

#include "skylut/core/quadrature.hpp"

namespace skylut::transfer {

/// Highest Legendre degree that a discretisation takes, and what follows from a degree L: azimuthal orders up
/// to 3/4 L, and as many azimuth nodes as keep the products of two orders apart, an even number. The kernels'
/// scratch space for the azimuths of one polar node has this fixed size.
inline constexpr int kMostLegendreDegree = 30;
constexpr int azimuthal_order_for(int max_l) { return (3 * max_l + 3) / 4; }
constexpr int azimuth_nodes_for(int max_m) { return (max_m + 2) / 2 * 2; }
inline constexpr int kMostAzimuths = azimuth_nodes_for(azimuthal_order_for(kMostLegendreDegree));

/// How finely directions are resolved. The diffuse radiance enters the source only through its moments
///   M_lm = (1/4π) ∫ Λ_lm(μ) cos(mφ) I dΩ,  l <= max_l, m <= min(l, max_m).   [theory.md §4.3, M1]
struct AngularResolution {
  int max_l = 12;          ///< highest Legendre order of the (delta-M scaled) phase function
  int max_m = 9;           ///< highest azimuthal order
  int polar_nodes = 10;    ///< μ nodes per hemisphere
  int azimuth_nodes = 10;  ///< φ midpoints in (0, π); even, at most kMostAzimuths

  bool operator==(const AngularResolution&) const = default;
};

/// Light travels down (μ < 0) or up (μ > 0).
enum Hemisphere { kDown = 0, kUp = 1 };

/// A small dense matrix in the panels of apply_matrix (lanes.hpp), zero-padded to whole panels.
class PanelMatrix {
 public:
  PanelMatrix() = default;
  PanelMatrix(int rows, int columns);
  void set(int row, int column, double value);
  const float* data() const { return data_.data(); }
  int rows() const { return rows_; }
  int columns() const { return columns_; }

 private:
  int rows_ = 0;
  int columns_ = 0;
  std::vector<float> data_;
};

/// Directions of the sweep and the transforms between moments and radiances. A hemisphere's radiance is
/// stored as [polar node][azimuth node]; μ is the cosine of the direction in which light travels, φ = 0 the
/// azimuth in which the sunbeam travels.
class AngularGrid {
 public:
  explicit AngularGrid(const AngularResolution& resolution);

  const AngularResolution& resolution() const { return resolution_; }
  int polar_nodes() const { return resolution_.polar_nodes; }
  int azimuth_nodes() const { return resolution_.azimuth_nodes; }
  int directions() const { return polar_nodes() * azimuth_nodes(); }
  int azimuthal_orders() const { return resolution_.max_m + 1; }

  /// Moments are stored by m, then l from m to max_l: position of (m, m).
  int moment_offset(int m) const { return moment_offset_[static_cast<std::size_t>(m)]; }
  int moments() const { return moment_offset_.back(); }
  int legendre_terms(int m) const { return resolution_.max_l + 1 - m; }

  /// |μ| of the polar nodes, ascending. Gauss-Legendre in t = √μ crowds them at the horizon, where a
  /// spherical sky changes fastest; weight[j] integrates over |μ| in [0, 1].
  const std::vector<double>& cos_polar() const { return cos_polar_; }
  const std::vector<double>& polar_weight() const { return polar_weight_; }
  const std::vector<double>& azimuth_rad() const { return azimuth_rad_; }

  /// Λ_lm at the polar nodes of a hemisphere: rows = nodes, columns = l. One per m.
  const PanelMatrix& polar_synthesis(Hemisphere hemisphere, int m) const {
    return polar_synthesis_[hemisphere][static_cast<std::size_t>(m)];
  }
  /// Its transpose with the quadrature weights: rows = l, columns = nodes; includes 1/4π and dφ.
  const PanelMatrix& polar_analysis(Hemisphere hemisphere, int m) const {
    return polar_analysis_[hemisphere][static_cast<std::size_t>(m)];
  }
  /// The azimuth nodes lie symmetrically about π/2, where cos mφ is even for even m and odd for odd m: half
  /// of the nodes do for each parity. (2-δ_m0) cos(mφ_k): rows = the first half of the nodes, columns = m of
  /// one parity.
  const PanelMatrix& azimuth_synthesis(int parity) const {
    return azimuth_synthesis_[static_cast<std::size_t>(parity)];
  }
  /// cos(mφ_k): rows = m of one parity, columns = the first half of the nodes. It acts on the sum (even m) or
  /// the difference (odd m) of a node and its mirror image.
  const PanelMatrix& azimuth_analysis(int parity) const {
    return azimuth_analysis_[static_cast<std::size_t>(parity)];
  }

 private:
  AngularResolution resolution_;
  std::vector<int> moment_offset_;
  std::vector<double> cos_polar_;
  std::vector<double> polar_weight_;
  std::vector<double> azimuth_rad_;
  std::array<std::vector<PanelMatrix>, 2> polar_synthesis_;
  std::array<std::vector<PanelMatrix>, 2> polar_analysis_;
  std::array<PanelMatrix, 2> azimuth_synthesis_;
  std::array<PanelMatrix, 2> azimuth_analysis_;
};

}  // namespace skylut::transfer
