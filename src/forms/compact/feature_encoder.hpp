#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "skylut/models/compact/layout.hpp"

namespace skylut::compact {

/// What a sky is at one zenith angle under one sun, in the channels' units, before it is written as features:
/// values at azimuths kπ/8 (light of the ground: kπ/2).
struct SkyRow {
  static constexpr std::size_t kAzimuths = Layout::kOrders;
  static constexpr std::size_t kGroundAzimuths = 3;
  Eigen::MatrixXd molecules;          ///< (azimuth, channel)
  std::vector<Eigen::MatrixXd> haze;  ///< [k] the same
  Eigen::MatrixXd diffuse;            ///< over a black ground
  Eigen::MatrixXd ground;             ///< what a white ground adds (ground azimuth, channel)
};

/// Writes rows as the features of Layout.
class FeatureEncoder {
 public:
  /// @param haze_mean  ū_0
  FeatureEncoder(const Layout& layout, double haze_mean);

  /// @param aod500    > 0
  /// @param features  [number of the layout]
  void encode(const SkyRow& row, double aod500, std::span<float> features) const;

 private:
  Layout layout_;
  double haze_mean_;
  Eigen::MatrixXd series_;         // of azimuths, (order, azimuth)
  Eigen::MatrixXd ground_series_;  // of the ground's azimuths
};

}  // namespace skylut::compact
