#pragma once

#include <memory>
#include <utility>

#include "skylut/atmosphere/atmosphere.hpp"
#include "support/test_context.hpp"

namespace skylut::test {

/// The 1976 standard atmosphere with a Henyey-Greenstein haze, quick to build.
inline std::shared_ptr<const Atmosphere> standard_atmosphere(AtmosphereOptions options = {}) {
  return std::make_shared<const Atmosphere>(context, load_profile(context, "ussa1976"), std::move(options));
}

}  // namespace skylut::test
