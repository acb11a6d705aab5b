#include <algorithm>
#include <cmath>
#include <vector>

#include "export/projections.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {

namespace {

// Distances from the middle are in radii of the circle, which touches the picture's edges.
class Fisheye final : public Projection {
 public:
  Fisheye(int diameter, SkyPart part, FisheyeLaw law)
      : size_(diameter),
        law_(law),
        rim_deg_(part == SkyPart::sphere ? 180.0 : 90.0),
        half_rim_sine_(std::sin(kRadiansPerDegree * rim_deg_ / 2.0)) {}

  std::string name() const override {
    return law_ == FisheyeLaw::equidistant ? "fisheye" : "fisheye-equisolid";
  }
  int width() const override { return size_; }
  int height() const override { return size_; }

  std::optional<Direction> direction_at(double x, double y) const override {
    const double west = (2.0 * x - size_) / size_;
    const double south = (2.0 * y - size_) / size_;
    const double r = std::hypot(west, south);
    if (r > 1.0) return std::nullopt;
    const double azimuth_deg = kDegreesPerRadian * std::atan2(-west, -south);
    return Direction{zenith_deg(r), wrapped_azimuth_deg(azimuth_deg)};
  }

  std::optional<PicturePoint> point_of(const Direction& direction) const override {
    if (direction.zenith_deg > rim_deg_) return std::nullopt;
    const double r = law_ == FisheyeLaw::equidistant
                         ? direction.zenith_deg / rim_deg_
                         : std::sin(0.5 * kRadiansPerDegree * direction.zenith_deg) / half_rim_sine_;
    const double azimuth = kRadiansPerDegree * direction.azimuth_deg;
    return PicturePoint{0.5 * size_ * (1.0 - r * std::sin(azimuth)),
                        0.5 * size_ * (1.0 - r * std::cos(azimuth))};
  }

  double density_sr(double x, double y) const override {
    const double r = std::hypot((2.0 * x - size_) / size_, (2.0 * y - size_) / size_);
    return r > 1.0 ? 0.0 : density_at(r);
  }

  double solid_angle_sr(int column, int row) const override {
    static const Quadrature in_x = gauss_legendre(5, 0.0, 1.0);
    static const Quadrature in_y = gauss_legendre(8, 0.0, 1.0);
    const double left = edge(column);
    const double right = edge(column + 1);
    const double scale = size_ / 2.0;
    double sum = 0.0;
    const std::vector<double> pieces = heights_between_kinks(left, right, edge(row), edge(row + 1));
    for (std::size_t piece = 0; piece + 1 < pieces.size(); ++piece) {
      // y = sin t, so that the chord cos t is smooth to the very ends of the circle.
      const double from_t = std::asin(pieces[piece]);
      const double span_t = std::asin(pieces[piece + 1]) - from_t;
      for (std::size_t j = 0; j < in_y.node.size(); ++j) {
        const double y = std::sin(from_t + span_t * in_y.node[j]);
        const double half_chord = std::cos(from_t + span_t * in_y.node[j]);
        const double from = std::max(left, -half_chord);
        const double chord = std::min(right, half_chord) - from;
        if (chord <= 0.0) continue;
        for (std::size_t i = 0; i < in_x.node.size(); ++i)
          sum += in_y.weight[j] * span_t * half_chord * in_x.weight[i] * chord *
                 density_at(std::hypot(from + chord * in_x.node[i], y));
      }
    }
    return sum * scale * scale;
  }

  std::string orientation() const override {
    return std::string("looking up: north at the top, east at the left, zenith in the middle; ") +
           (law_ == FisheyeLaw::equidistant ? "zenith angle = " : "sin(zenith angle / 2) = sin(half of ") +
           (rim_deg_ == 180.0 ? "180" : "90") +
           (law_ == FisheyeLaw::equidistant ? " deg times" : " deg) times") +
           " the distance from the middle over the circle's radius; pixels outside the circle, which touches "
           "the edges, have no direction and are 0; directions at pixel centres";
  }

 private:
  double edge(int pixels) const { return (2.0 * pixels - size_) / size_; }

  double zenith_deg(double r) const {
    if (law_ == FisheyeLaw::equidistant) return rim_deg_ * r;
    return std::min(rim_deg_, 2.0 * kDegreesPerRadian * std::asin(r * half_rim_sine_));
  }

  // dω = sin θ dθ dφ over the area r dr dφ, which is (size/2)² pixels for r = 1.
  double density_at(double r) const {
    const double per_area = 4.0 / (static_cast<double>(size_) * size_);
    if (law_ == FisheyeLaw::equisolid) return per_area * 4.0 * half_rim_sine_ * half_rim_sine_;
    const double rim = kRadiansPerDegree * rim_deg_;
    return per_area * (r < 1e-8 ? rim * rim : rim * std::sin(rim * r) / r);
  }

  // The pixel's rows, cut where the circle crosses its sides or ends: between the cuts the chord is smooth.
  static std::vector<double> heights_between_kinks(double left, double right, double top, double bottom) {
    std::vector<double> heights{top, bottom};
    for (const double x : {left, right, 0.0}) {
      if (x < left || x > right || std::abs(x) > 1.0) continue;
      for (const double y : {std::sqrt(1.0 - x * x), -std::sqrt(1.0 - x * x)})
        if (y > top && y < bottom) heights.push_back(y);
    }
    std::sort(heights.begin(), heights.end());
    return heights;
  }

  int size_;
  FisheyeLaw law_;
  double rim_deg_;
  double half_rim_sine_;
};

}  // namespace

std::unique_ptr<Projection> fisheye_projection(int diameter, SkyPart part, FisheyeLaw law) {
  return std::make_unique<Fisheye>(diameter, part, law);
}

}  // namespace skylut
