#include "export/pixel_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

constexpr double kWidest_deg = 5.0;  // midpoint rule on cos θ: (5°)²/24 = 3e-4

// Widths against the distance from what they must resolve. A light that goes as 1/distance is summed by the
// midpoint rule to width²/(12 distance²): 2 % next to the horizon, whose light is even nearer to linear, and
// 0.5 % in the aureole, which lights more.
constexpr double kHorizonGrading = 0.5;
constexpr double kSunGrading = 0.2;
constexpr double kFinestAtSun_deg = 0.05;  // the solar disc is 0.27° in radius

// Pieces that the horizon itself crosses. Where it runs along the pixel's edge (latlong) all pieces in its
// way err alike, so that they must be fine; where it slants their errors cancel, and several a pixel do:
// s/√(1/s) of the jump, for pieces of s of the pixel.
constexpr double kFinestAlongHorizon_deg = 0.02;
constexpr double kAligned = 0.05;     // change of zenith angle along the horizon against that across
constexpr double kFewestParts = 3.5;  // so that four of about equal span will do
constexpr double kMostParts = 7.0;
constexpr double kWide_deg = 1.0;  // pixels that take the most
constexpr int kCutsAtARim = 2;     // each way, of a pixel that a fisheye's circle crosses
constexpr double kTouching_deg = 1e-9;

}  // namespace

// A rectangle of the picture.
struct PixelPieces::Piece {
  double left;
  double right;
  double top;
  double bottom;
  std::size_t column;
  int cuts_across;
  int cuts_down;

  double middle_x() const { return 0.5 * (left + right); }
  double middle_y() const { return 0.5 * (top + bottom); }
};

// Where a piece lies in the sky, by its corners and its middle.
struct PixelPieces::Extent {
  int directions = 0;  // of the 5
  std::optional<Direction> middle;
  double lowest_zenith_deg = std::numeric_limits<double>::infinity();
  double highest_zenith_deg = -std::numeric_limits<double>::infinity();
  double zenith_across_deg = 0.0;  // change from left to right
  double zenith_down_deg = 0.0;
  double radius_deg = 0.0;  // bound on the distance from the middle to a corner

  // Upper left, upper right, lower left, lower right.
  using Corners = std::array<std::optional<Direction>, 4>;

  static Extent of(const Projection& projection, const Piece& piece) {
    return {projection.direction_at(piece.middle_x(), piece.middle_y()),
            {projection.direction_at(piece.left, piece.top), projection.direction_at(piece.right, piece.top),
             projection.direction_at(piece.left, piece.bottom),
             projection.direction_at(piece.right, piece.bottom)}};
  }

  Extent(const std::optional<Direction>& middle_direction, const Corners& corners)
      : middle(middle_direction) {
    include(middle);
    for (const auto& corner : corners) include(corner);
    if (directions < 5) return;
    const auto step = [](const std::optional<Direction>& a, const std::optional<Direction>& b) {
      return std::abs(a->zenith_deg - b->zenith_deg);
    };
    zenith_across_deg = std::max(step(corners[0], corners[1]), step(corners[2], corners[3]));
    zenith_down_deg = std::max(step(corners[0], corners[2]), step(corners[1], corners[3]));
    const double sine = std::sin(kRadiansPerDegree * middle->zenith_deg);
    for (const auto& corner : corners) {
      const double turn_deg = folded_relative_azimuth_deg(corner->azimuth_deg, middle->azimuth_deg);
      radius_deg = std::max(radius_deg, std::hypot(step(corner, middle), sine * turn_deg));
    }
  }

  double zenith_span_deg() const { return std::max(0.0, highest_zenith_deg - lowest_zenith_deg); }

  // Above the horizon < 0, below it > 0, crossed by it 0.
  int side_of(double horizon_zenith_deg) const {
    if (lowest_zenith_deg > horizon_zenith_deg - kTouching_deg) return 1;
    return highest_zenith_deg < horizon_zenith_deg + kTouching_deg ? -1 : 0;
  }

  // Of a pixel: the span of its finest pieces at the horizon.
  double finest_deg(double horizon_zenith_deg) const {
    const auto [along, across] = std::minmax(zenith_across_deg, zenith_down_deg);
    const double parts = zenith_span_deg() > kWide_deg ? kMostParts : kFewestParts;
    if (directions < 5 || along > kAligned * across)
      return std::max(kFinestAlongHorizon_deg, zenith_span_deg() / parts);
    if (side_of(horizon_zenith_deg) != 0) return kFinestAlongHorizon_deg;
    return std::min(kFinestAlongHorizon_deg, zenith_span_deg() / kFewestParts);
  }

 private:
  void include(const std::optional<Direction>& direction) {
    if (!direction) return;
    ++directions;
    lowest_zenith_deg = std::min(lowest_zenith_deg, direction->zenith_deg);
    highest_zenith_deg = std::max(highest_zenith_deg, direction->zenith_deg);
  }
};

enum class PixelPieces::Cut { none, across, down, both };

PixelPieces::PixelPieces(const Projection& projection, double horizon_zenith_deg, const Direction& sun)
    : projection_(projection),
      horizon_zenith_deg_(horizon_zenith_deg),
      sun_(sun),
      sun_in_sky_(sun.zenith_deg < horizon_zenith_deg + 1.0) {}

PixelPieces::Cut PixelPieces::cut_of(const Piece& piece, const Extent& extent, double finest_deg) const {
  if (extent.directions < 5)
    return std::min(piece.cuts_across, piece.cuts_down) < kCutsAtARim ? Cut::both : Cut::none;
  if (2.0 * extent.radius_deg > kWidest_deg) return Cut::both;

  const double distance_deg = std::max(horizon_zenith_deg_ - extent.highest_zenith_deg,
                                       extent.lowest_zenith_deg - horizon_zenith_deg_);
  const double allowed_deg = std::max(finest_deg, kHorizonGrading * distance_deg);
  if (extent.zenith_span_deg() > allowed_deg + kTouching_deg)
    return extent.zenith_across_deg > extent.zenith_down_deg ? Cut::across : Cut::down;

  if (!sun_in_sky_) return Cut::none;
  const auto too_wide = [&](double middle_to_sun_deg) {
    const double nearest_deg = std::max(0.0, middle_to_sun_deg - extent.radius_deg);
    return 2.0 * extent.radius_deg > std::max(kFinestAtSun_deg, kSunGrading * nearest_deg);
  };
  // The difference of zenith angles is a cheap bound from below.
  if (!too_wide(std::abs(extent.middle->zenith_deg - sun_.zenith_deg))) return Cut::none;
  return too_wide(kDegreesPerRadian * angle_between(*extent.middle, sun_)) ? Cut::both : Cut::none;
}

void PixelPieces::collect(const Piece& piece, const Extent& extent, double finest_deg,
                          std::vector<PixelSample>& samples) const {
  const Cut cut = cut_of(piece, extent, finest_deg);
  if (cut == Cut::none) {
    if (!extent.middle) return;
    const double area = (piece.right - piece.left) * (piece.bottom - piece.top);
    const double weight = area * projection_.density_sr(piece.middle_x(), piece.middle_y());
    samples.push_back({*extent.middle, weight, piece.column});
    return;
  }
  Piece first = piece;
  Piece second = piece;
  // Both ways: first one, then the halves the other.
  if (cut == Cut::across || (cut == Cut::both && piece.cuts_across < piece.cuts_down)) {
    first.right = second.left = piece.middle_x();
    first.cuts_across = second.cuts_across = piece.cuts_across + 1;
  } else {
    first.bottom = second.top = piece.middle_y();
    first.cuts_down = second.cuts_down = piece.cuts_down + 1;
  }
  collect(first, Extent::of(projection_, first), finest_deg, samples);
  collect(second, Extent::of(projection_, second), finest_deg, samples);
}

std::vector<PixelSample> PixelPieces::of_columns(int row, int first_column, int last_column) const {
  std::vector<PixelSample> samples;
  samples.reserve(static_cast<std::size_t>(last_column - first_column));
  // Neighbours share corners.
  const auto corners_at = [&](int column) {
    return std::array{projection_.direction_at(column, row), projection_.direction_at(column, row + 1)};
  };
  auto right = corners_at(first_column);
  for (int column = first_column; column < last_column; ++column) {
    const auto left = right;
    right = corners_at(column + 1);
    const auto index = static_cast<std::size_t>(column - first_column);
    const Piece pixel{
        static_cast<double>(column), column + 1.0, static_cast<double>(row), row + 1.0, index, 0, 0};
    const Extent extent(projection_.direction(column, row), {left[0], right[0], left[1], right[1]});
    const std::size_t first = samples.size();
    collect(pixel, extent, extent.finest_deg(horizon_zenith_deg_), samples);
    double sum = 0.0;
    for (std::size_t i = first; i < samples.size(); ++i) sum += samples[i].weight;
    for (std::size_t i = first; i < samples.size(); ++i)
      samples[i].weight = sum > 0.0 ? samples[i].weight / sum : 0.0;
  }
  return samples;
}

}  // namespace skylut
