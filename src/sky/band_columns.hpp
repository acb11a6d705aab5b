#pragma once

#include <span>
#include <vector>

#include "skylut/sky/sky_scene.hpp"

namespace skylut {

/// The monochromatic columns that stand for the bands of a scene, for the transfer solver to take all at
/// once: of the first turbidity every wavelength with all its columns, then of the next.
struct BandColumns {
  std::vector<OpticalColumn> columns;
  std::vector<double> weights;     ///< of each column in its band
  std::vector<std::size_t> first;  ///< column of each band [turbidity][wavelength], and one past the last

  explicit BandColumns(const SkyScene& scene);

  std::size_t band(std::size_t turbidity, std::size_t wavelength) const {
    return turbidity * wavelengths_ + wavelength;
  }

 private:
  std::size_t wavelengths_;
};

}  // namespace skylut
