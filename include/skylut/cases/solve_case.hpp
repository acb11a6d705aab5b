#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "skylut/transfer/sky_radiance.hpp"

namespace skylut {

struct Context;

enum class SolveMethod { standard, monte_carlo };

struct SolveOptions {
  SolveMethod method = SolveMethod::standard;
  DiscretisationOptions discretisation = discretisation_of(Quality::standard);  ///< of the spherical solver
  int orders = 0;                                                               ///< 0: all
  std::uint64_t photons = 100'000;  ///< Monte Carlo, per direction
  std::uint64_t seed = 1;
};

/// Solves one case file of explicit layers, in either schema
/// (docs/plane-parallel-and-monte-carlo.md §4), and returns the same document, keys in the same order, with
/// our radiances (and fluxes) in place of those in it.
///
/// `"polarised": true` adds `stokes_q`, `stokes_u` (and `std_q`, `std_u`) to every result, or to `outputs`;
/// `not_used` names elements of scattering matrices that belong to V.
///
/// Changed: `results[].radiance` and `.std` (0 for a deterministic solver), `results[].photons` (Monte
/// Carlo: ours; else removed), `stokes_q`, `.std_q`, `.stokes_u`, `.std_u` where the case is `polarised`
/// (Monte Carlo only), `fluxes`; `outputs.radiance` and `.flux_*`, `streams_used`; `convergence` is removed
/// (it judged the old numbers); `reference` names this program, `instruction_set` the build of the spherical
/// solver. All else is kept.
///
/// @param document  parsed file; `path` names it in messages
/// @throws InputError  naming file, key, value and what would be right
/// @throws WorkError   for a class of problem that no solver here can do
nlohmann::ordered_json solve_case(const Context& context, const nlohmann::ordered_json& document,
                                  const std::string& path, const SolveOptions& options);

}  // namespace skylut
