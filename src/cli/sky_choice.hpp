#pragma once

#include <memory>

#include "scene_options.hpp"
#include "skylut/sky/sky_light.hpp"
#include "skylut/sky/solved_sky.hpp"

namespace skylut::cli {

/// The sky under a scene's first sun: continuous, or with --exact line of sight by line of sight. Says in the
/// provenance how it was solved and how well.
std::unique_ptr<SkyLight> sky_light(const Context& context, const SceneOptions& options,
                                    const std::shared_ptr<const SolvedSky>& solved, double altitude_km,
                                    const SkyScene& scene, Provenance& provenance);

}  // namespace skylut::cli
