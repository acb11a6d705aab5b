#pragma once

#include <vector>

#include "skylut/models/compact/tables.hpp"
#include "training_fields.hpp"

namespace skylut::compact {

/// What compression left out, as root mean square of features weighted by what they do to a sky's light, per
/// zenith angle.
struct Compression {
  std::size_t rank = 0;
  double left_out = 0.0;
};

/// Writes a training's features as products of few: first a basis for each axis alone (load, altitude, sun,
/// zenith angle), then of what conditions have in common with directions, both by eigenvectors of Gram
/// matrices: a truncated higher-order singular value decomposition. Bases are turned into spline
/// coefficients.
/// @param tolerance  that the features may be left with, see Compression
/// @param tables     nodes, counts, channels and terms set; bases, cores, mean, rank and step are filled
Compression compress(const TrainingFields& fields, double tolerance, Tables& tables);

}  // namespace skylut::compact
