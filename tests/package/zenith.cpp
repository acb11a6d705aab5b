#include "zenith.hpp"

#include "scene.hpp"

double zenith_luminance_cd_m2(const char* profiles_folder) {
  skylut::Context context;
  context.data_folder = profiles_folder;
  skylut::SkyScene scene = example_scene(context);
  scene.directions = {{0.0, 0.0}};
  return skylut::simulate_sky(context, scene, {}).front().colour.front().Y;
}
