#pragma once

#include <cstddef>
#include <vector>

#include "skylut/core/directions.hpp"

namespace skylut {

/// Directions of the dome above 90°, and what each stands for.
struct DomeViews {
  std::vector<Direction> views;
  std::vector<double> solid_angle;  ///< sr, [view]; those of a whole dome sum to 2π
};

/// What a direction counts in a fit: its solid angle, but in the rings around the sun a tenth of the others'
/// at least. By solid angle alone the aureole, small as it is, would be left to itself.
double fit_weight(const DomeViews& dome, std::size_t view);

/// Directions that leave little of a dome unseen: the zenith; points of a spiral of equal solid angles, on
/// one side of the sun's vertical plane, whose lowest lies 0.1° above the horizon; and rings around the sun,
/// where the spiral is too coarse, from 0.75° on.
/// @param sun  zenith angle [0, 99]
DomeViews fitting_views(const Direction& sun);

/// Others, more than twice as many, from 0.5° around the sun on: none of them, but for the zenith, is one of
/// fitting_views.
DomeViews checking_views(const Direction& sun);

}  // namespace skylut
