#include "skylut/export/projection.hpp"

#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"

namespace skylut {

std::vector<Direction> Projection::directions() const {
  std::vector<Direction> directions;
  directions.reserve(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()));
  for (int row = 0; row < height(); ++row)
    for (int column = 0; column < width(); ++column) directions.push_back(direction(column, row));
  return directions;
}

LatLongProjection::LatLongProjection(int height) : height_(height) {
  if (height < 2 || height > 8192)
    throw InputError("map height {} pixels: must lie within 2 to 8192", height);
}

Direction LatLongProjection::direction(int column, int row) const {
  // Halves of a pixel as whole numbers: mirror-symmetric pixels get mirror-symmetric angles.
  const double zenith_deg = 180.0 * (2 * row + 1) / (2 * height_);
  const int half_pixels = (2 * column + 1 + 3 * height_) % (4 * height_);  // from north, clockwise
  return {zenith_deg, 360.0 * half_pixels / (4 * height_)};
}

std::string LatLongProjection::orientation() const {
  return "columns to the right run clockwise seen from above; left edge west (azimuth 270 deg), a quarter "
         "of the width north, middle east, three quarters south; top edge zenith, bottom edge nadir; "
         "directions at pixel centres";
}

std::vector<std::string> projection_names() { return {"latlong"}; }

std::unique_ptr<Projection> make_projection(const std::string& name, int height) {
  if (name == "latlong") return std::make_unique<LatLongProjection>(height);
  throw InputError("projection '{}': must be {}", name, listed(projection_names()));
}

}  // namespace skylut
