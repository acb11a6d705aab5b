#pragma once

#include <vector>

#include "skylut/scattering/optical_column.hpp"

namespace skylut::transfer {

/// Thin layers taken together for the sweep. The medium's layers may be thinner than multiple scattering
/// asks for, since an observer who looks along the horizon sees every step of the air's density; lines of
/// sight and the sunbeam keep them. Depends on the levels alone.
class LayerMerge {
 public:
  /// @param keep_all  true: nothing is merged
  LayerMerge(const Shells& fine, bool keep_all);

  /// The layers of the sweep; their levels are levels of the medium.
  const Shells& shells() const { return shells_; }
  /// The column with the optical depths of merged layers added up.
  OpticalColumn column(const OpticalColumn& fine) const;

 private:
  std::vector<double> sum(const std::vector<double>& depth) const;

  Shells shells_;
  std::vector<std::size_t> first_layer_;  // of the medium, per layer of the sweep, with one past the last
};

}  // namespace skylut::transfer
