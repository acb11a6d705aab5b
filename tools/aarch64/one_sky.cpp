// A small sky by every kernel that all machines have, printed to the last digit. Exit code 1 if they differ
// by more than 1e-5.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "skylut/core/context.hpp"
#include "skylut/transfer/sky_radiance.hpp"

int main() {
  using namespace skylut;
  const Shells shells{{0.0, 1.0, 3.0, 10.0, 30.0, 100.0}, 6371.0};
  const OpticalColumn column{
      {0.12, 0.1, 0.05, 0.02, 0.001},
      {{std::make_shared<const RayleighPhaseFunction>(), {0.02, 0.03, 0.03, 0.01, 0.001}},
       {std::make_shared<const HenyeyGreensteinPhaseFunction>(0.75), {0.09, 0.06, 0.01, 0.001, 0.0}}},
      0.2};
  const SkyRequest request{
      {0.0, 3.0}, {30.0, 80.0, 92.0}, {{0.0, 0.0}, {60.0, 45.0}, {89.0, 120.0}, {95.0, 10.0}}};
  TransferOptions options;
  options.discretisation = discretisation_of(Quality::draft);
  Context context;
  std::vector<float> radiance;
  for (const Simd simd : {Simd::portable, Simd::reference}) {
    context.simd = simd;
    const SkyRadiance sky = solve_sky_radiance(context, shells, std::span(&column, 1), request, options);
    for (std::size_t o = 0; o < 2; ++o)
      for (std::size_t s = 0; s < 3; ++s)
        for (std::size_t v = 0; v < 4; ++v) {
          radiance.push_back(sky.at(0, o, s, v));
          fmt::print("{} {} {} {} {:.9g}\n", sky.report().kernel, o, s, v, radiance.back());
        }
  }
  const std::size_t count = radiance.size() / 2;
  for (std::size_t i = 0; i < count; ++i)
    if (!(std::abs(radiance[i] / radiance[count + i] - 1.0f) < 1e-5f)) return 1;
}
