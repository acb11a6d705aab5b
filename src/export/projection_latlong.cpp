#include <cmath>

#include "export/projections.hpp"
#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

class LatLong final : public Projection {
 public:
  LatLong(int height, SkyPart part) : height_(height), lowest_deg_(part == SkyPart::sphere ? 180.0 : 90.0) {}

  std::string name() const override { return "latlong"; }
  // Square pixels on the equator.
  int width() const override { return lowest_deg_ == 180.0 ? 2 * height_ : 4 * height_; }
  int height() const override { return height_; }

  std::optional<Direction> direction_at(double x, double y) const override {
    // Halves of a pixel are whole numbers here: mirror-symmetric pixels get mirror-symmetric angles.
    const double half_pixels = std::fmod(2.0 * x + 1.5 * width(), 2.0 * width());  // from north, clockwise
    return Direction{zenith_deg(y), 360.0 * half_pixels / (2.0 * width())};
  }

  std::optional<PicturePoint> point_of(const Direction& direction) const override {
    if (direction.zenith_deg > lowest_deg_) return std::nullopt;
    const double from_west = std::fmod(direction.azimuth_deg + 90.0, 360.0);
    return PicturePoint{from_west / 360.0 * width(), direction.zenith_deg / lowest_deg_ * height_};
  }

  double density_sr(double, double y) const override {
    return std::sin(kRadiansPerDegree * zenith_deg(y)) * (kRadiansPerDegree * lowest_deg_ / height_) *
           (2.0 * kPi / width());
  }

  double solid_angle_sr(int, int row) const override {
    // cos θ₁ - cos θ₂ without cancellation.
    const double half_row = kRadiansPerDegree * lowest_deg_ / (2.0 * height_);
    const double middle = kRadiansPerDegree * zenith_deg(row + 0.5);
    return 2.0 * std::sin(middle) * std::sin(half_row) * (2.0 * kPi / width());
  }

  std::string orientation() const override {
    const char* const bottom = lowest_deg_ == 180.0 ? "nadir" : "horizon (zenith angle 90 deg)";
    return std::string(
               "columns to the right run clockwise seen from above; left edge west (azimuth 270 deg), a "
               "quarter of the width north, middle east, three quarters south; top edge zenith, bottom "
               "edge ") +
           bottom + "; directions at pixel centres";
  }

 private:
  double zenith_deg(double y) const { return lowest_deg_ * (2.0 * y) / (2.0 * height_); }

  int height_;
  double lowest_deg_;
};

}  // namespace

std::unique_ptr<Projection> latlong_projection(int height, SkyPart part) {
  return std::make_unique<LatLong>(height, part);
}

}  // namespace skylut
