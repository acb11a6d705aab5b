#pragma once

#include <skylut/core/context.hpp>
#include <skylut/sky/simulate_sky.hpp>

// One sky over the US Standard Atmosphere with the sun at 45 degrees; few wavelengths, so that it is quick.
inline skylut::SkyScene example_scene(const skylut::Context& context) {
  skylut::SkyScene scene;
  scene.profile = skylut::load_profile(context, "ussa1976");
  scene.altitudes_km = {0.0};
  scene.turbidities = {{skylut::TurbidityKind::aod500, 0.2}};
  scene.suns = {{45.0, 180.0}};
  scene.directions = skylut::directions_utm271();
  scene.wavelengths = skylut::WavelengthGrid(400.0, 700.0, 50.0);
  return scene;
}
