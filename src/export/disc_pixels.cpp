#include "export/disc_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "skylut/core/domain.hpp"

namespace skylut {

namespace {

// Of a point to the next, in heights of the finest pixels: so that a pixel within the disc holds some 64.
constexpr double kSpacing = 1.0 / 8.0;
constexpr double kMostValues = 8e6;  // of all points' spectra: 64 MB

// The same for all faces of a cube: points of several sets would not add up to one disc.
double spacing_deg(const SunDisc& disc, const Projection& projection) {
  const double finest_pixel_deg = 90.0 / std::min(projection.width(), projection.height());
  // See SunDisc::points().
  const double fewest_deg = 5.0 * disc.angular_radius_deg() *
                            std::sqrt(static_cast<double>(disc.wavelengths().size()) / kMostValues);
  return std::clamp(std::max(kSpacing * finest_pixel_deg, fewest_deg), domain::kDiscSpacing_deg.lowest,
                    domain::kDiscSpacing_deg.highest);
}

int pixel_at(double place, int pixels) { return std::min(static_cast<int>(place), pixels - 1); }

}  // namespace

DiscPixels::DiscPixels(const SunDisc& disc, const Projection& projection) {
  const SunDiscPoints points = disc.points(spacing_deg(disc, projection));
  const std::size_t wavelengths = disc.wavelengths().size();
  std::map<std::pair<int, int>, Pixel> pixels;
  for (std::size_t p = 0; p < points.directions.size(); ++p) {
    const std::optional<PicturePoint> at = projection.point_of(points.directions[p]);
    if (!at) continue;
    const int row = pixel_at(at->y, projection.height());
    const int column = pixel_at(at->x, projection.width());
    Pixel& pixel = pixels[{row, column}];
    if (pixel.radiance.empty()) pixel = {row, column, {}, std::vector<double>(wavelengths)};
    const Xyz& lux = points.illuminance[p];
    pixel.colour = {pixel.colour.X + lux.X, pixel.colour.Y + lux.Y, pixel.colour.Z + lux.Z};
    for (std::size_t i = 0; i < wavelengths; ++i) pixel.radiance[i] += points.irradiance[p * wavelengths + i];
  }
  for (auto& [place, pixel] : pixels) {
    const double solid_angle_sr = projection.solid_angle_sr(pixel.column, pixel.row);
    for (double Xyz::*channel : {&Xyz::X, &Xyz::Y, &Xyz::Z}) pixel.colour.*channel /= solid_angle_sr;
    for (double& radiance : pixel.radiance) radiance /= solid_angle_sr;
    pixels_.push_back(std::move(pixel));
  }
}

void DiscPixels::add_to_row(int row, std::span<Xyz> colour, std::span<float> radiance) const {
  const auto above = [](const Pixel& pixel, int of) { return pixel.row < of; };
  for (auto pixel = std::lower_bound(pixels_.begin(), pixels_.end(), row, above);
       pixel != pixels_.end() && pixel->row == row; ++pixel) {
    const auto column = static_cast<std::size_t>(pixel->column);
    for (double Xyz::*channel : {&Xyz::X, &Xyz::Y, &Xyz::Z})
      colour[column].*channel += pixel->colour.*channel;
    if (radiance.empty()) continue;
    float* const spectrum = &radiance[column * pixel->radiance.size()];
    for (std::size_t i = 0; i < pixel->radiance.size(); ++i)
      spectrum[i] = static_cast<float>(static_cast<double>(spectrum[i]) + pixel->radiance[i]);
  }
}

}  // namespace skylut
