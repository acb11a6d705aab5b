#pragma once

#include <complex>
#include <variant>
#include <vector>

#include "kind.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/wavelength_grid.hpp"
#include "skylut/site/sun.hpp"
#include "skylut/site/time_steps.hpp"

/// Directions, places, times and wavelengths on the command line.
namespace skylut::cli {

/// Degrees clockwise from north; any turn is brought to [0, 360).
Kind<double> azimuth();

/// Suns "Z:A", zenith angle and azimuth in degrees, separated by commas.
Kind<std::vector<Direction>> suns();

/// Views "Z:A" as suns(), the azimuth counted from the sun's and folded to [0, 180].
Kind<std::vector<RelativeView>> relative_views();

/// Decimal degrees, or degrees, minutes and seconds.
Kind<double> latitude();
Kind<double> longitude();

/// A moment with its zone; a day.
Kind<UtcTime> time_of_day();
Kind<UtcTime> day();

/// Moments at equal distances, START/END/STEP: two moments with their zones and 10min, 1h or PT15M.
Kind<TimeSteps> time_steps();

/// A moment, where moments at equal distances could be meant, too; and either.
using TimeOrSteps = std::variant<UtcTime, TimeSteps>;
Kind<TimeOrSteps> one_time();
Kind<TimeOrSteps> time_or_steps();

/// A number within 0 to 1, or a name or file. Numbers are brought to their fewest digits.
Kind<std::string> albedo();

/// LO:HI:STEP in nm.
Kind<WavelengthGrid> wavelengths();

/// A refractive index "RE,IM"; IM > 0 absorbs.
Kind<std::complex<double>> refractive_index();

}  // namespace skylut::cli
