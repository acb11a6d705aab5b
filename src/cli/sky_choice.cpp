#include "sky_choice.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "skylut/sky/continuous_sky.hpp"
#include "skylut/sky/exact_sky.hpp"

namespace skylut::cli {

std::unique_ptr<SkyLight> sky_light(const Context& context, const SceneOptions& options,
                                    const std::shared_ptr<const SolvedSky>& solved, double altitude_km,
                                    const SkyScene& scene, Provenance& provenance) {
  const Direction& sun = scene.suns.front();
  describe_into(solved->report(), provenance);
  if (options.exact()) return std::make_unique<ExactSky>(solved, altitude_km, sun, 1.0);
  auto sky = std::make_unique<ContinuousSky>(context, solved, altitude_km, sun, 1.0);
  provenance.describe("continuous_sky", {{"error", sky->error()}, {"nodes", sky->nodes()}});
  return sky;
}

}  // namespace skylut::cli
