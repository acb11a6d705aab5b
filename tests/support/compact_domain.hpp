#pragma once

#include "skylut/models/sky_model.hpp"

namespace skylut::test {

/// The domain of the form `skylut`.
inline ModelInfo compact_domain() {
  ModelInfo info;
  info.name = "test";
  info.altitude_km = {0.0, 30.0, "km"};
  info.turbidity = {0.0, 1.0, ""};
  info.albedo = Range{0.0, 1.0, ""};
  info.sun_zenith_deg = {0.0, 96.0, "deg"};
  info.view_zenith_deg = {0.0, 180.0, "deg"};
  return info;
}

}  // namespace skylut::test
