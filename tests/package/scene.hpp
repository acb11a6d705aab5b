#pragma once

#include <memory>
#include <skylut/atmosphere/atmosphere_description.hpp>
#include <skylut/core/context.hpp>
#include <skylut/sky/simulate_sky.hpp>

// One sky over the US Standard Atmosphere with rural haze and the sun at 45 degrees; few wavelengths, so that
// it is quick.
inline skylut::SkyScene example_scene(const skylut::Context& context) {
  skylut::SkyScene scene;
  scene.atmosphere = std::make_shared<const skylut::Atmosphere>(skylut::build_atmosphere(context, {}));
  scene.altitudes_km = {0.0};
  scene.turbidities = {{skylut::TurbidityKind::aod500, 0.2}};
  scene.suns = {{45.0, 180.0}};
  scene.directions = skylut::directions_utm271();
  scene.wavelengths = skylut::WavelengthGrid(400.0, 700.0, 50.0);
  return scene;
}
