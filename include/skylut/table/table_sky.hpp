#pragma once

#include <string>
#include <vector>

#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/colour/yxy.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/sky/sky_map.hpp"
#include "skylut/sky/sky_scene.hpp"

namespace skylut {

struct Context;

/// A sky's colours where it was looked at; azimuths count from the sun's, on either side, [0, 180].
struct SampledSky {
  std::vector<RelativeView> views;
  std::vector<Yxy> colour;              ///< [view], Y in cd/m²
  std::vector<double> solid_angles_sr;  ///< [view], the part that each stands for; none: they are alike
};

/// One sky of a table: what its formulas are fitted to, what their errors are found with, and what light
/// they leave out.
struct TableSky {
  double altitude_km = 0.0;
  Turbidity turbidity;
  Direction sun;
  double dome_ends_deg = 90.0;  ///< zenith angle at which the formula has its horizon: 90, or the geometric
  SampledSky fitted;
  SampledSky check;
  double geometric_horizon_deg = 90.0;  ///< zenith angle; beyond it lies the ground
  double Y_below_cd_m2 = 0.0;           ///< mean luminance between 90° and there; 0 on the ground
  double light_below = 0.0;             ///< its part of all the light above the geometric horizon, 0 to 1
};

/// How the skies of a table are looked at.
struct TableSampling {
  std::vector<Direction> directions;  ///< that the fits get, the same for every sky; none: dome_directions
  std::vector<Direction> map_directions;  ///< of the maps that are wanted; none: no maps
  bool to_horizon = false;                ///< the formula's horizon is the geometric one
  bool exact = false;  ///< each direction by its own line of sight; so it is with given directions
};

struct TableSkies {
  std::vector<TableSky> skies;  ///< [altitude][turbidity][sun]
  std::vector<SkyMap> maps;     ///< likewise; if asked for
  std::string instruction_set;  ///< of the solver's kernel
};

/// Simulates the skies of a table: one solution of each turbidity, in which every observer's lines of sight
/// are followed. A sky depends on the sun's azimuth by a turn alone, and on nothing else in the scene; the
/// number of threads changes nothing.
/// @param scene  its directions are not used
/// @throws       as simulate_sky
TableSkies simulate_table_skies(const Context& context, const SkyScene& scene, const TransferOptions& options,
                                const TableSampling& sampling);

}  // namespace skylut
