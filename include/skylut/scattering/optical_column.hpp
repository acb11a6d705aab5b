#pragma once

#include <memory>
#include <vector>

#include "skylut/scattering/phase_function.hpp"

namespace skylut {

/// One kind of scatterer in a column: its phase function and its VERTICAL scattering optical depth
/// in each layer.
struct Scatterer {
  std::shared_ptr<const PhaseFunction> phase;
  std::vector<double> scattering_depth;  ///< per layer, bottom to top, >= 0
};

/// Everything that radiative transfer must know of the air at one wavelength and one aerosol load:
/// homogeneous layers over a Lambertian ground. The solver works on several columns at a time.
struct OpticalColumn {
  /// Vertical optical depth, per layer, bottom to top; scattering included.
  std::vector<double> extinction_depth;
  /// Any number, none for air that only absorbs; Σ scattering_depth <= extinction_depth in every layer.
  std::vector<Scatterer> scatterers;
  double ground_albedo = 0.0;  ///< Lambertian, [0, 1]
};

/// The layers that all columns of a computation share.
struct Shells {
  /// Layer boundaries above the ground, ascending, the first is 0, the last at most 10,000.
  std::vector<double> levels_km;
  double planet_radius_km = 6371.0;  ///< of the ground, [1000, 1e9]
  /// Refractive index minus 1 at every level, [0, 1), the same for all columns; empty: light goes straight.
  std::vector<double> refractivity = {};
};

}  // namespace skylut
