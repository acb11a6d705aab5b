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
/// homogeneous layers over a Lambertian ground. A column is one "lane" of the solver.
struct OpticalColumn {
  std::vector<double>
      extinction_depth;  ///< vertical optical depth, per layer, bottom to top; scattering included
  std::vector<Scatterer> scatterers;  ///< Σ scattering_depth <= extinction_depth in every layer
  double ground_albedo = 0.0;         ///< Lambertian, [0, 1]
};

/// The layers that all columns of a computation share.
struct Shells {
  std::vector<double> levels_km;     ///< layer boundaries above the ground, ascending, the first is 0
  double planet_radius_km = 6371.0;  ///< of the ground, [100, ∞)
};

}  // namespace skylut
