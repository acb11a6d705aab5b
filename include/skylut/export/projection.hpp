#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skylut/core/directions.hpp"

namespace skylut {

/// How the directions around an observer are laid out on the pixels of a picture.
class Projection {
 public:
  virtual ~Projection() = default;
  virtual std::string name() const = 0;
  virtual int width() const = 0;   ///< pixels
  virtual int height() const = 0;  ///< pixels

  /// Direction in which the observer looks through the centre of a pixel; column 0 is at the left,
  /// row 0 at the top.
  virtual Direction direction(int column, int row) const = 0;

  /// Words for the file's header: where north is, which way azimuth grows.
  virtual std::string orientation() const = 0;

  /// The directions of all pixels, row by row.
  std::vector<Direction> directions() const;
};

/// The whole sphere as a rectangle twice as wide as high, cell-centred: rows from the zenith (top
/// edge) to the nadir (bottom edge); columns to the right go clockwise seen from above. North is at
/// a quarter of the width, east in the middle, so that a program that puts its +X axis in the
/// middle (Blender, three.js) has +X = east, and north = +Y (Z up) or -Z (Y up).
class LatLongProjection final : public Projection {
 public:
  /// @param height  pixels, 2 to 8192. @throws InputError otherwise
  explicit LatLongProjection(int height);
  std::string name() const override { return "latlong"; }
  int width() const override { return 2 * height_; }
  int height() const override { return height_; }
  Direction direction(int column, int row) const override;
  std::string orientation() const override;

 private:
  int height_;
};

/// Those that exist.
std::vector<std::string> projection_names();

/// @throws InputError  if the name is none of projection_names()
std::unique_ptr<Projection> make_projection(const std::string& name, int height);

}  // namespace skylut
