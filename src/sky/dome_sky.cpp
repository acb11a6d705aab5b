#include "skylut/sky/dome_sky.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sky_patch.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/core/quadrature.hpp"
#include "skylut/transfer/refraction.hpp"

namespace skylut {

namespace {

constexpr double kDomeEnds_deg = 90.0;

/// How many lines of sight and azimuths a sky is made of.
struct Nodes {
  double highest_sun_deg;
  int points;
  int limb_points;
  int azimuths;
  int limb_azimuths;
};
/// Where the sun stands overhead nothing depends on azimuth; in twilight the Earth's shadow has an edge.
constexpr Nodes kNodes[] = {{1e-9, 16, 8, 1, 1}, {90.0, 14, 6, 9, 5}, {180.0, 16, 8, 13, 9}};

const Nodes& nodes_for(double sun_zenith_deg) {
  const Nodes* nodes = kNodes;
  while (sun_zenith_deg > nodes->highest_sun_deg) ++nodes;
  return *nodes;
}

/// Calls use(index, row, direction) for every direction of the dome; neighbours of one zenith angle share a
/// row. @return the indices of the others
template <class Row, class Use>
std::vector<std::size_t> look(std::span<const Direction> directions, const Direction& sun, const Row& row_at,
                              const Use& use) {
  std::vector<std::size_t> beyond;
  std::vector<float> row;
  double zenith_deg = -1.0;  // of the row
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Direction& direction = directions[i];
    if (direction.zenith_deg > kDomeEnds_deg) {
      beyond.push_back(i);
      continue;
    }
    if (direction.zenith_deg != zenith_deg) row_at(direction.zenith_deg, row);
    zenith_deg = direction.zenith_deg;
    use(i, row, patch_direction(zenith_deg, direction.azimuth_deg - sun.azimuth_deg, sun.zenith_deg));
  }
  return beyond;
}

std::vector<Direction> picked(std::span<const Direction> directions,
                              const std::vector<std::size_t>& indices) {
  std::vector<Direction> chosen;
  for (const std::size_t index : indices) chosen.push_back(directions[index]);
  return chosen;
}

}  // namespace

DomeSky::DomeSky(std::shared_ptr<const SolvedSky> solved, double altitude_km, double sun_zenith_deg,
                 double sun_distance_au)
    : solved_(std::move(solved)),
      exact_(solved_, altitude_km, {sun_zenith_deg, 0.0}, sun_distance_au),
      scale_(1.0 / (sun_distance_au * sun_distance_au)),
      seen_sun_{apparent_sun(solved_->shells(), altitude_km, sun_zenith_deg).zenith_deg, 0.0} {
  const double planet_km = apparent_shells(solved_->shells()).planet_radius_km;
  const double apparent_km = apparent_altitude_km(solved_->shells(), altitude_km);
  dome_ = std::make_unique<SkyPatch>(ZenithPanel::whole_dome(apparent_km, planet_km),
                                     nodes_for(sun_zenith_deg).points, nodes_for(sun_zenith_deg).azimuths);
  if (exact_.horizon_zenith_deg() > kDomeEnds_deg)
    limb_ = std::make_unique<SkyPatch>(ZenithPanel::whole_limb(apparent_km, planet_km),
                                       nodes_for(sun_zenith_deg).limb_points,
                                       nodes_for(sun_zenith_deg).limb_azimuths);
}

DomeSky::~DomeSky() = default;
DomeSky::DomeSky(DomeSky&&) noexcept = default;

std::vector<DomeSky> DomeSky::under_suns(const Context& context,
                                         const std::shared_ptr<const SolvedSky>& solved, double altitude_km,
                                         std::span<const double> sun_zeniths_deg, double sun_distance_au) {
  std::vector<DomeSky> skies;
  for (const double sun_deg : sun_zeniths_deg)
    skies.push_back(DomeSky(solved, altitude_km, sun_deg, sun_distance_au));
  for (const Nodes& nodes : kNodes) {
    std::vector<DomeSky*> together;
    for (DomeSky& sky : skies)
      if (&nodes_for(sky.sun().zenith_deg) == &nodes) together.push_back(&sky);
    if (together.empty()) continue;
    follow_lines(context, together, altitude_km, &DomeSky::dome_);
    if (together.front()->limb_) follow_lines(context, together, altitude_km, &DomeSky::limb_);
  }
  return skies;
}

// Sets a patch of skies that have as many points and azimuths: line by line, then sky by sky.
void DomeSky::follow_lines(const Context& context, std::span<DomeSky* const> skies, double altitude_km,
                           std::unique_ptr<SkyPatch> DomeSky::*patch) {
  const SolvedSky& solved = *skies.front()->solved_;
  const SkyPatch& one = *(skies.front()->*patch);
  const auto points = static_cast<std::size_t>(one.points());
  const std::size_t of_point = solved.parts() * one.azimuths_deg().size() * solved.wavelengths().size();
  std::vector<double> suns_deg;
  for (const DomeSky* sky : skies) suns_deg.push_back(sky->sun().zenith_deg);
  std::vector<float> parts(points * skies.size() * of_point);  // [point][sky]...
  parallel_for(points, context.threads, [&](std::size_t point) {
    if (context.cancel.stop_requested()) throw Cancelled();
    solved.radiance_parts(
        SightFan{altitude_km, one.point_zenith_deg(static_cast<int>(point)), suns_deg, one.azimuths_deg()},
        std::span(parts).subspan(point * skies.size() * of_point, skies.size() * of_point));
  });
  parallel_for(skies.size(), context.threads, [&](std::size_t i) {
    std::vector<float> of_sky;
    for (std::size_t point = 0; point < points; ++point) {
      const auto begin = parts.begin() + static_cast<std::ptrdiff_t>((point * skies.size() + i) * of_point);
      of_sky.insert(of_sky.end(), begin, begin + static_cast<std::ptrdiff_t>(of_point));
    }
    SkyPatch& own = *(skies[i]->*patch);
    own.set_points(solved, of_sky);
    own.set_colours(solved);
  });
}

void DomeSky::radiance(std::span<const Direction> directions, std::span<float> radiance) const {
  const std::size_t width = wavelengths().size();
  SKYLUT_CHECK_EQ(radiance.size(), directions.size() * width);
  std::vector<float> scratch;
  const std::vector<std::size_t> beyond = look(
      directions, seen_sun_,
      [this](double zenith_deg, std::vector<float>& row) {
        row.resize(dome_->row_size());
        dome_->row(zenith_deg, row);
      },
      [&](std::size_t i, std::span<const float> row, const PatchDirection& direction) {
        const std::span<float> to = radiance.subspan(i * width, width);
        SkyPatch::radiance(solved_->factors_of_point(), row, direction, scratch, to);
        for (float& value : to) value *= static_cast<float>(scale_);
      });
  std::vector<float> found(beyond.size() * width);
  exact_.radiance(picked(directions, beyond), found);
  for (std::size_t i = 0; i < beyond.size(); ++i)
    std::copy_n(found.begin() + static_cast<std::ptrdiff_t>(i * width), width,
                radiance.begin() + static_cast<std::ptrdiff_t>(beyond[i] * width));
}

void DomeSky::colour(std::span<const Direction> directions, std::span<Xyz> colour) const {
  SKYLUT_CHECK_EQ(colour.size(), directions.size());
  std::vector<float> scratch;
  const std::vector<std::size_t> beyond = look(
      directions, seen_sun_,
      [this](double zenith_deg, std::vector<float>& row) {
        row.resize(dome_->colour_row_size());
        dome_->colour_row(zenith_deg, row);
      },
      [&](std::size_t i, std::span<const float> row, const PatchDirection& direction) {
        const Xyz found = SkyPatch::colour(*solved_, row, direction, scratch);
        colour[i] = {scale_ * found.X, scale_ * found.Y, scale_ * found.Z};
      });
  std::vector<Xyz> found(beyond.size());
  exact_.colour(picked(directions, beyond), found);
  for (std::size_t i = 0; i < beyond.size(); ++i) colour[beyond[i]] = found[i];
}

// By Gauss's rule in the zenith angle; azimuths crowd around the sun as squares do.
double DomeSky::luminance_below() const {
  if (!limb_) return 0.0;
  constexpr int kZeniths = 16;
  constexpr int kSteps = 48;
  const Quadrature zeniths = gauss_legendre(kZeniths, kDomeEnds_deg, horizon_zenith_deg());
  std::vector<float> row(limb_->colour_row_size());
  std::vector<float> scratch;
  double sum = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < zeniths.node.size(); ++i) {
    limb_->colour_row(zeniths.node[i], row);
    const double ring = zeniths.weight[i] * std::sin(zeniths.node[i] * kRadiansPerDegree);
    for (int k = 0; k < kSteps; ++k) {
      const double t = (k + 0.5) / kSteps;
      const PatchDirection direction = patch_direction(zeniths.node[i], 180.0 * t * t, seen_sun_.zenith_deg);
      sum += ring * t * SkyPatch::colour(*solved_, row, direction, scratch).Y;
      all += ring * t;
    }
  }
  return scale_ * sum / all;
}

}  // namespace skylut
