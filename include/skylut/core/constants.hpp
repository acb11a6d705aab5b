#pragma once

#include <numbers>

/// Physical and mathematical constants, each stated once, with its source.
namespace skylut {

inline constexpr double kPi = std::numbers::pi;

/// Degrees outside, radians inside: the only conversions.
inline constexpr double kRadiansPerDegree = kPi / 180.0;
inline constexpr double kDegreesPerRadian = 180.0 / kPi;

/// Mean Earth radius, IUGG R1 = (2a + b)/3 of WGS84, rounded to the km (solver cases use 6371).
inline constexpr double kMeanEarthRadius_km = 6371.0;

/// Avogadro constant, 1/mol. SI 2019, exact.
inline constexpr double kAvogadro_per_mol = 6.02214076e23;

/// Boltzmann constant, J/K. SI 2019, exact.
inline constexpr double kBoltzmann_J_per_K = 1.380649e-23;

/// Standard gravity, m/s². 3rd CGPM 1901, exact; US Standard Atmosphere 1976 uses the same g0.
inline constexpr double kStandardGravity_m_s2 = 9.80665;

/// Standard atmosphere, hPa (ISO 2533, ISA sea level).
inline constexpr double kStandardPressure_hPa = 1013.25;

/// One Dobson unit as a number column, molecules/m² (0.01 mm of gas at 273.15 K, 1013.25 hPa).
inline constexpr double kDobsonUnit_per_m2 = 2.6867801e20;

/// Maximum luminous efficacy K_m = 683 lm/W at 540 THz scaled to the peak of V(λ): 683.002 lm/W (CIE
/// 15:2004).
inline constexpr double kLuminousEfficacy_lm_per_W = 683.002;

}  // namespace skylut
