#pragma once

#include <vector>

#include "skylut/models/compact/tables.hpp"
#include "training_fields.hpp"

namespace skylut::compact {

/// Writes a training's features as products of few: first a basis for each axis alone (load, altitude, sun,
/// zenith angle), then of what conditions have in common with directions, both by eigenvectors of Gram
/// matrices: a truncated higher-order singular value decomposition. Bases are turned into spline
/// coefficients.
/// @param tolerance  root mean square of the features, weighted by what they do to a sky's light, that may be
///                   left out, per zenith angle
/// @param tables     nodes, counts, channels and terms set; bases, cores, mean, rank and step are filled
void compress(const TrainingFields& fields, double tolerance, Tables& tables);

}  // namespace skylut::compact
