#pragma once

#include "options/kind.hpp"
#include "skylut/fit/fit_sky.hpp"

namespace skylut::cli {

/// How much each direction counts in a fit: uniform, solid-angle or horizon.
inline Kind<SampleWeights> weights_kind() {
  return choice<SampleWeights>({{"uniform", SampleWeights::uniform},
                                {"solid-angle", SampleWeights::solid_angle},
                                {"horizon", SampleWeights::horizon}});
}

}  // namespace skylut::cli
