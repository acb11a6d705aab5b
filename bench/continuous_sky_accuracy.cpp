// The continuous sky against lines of sight: at random directions of the whole sphere, half of them near the
// horizon or the sun, the largest and the 99th percentile of the relative error of radiance at 8 wavelengths
// and of luminance, with what building the sky took. One line per altitude, load and sun.
//
// continuous_sky_accuracy [AEROSOL [TOLERANCE [DIRECTIONS [ALTITUDE_KM]]]]

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>

#include "skylut/atmosphere/atmosphere_description.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/sky/continuous_sky.hpp"
#include "skylut/sky/sky_scene.hpp"
#include "skylut/sky/view_set.hpp"
#include "support/test_context.hpp"

namespace {

using namespace skylut;

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A quarter near the horizon, a quarter near the sun, half anywhere.
std::vector<Direction> random_directions(std::size_t count, double horizon_deg, const Direction& sun) {
  std::mt19937_64 random(20261127);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  std::vector<Direction> directions;
  while (directions.size() < count) {
    const double azimuth_deg = 360.0 * uniform();
    const std::size_t kind = directions.size() % 4;
    if (kind == 0) {
      const double sign = uniform() < 0.5 ? -1.0 : 1.0;
      directions.push_back({std::min(180.0, horizon_deg + sign * 6.0 * std::pow(uniform(), 2)), azimuth_deg});
    } else if (kind == 1) {
      const double zenith_deg = sun.zenith_deg + 10.0 * (2.0 * uniform() - 1.0);
      const double azimuth = sun.azimuth_deg + 10.0 * (2.0 * uniform() - 1.0);
      directions.push_back({std::abs(zenith_deg), azimuth < 0.0 ? azimuth + 360.0 : azimuth});
    } else {
      directions.push_back({std::acos(1.0 - 2.0 * uniform()) * kDegreesPerRadian, azimuth_deg});
    }
  }
  return directions;
}

}  // namespace

int main(int argc, char** argv) {
  const Context& context = test::context;
  AtmosphereDescription description;
  description.profile = "ussa1976";
  if (argc > 1) description.aerosol = argv[1];
  ContinuousSkyOptions options;
  if (argc > 2) options.tolerance = std::atof(argv[2]);
  const auto count = static_cast<std::size_t>(argc > 3 ? std::atoi(argv[3]) : 2000);
  std::vector<double> altitudes_km{0.0, 1.0, 6.0, 12.0, 30.0};
  if (argc > 4) altitudes_km = {std::atof(argv[4])};
  SkyScene scene;
  scene.atmosphere = std::make_shared<const Atmosphere>(build_atmosphere(context, description));
  scene.wavelengths = WavelengthGrid(380.0, 730.0, 50.0);
  scene.altitudes_km = {0.0};
  for (const double sun_deg : {0.0, 30.0, 75.0, 88.0, 90.0, 92.0, 94.0})
    scene.suns.push_back({sun_deg, 90.0});
  fmt::print(
      "altitude_km,aod500,sun_zenith_deg,nodes,own_error,cpu_s,p99,worst,worst_zenith_deg,worst_azimuth_deg,"
      "worst_nm,worst_Y\n");
  for (const double load : {0.0, 0.1, 1.0}) {
    scene.turbidities = {{TurbidityKind::aod500, load}};
    const auto solved = std::make_shared<const SolvedSky>(context, scene, TransferOptions{});
    const std::size_t width = scene.wavelengths.size();
    for (const double altitude_km : altitudes_km)
      for (const Direction& sun : scene.suns) {
        const double start_s = cpu_s();
        const ContinuousSky sky(context, solved, altitude_km, sun, 1.0, options);
        const double took_s = cpu_s() - start_s;
        const std::vector<Direction> directions = random_directions(count, sky.horizon_zenith_deg(), sun);
        std::vector<float> found(count * width);
        sky.radiance(directions, found);
        std::vector<Xyz> colours(count);
        sky.colour(directions, colours);
        std::vector<double> errors;
        std::size_t worst = 0;
        double worst_nm = 0.0;
        double worst_Y = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
          const RelativeView view = relative_view(directions[i], sun);
          std::vector<float> exact(width);
          const double azimuth = view.relative_azimuth_deg;
          solved->radiance({altitude_km, view.zenith_deg, sun.zenith_deg, std::span(&azimuth, 1)}, exact);
          double error = 0.0;
          double nm = 0.0;
          double Y = 0.0;
          for (std::size_t k = 0; k < width; ++k) {
            Y += solved->colour_weights()[k].Y * static_cast<double>(exact[k]);
            const double ratio = static_cast<double>(found[i * width + k] / exact[k]);
            // What is not a number is no small error, and would be less than none in every comparison.
            const double relative =
                exact[k] > 0.0f ? (std::isfinite(ratio) ? std::abs(ratio - 1.0) : HUGE_VAL) : 0.0;
            if (relative > error) {
              error = relative;
              nm = scene.wavelengths[k];
            }
          }
          if (Y > 0.0) worst_Y = std::max(worst_Y, std::abs(colours[i].Y / Y - 1.0));
          errors.push_back(error);
          if (error == *std::max_element(errors.begin(), errors.end())) {
            worst = i;
            worst_nm = nm;
          }
        }
        const double largest = errors[worst];
        std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(count * 99 / 100),
                         errors.end());
        fmt::print("{},{},{},{},{:.5f},{:.3f},{:.5f},{:.5f},{:.3f},{:.2f},{},{:.5f}\n", altitude_km, load,
                   sun.zenith_deg, sky.nodes(), sky.error(), took_s, errors[count * 99 / 100], largest,
                   directions[worst].zenith_deg, relative_view(directions[worst], sun).relative_azimuth_deg,
                   worst_nm, worst_Y);
        std::fflush(stdout);
      }
  }
  return 0;
}
