#pragma once

/// Coordinates in which compact skies are smooth. [models.md]
namespace skylut::compact {

/// ln(1 + h/2 km).
double altitude_coordinate(double altitude_km);

/// ln(τ - τ_least + 0.01). @param least  the load of the stratosphere alone
double load_coordinate(double aod500, double least);

}  // namespace skylut::compact
