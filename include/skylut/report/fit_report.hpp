#pragma once

#include <string>
#include <vector>

#include "skylut/core/provenance.hpp"
#include "skylut/export/sky_csv_reader.hpp"
#include "skylut/fit/fit_sky.hpp"

namespace skylut {

/// A sky from a file, as the fit took it, and what the fit found.
struct FittedSky {
  std::string file;  ///< its name
  SkyCsv sky;
  std::vector<SkyDirection> views;  ///< of its rows
  double sun_zenith_deg = 0.0;
  std::string weights;  ///< "uniform" or "solid-angle"
  SkyFit fit;
};

/// Coefficients with their standard errors, what the data do not determine, and the worst direction.
std::string fit_text(const FittedSky& fitted);

/// The same as JSON, in full precision; a number that is not finite is null.
std::string fit_json(const FittedSky& fitted, const Provenance& provenance);

}  // namespace skylut
