#pragma once

#include <span>
#include <vector>

#include "skylut/export/projection.hpp"
#include "skylut/sky/sun_disc.hpp"

namespace skylut {

/// What the sun's disc adds to the pixels of one picture: each of its points goes to the pixel that holds it,
/// as irradiance over the pixel's solid angle. ∫ L dω over all pictures of a projection is therefore the
/// disc's direct normal irradiance, whatever their size.
class DiscPixels {
 public:
  DiscPixels(const SunDisc& disc, const Projection& projection);

  /// Adds to one row. @param colour, radiance  as PictureSampler::sample_row()
  void add_to_row(int row, std::span<Xyz> colour, std::span<float> radiance) const;

 private:
  struct Pixel {
    int row = 0;
    int column = 0;
    Xyz colour{};
    std::vector<double> radiance;  // [wavelength]
  };
  std::vector<Pixel> pixels_;  // by row
};

}  // namespace skylut
