// Simulates one sky, prints the zenith's colour and the luminance's coefficients.
#include <cstdio>
#include <exception>
#include <skylut/fit/fit_sky.hpp>

#include "scene.hpp"
#include "zenith.hpp"

int main() {
  try {
    skylut::Context context;
    context.data_folder = PROFILES_FOLDER;
    const skylut::SkyMap map = skylut::simulate_sky(context, example_scene(context), {}).front();
    const skylut::Yxy& zenith = map.colour.front();
    std::printf("zenith Y %.1f cd/m2, x %.4f, y %.4f\n", zenith.Y, zenith.x, zenith.y);
    if (zenith_luminance_cd_m2(PROFILES_FOLDER) != zenith.Y) {
      std::puts("the shared object sees another sky");
      return 1;
    }
    const skylut::SkyFit fit = skylut::fit_sky(map.directions, map.colour, map.sun);
    const skylut::PerezCoefficients& k = fit.Y.coefficients;
    std::printf("A %.4f B %.4f C %.4f D %.4f E %.4f, RMSE %.4f\n", k.A, k.B, k.C, k.D, k.E, fit.Y.rmse);
    return 0;
  } catch (const std::exception& error) {
    std::puts(error.what());
    return 1;
  }
}
