#include <cmath>

#include "export/projections.hpp"
#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

// Clarberg 2008, sections 2 and 3: the upper half is the diamond |u| + |v| <= 1, the lower half is folded
// outwards to the corners. In the first quadrant, with r the distance from the pole along the diamond,
//   |z| = 1 - r²,  φ = π/4 (1 + (v - u)/r).
class Octahedral final : public Projection {
 public:
  explicit Octahedral(int edge) : edge_(edge) {}
  std::string name() const override { return "octahedral"; }
  int width() const override { return edge_; }
  int height() const override { return edge_; }

  std::optional<Direction> direction_at(double x, double y) const override {
    const double u = (2.0 * x - edge_) / edge_;
    const double v = (2.0 * y - edge_) / edge_;
    const double above = 1.0 - (std::abs(u) + std::abs(v));  // > 0 in the upper half
    const double r = 1.0 - std::abs(above);
    const double turn =
        r == 0.0 ? 0.0 : (std::abs(v) - std::abs(u)) / r;  // -1 at the x axis, 1 at the y axis
    const double phi = 0.25 * kPi * (1.0 + turn);
    const double horizontal = r * std::sqrt(2.0 - r * r);
    return direction_of(std::copysign(horizontal * std::cos(phi), u),
                        std::copysign(horizontal * std::sin(phi), v), std::copysign(1.0 - r * r, above));
  }

  std::optional<PicturePoint> point_of(const Direction& direction) const override {
    const Unit to = unit_of(direction);
    const double horizontal = std::hypot(to.east, to.north);
    const double r = horizontal / std::sqrt(1.0 + std::abs(to.up));  // √(1 - |z|)
    const double turn = 4.0 / kPi * std::atan2(std::abs(to.north), std::abs(to.east)) - 1.0;
    const double sum = to.up >= 0.0 ? r : 2.0 - r;  // |u| + |v|
    const double u = std::copysign(0.5 * (sum - turn * r), to.east);
    const double v = std::copysign(0.5 * (sum + turn * r), to.north);
    return PicturePoint{0.5 * edge_ * (1.0 + u), 0.5 * edge_ * (1.0 + v)};
  }

  double density_sr(double, double) const override {
    return 4.0 * kPi / (static_cast<double>(edge_) * edge_);
  }
  double solid_angle_sr(int, int) const override { return density_sr(0.0, 0.0); }

  std::string orientation() const override {
    return "equal-area octahedral square as pbrt-v4 reads it, x east to the right, y north downwards, z up: "
           "zenith in the middle, horizon on the diamond between the middles of the edges (right east, "
           "bottom "
           "north, left west, top south), nadir in the corners; directions at pixel centres";
  }

 private:
  int edge_;
};

}  // namespace

std::unique_ptr<Projection> octahedral_projection(int edge) { return std::make_unique<Octahedral>(edge); }

}  // namespace skylut
