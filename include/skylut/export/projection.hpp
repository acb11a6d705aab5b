#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skylut/core/directions.hpp"

namespace skylut {

/// A point of a picture, in pixels to the right of and below its upper left corner.
struct PicturePoint {
  double x = 0.0;
  double y = 0.0;
};

/// How the directions around an observer are laid out on the pixels of a picture. Points of the picture are
/// x to the right and y downwards from its upper left corner, in pixels: the centre of the first pixel is
/// (0.5, 0.5). Pixels that are mirror images of each other have directions that are.
class Projection {
 public:
  virtual ~Projection() = default;
  virtual std::string name() const = 0;
  virtual int width() const = 0;   ///< pixels
  virtual int height() const = 0;  ///< pixels

  /// What tells the files of one picture apart: "px" … "nz" for the faces of a cube, else nothing.
  virtual std::string face() const { return {}; }

  /// Direction in which the observer looks through a point, or none: outside the circle of a fisheye, in the
  /// empty corners of a cross. @param x  [0, width] @param y  [0, height]
  virtual std::optional<Direction> direction_at(double x, double y) const = 0;

  /// The point through which the observer looks in a direction, or none: beyond the hemisphere that is shown,
  /// on another face. What lies on the edge between faces is on one of them. direction_at() of the point is
  /// the direction again, to rounding. @param direction  zenith angle [0, 180], azimuth [0, 360)
  virtual std::optional<PicturePoint> point_of(const Direction& direction) const = 0;

  /// Solid angle that a small part of the picture covers per pixel of its area, sr; 0 where there is no
  /// direction.
  virtual double density_sr(double x, double y) const = 0;

  /// Solid angle of a pixel, of its part that has directions, sr. Exact to rounding but for the equidistant
  /// fisheye and pixels cut by a circle, which are quadratures; sums over a picture are good to 1e-9 (of
  /// size 2: 1e-6).
  virtual double solid_angle_sr(int column, int row) const = 0;

  /// Words for the file's header: where north is, which way azimuth grows.
  virtual std::string orientation() const = 0;

  /// Direction through the centre of a pixel.
  std::optional<Direction> direction(int column, int row) const {
    return direction_at(column + 0.5, row + 0.5);
  }
};

/// What of the directions a picture shows.
enum class SkyPart {
  sphere,     ///< all of them
  hemisphere  ///< those above the astronomical horizon, zenith angles to 90°
};

struct ProjectionChoice {
  std::string name = "latlong";  ///< one of projection_names()
  int size = 256;                ///< pixels, 2 to 16384: see make_projections()
  std::optional<SkyPart> part;   ///< none: the projection's own, sphere but for the fisheyes
};

/// latlong            rows from the zenith down, columns clockwise; twice as wide as high (hemisphere: four
///                    times). East is in the middle, north at a quarter of the width: a program that has its
///                    +X axis in the middle (Blender, three.js) has +X = east, and north = +Y (Z up) or -Z.
/// fisheye            equidistant: zenith angle ∝ distance from the middle. Seen looking up, north at the
///                    top and so east at the left.
/// fisheye-equisolid  the same with equal solid angles on equal areas
/// cube               six faces as OpenGL's cube maps, for the loader of three.js: there +X is east, +Y up,
///                    -Z north. It looks cube maps up with x mirrored, so that the face px shows the west.
/// cube-cross         the same faces in one picture, 4 faces wide and 3 high
/// octahedral         the equal-area square of Clarberg, "Fast equal-area mapping of the (hemi)sphere using
///                    SIMD", Journal of Graphics Tools 13(3), 2008 (doi 10.1080/2151237X.2008.10129263), as
///                    pbrt-v4 reads environment maps: x east, y north, z up
std::vector<std::string> projection_names();

/// The pictures of one choice: one, or the six faces of a cube. The size is the height of a latlong picture,
/// the diameter of a fisheye, the edge of a face or of the octahedral square.
/// @throws InputError  if the name is none of projection_names(), the size outside 2 to 16384, or a
/// hemisphere
///                     asked of a cube or an octahedral square
std::vector<std::unique_ptr<Projection>> make_projections(const ProjectionChoice& choice);

/// Whether make_projections() has a hemisphere of it.
bool shows_hemispheres(const std::string& projection_name);

/// The part that a projection of that name shows unless another is asked for.
SkyPart default_part(const std::string& projection_name);

}  // namespace skylut
