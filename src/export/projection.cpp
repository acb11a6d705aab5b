#include "skylut/export/projection.hpp"

#include <cmath>

#include "export/projections.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"

namespace skylut {

namespace {

bool is_fisheye(const std::string& name) { return name == "fisheye" || name == "fisheye-equisolid"; }

std::vector<std::unique_ptr<Projection>> alone(std::unique_ptr<Projection> projection) {
  std::vector<std::unique_ptr<Projection>> list;
  list.push_back(std::move(projection));
  return list;
}

}  // namespace

std::vector<std::string> projection_names() {
  return {"latlong", "fisheye", "fisheye-equisolid", "cube", "cube-cross", "octahedral"};
}

bool shows_hemispheres(const std::string& projection_name) {
  return projection_name == "latlong" || is_fisheye(projection_name);
}

SkyPart default_part(const std::string& projection_name) {
  return is_fisheye(projection_name) ? SkyPart::hemisphere : SkyPart::sphere;
}

std::vector<std::unique_ptr<Projection>> make_projections(const ProjectionChoice& choice) {
  const auto& [name, size, asked_part] = choice;
  require_within("picture size", size, domain::kPictureSize_pixels);
  const SkyPart part = asked_part.value_or(default_part(name));
  if (name == "latlong") return alone(latlong_projection(size, part));
  if (name == "fisheye") return alone(fisheye_projection(size, part, FisheyeLaw::equidistant));
  if (name == "fisheye-equisolid") return alone(fisheye_projection(size, part, FisheyeLaw::equisolid));
  const auto names = projection_names();
  if (part == SkyPart::hemisphere && !shows_hemispheres(name))
    throw InputError("projection '{}': a hemisphere is shown by latlong, fisheye or fisheye-equisolid", name);
  if (name == "cube") return cube_face_projections(size);
  if (name == "cube-cross") return alone(cube_cross_projection(size));
  if (name == "octahedral") return alone(octahedral_projection(size));
  throw InputError("projection '{}': must be {}{}", name, listed(names), suggested(name, names));
}

Unit unit_of(const Direction& direction) {
  const double zenith = kRadiansPerDegree * direction.zenith_deg;
  const double azimuth = kRadiansPerDegree * direction.azimuth_deg;
  return {std::sin(zenith) * std::sin(azimuth), std::sin(zenith) * std::cos(azimuth), std::cos(zenith)};
}

Direction direction_of(double east, double north, double up) {
  const double azimuth_deg = kDegreesPerRadian * std::atan2(east, north);
  return {kDegreesPerRadian * std::atan2(std::hypot(east, north), up), wrapped_azimuth_deg(azimuth_deg)};
}

}  // namespace skylut
