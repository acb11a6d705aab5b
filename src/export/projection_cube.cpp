#include <algorithm>
#include <array>
#include <cmath>

#include "export/projections.hpp"
#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

// What an observer in the middle of the cube has ahead, to the right and above on a face.
struct Face {
  const char* name;
  Unit ahead;
  Unit right;
  Unit top;
};

// OpenGL's cube maps (OpenGL 4.6 core specification, table 8.19) are seen from inside in a left-handed frame;
// three.js looks them up with x mirrored (flipEnvMap), so that its +X lies on the face of -x. With +X east
// and -Z north in three.js, x is west, y up and z south.
constexpr std::array<Face, 6> kFaces{{
    {"px", {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {"nx", {1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
    {"py", {0, 0, 1}, {-1, 0, 0}, {0, 1, 0}},
    {"ny", {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
    {"pz", {0, -1, 0}, {-1, 0, 0}, {0, 0, 1}},
    {"nz", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
}};

constexpr const char* kFrame =
    "OpenGL cube map as three.js loads it (there +X east, +Y up, -Z north, x mirrored in the look-up), every "
    "face seen from inside: px west, nx east, py zenith (top edge north), ny nadir (top edge south), pz "
    "south, "
    "nz north; directions at pixel centres";

// Places on one face, from -1 to 1 to the right (u) and upwards (v).
Direction direction_on(const Face& face, double u, double v) {
  return direction_of(face.ahead.east + u * face.right.east + v * face.top.east,
                      face.ahead.north + u * face.right.north + v * face.top.north,
                      face.ahead.up + u * face.right.up + v * face.top.up);
}

double dot(const Unit& a, const Unit& b) { return a.east * b.east + a.north * b.north + a.up * b.up; }

// The face that a direction falls on, of several the first, and where.
struct OnFace {
  std::size_t face;
  double u;
  double v;
};

OnFace on_face(const Direction& direction) {
  const Unit to = unit_of(direction);
  const auto nearer = [&](const Face& a, const Face& b) { return dot(to, a.ahead) < dot(to, b.ahead); };
  const Face& face = *std::max_element(kFaces.begin(), kFaces.end(), nearer);
  const double depth = dot(to, face.ahead);
  return {static_cast<std::size_t>(&face - kFaces.data()), std::clamp(dot(to, face.right) / depth, -1.0, 1.0),
          std::clamp(dot(to, face.top) / depth, -1.0, 1.0)};
}

// dω = du dv (1 + u² + v²)^(-3/2).
double density_on_face_sr(int edge, double u, double v) {
  const double square = 1.0 + u * u + v * v;
  return 4.0 / (static_cast<double>(edge) * edge) / (square * std::sqrt(square));
}

// Solid angle between the middle of a face and (u, v): ∫∫ of the density.
double corner_sr(double u, double v) { return std::atan2(u * v, std::sqrt(1.0 + u * u + v * v)); }

double pixel_on_face_sr(int edge, int column, int row) {
  const double left = (2.0 * column - edge) / edge;
  const double right = (2.0 * column + 2.0 - edge) / edge;
  const double top = (2.0 * row - edge) / edge;
  const double bottom = (2.0 * row + 2.0 - edge) / edge;
  return corner_sr(right, bottom) - corner_sr(left, bottom) - corner_sr(right, top) + corner_sr(left, top);
}

class CubeFace final : public Projection {
 public:
  CubeFace(int edge, const Face& face) : edge_(edge), face_(face) {}
  std::string name() const override { return "cube"; }
  std::string face() const override { return face_.name; }
  int width() const override { return edge_; }
  int height() const override { return edge_; }
  std::optional<Direction> direction_at(double x, double y) const override {
    return direction_on(face_, (2.0 * x - edge_) / edge_, (edge_ - 2.0 * y) / edge_);
  }
  std::optional<PicturePoint> point_of(const Direction& direction) const override {
    const OnFace at = on_face(direction);
    if (face() != kFaces[at.face].name) return std::nullopt;
    return PicturePoint{0.5 * edge_ * (1.0 + at.u), 0.5 * edge_ * (1.0 - at.v)};
  }
  double density_sr(double x, double y) const override {
    return density_on_face_sr(edge_, (2.0 * x - edge_) / edge_, (edge_ - 2.0 * y) / edge_);
  }
  double solid_angle_sr(int column, int row) const override { return pixel_on_face_sr(edge_, column, row); }
  std::string orientation() const override { return std::string("face ") + face_.name + " of an " + kFrame; }

 private:
  int edge_;
  Face face_;
};

class CubeCross final : public Projection {
 public:
  explicit CubeCross(int edge) : edge_(edge) {}
  std::string name() const override { return "cube-cross"; }
  int width() const override { return 4 * edge_; }
  int height() const override { return 3 * edge_; }

  std::optional<Direction> direction_at(double x, double y) const override {
    const Spot spot = spot_at(x, y);
    if (spot.face == nullptr) return std::nullopt;
    return direction_on(*spot.face, spot.u, spot.v);
  }
  std::optional<PicturePoint> point_of(const Direction& direction) const override {
    const OnFace at = on_face(direction);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        if (face_in(column, row) == &kFaces[at.face])
          // Not on the right or lower edge, whose pixels are another face's or none's.
          return PicturePoint{std::nextafter(edge_ * (column + 0.5 * (1.0 + at.u)), edge_ * (column + 0.5)),
                              std::nextafter(edge_ * (row + 0.5 * (1.0 - at.v)), edge_ * (row + 0.5))};
    return std::nullopt;
  }
  double density_sr(double x, double y) const override {
    const Spot spot = spot_at(x, y);
    return spot.face == nullptr ? 0.0 : density_on_face_sr(edge_, spot.u, spot.v);
  }
  double solid_angle_sr(int column, int row) const override {
    if (face_in(column / edge_, row / edge_) == nullptr) return 0.0;
    return pixel_on_face_sr(edge_, column % edge_, row % edge_);
  }
  std::string orientation() const override {
    return std::string(
               "cross of faces: py above pz; nx, pz, px, nz from the left; ny below pz; the rest has no "
               "direction and is 0; ") +
           kFrame;
  }

 private:
  struct Spot {
    const Face* face;
    double u;
    double v;
  };

  static const Face* face_in(int column, int row) {
    constexpr std::array<std::array<int, 4>, 3> kLayout{{{-1, 2, -1, -1}, {1, 4, 0, 5}, {-1, 3, -1, -1}}};
    if (column < 0 || column > 3 || row < 0 || row > 2) return nullptr;
    const int index = kLayout[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    return index < 0 ? nullptr : &kFaces[static_cast<std::size_t>(index)];
  }

  // A point on the edge of a face belongs to it, whatever is beyond.
  Spot spot_at(double x, double y) const {
    for (const double column : {std::floor(x / edge_), std::ceil(x / edge_) - 1.0})
      for (const double row : {std::floor(y / edge_), std::ceil(y / edge_) - 1.0})
        if (const Face* const face = face_in(static_cast<int>(column), static_cast<int>(row)))
          return {face, (2.0 * (x - column * edge_) - edge_) / edge_,
                  (edge_ - 2.0 * (y - row * edge_)) / edge_};
    return {nullptr, 0.0, 0.0};
  }

  int edge_;
};

}  // namespace

std::vector<std::unique_ptr<Projection>> cube_face_projections(int edge) {
  std::vector<std::unique_ptr<Projection>> faces;
  for (const Face& face : kFaces) faces.push_back(std::make_unique<CubeFace>(edge, face));
  return faces;
}

std::unique_ptr<Projection> cube_cross_projection(int edge) { return std::make_unique<CubeCross>(edge); }

}  // namespace skylut
