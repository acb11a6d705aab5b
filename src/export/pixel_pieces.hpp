#pragma once

#include <cstddef>
#include <vector>

#include "skylut/export/projection.hpp"

namespace skylut {

/// One direction that counts for a pixel.
struct PixelSample {
  Direction direction;
  double weight = 0.0;  ///< of the pixel's light, the sum over a pixel is 1
  std::size_t column = 0;
};

/// Cuts pixels into pieces in which the sky is smooth; see PictureSampler.
class PixelPieces {
 public:
  PixelPieces(const Projection& projection, double horizon_zenith_deg, const Direction& sun);

  /// The samples of the pixels [first, last) of a row, column by column; columns count from the first.
  std::vector<PixelSample> of_columns(int row, int first, int last) const;

 private:
  struct Piece;
  struct Extent;
  enum class Cut;
  Cut cut_of(const Piece& piece, const Extent& extent, double finest_deg) const;
  void collect(const Piece& piece, const Extent& extent, double finest_deg,
               std::vector<PixelSample>& samples) const;

  const Projection& projection_;
  double horizon_zenith_deg_;
  Direction sun_;
  bool sun_in_sky_;
};

}  // namespace skylut
