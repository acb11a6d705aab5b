#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "skylut/transfer/sky_radiance.hpp"

namespace skylut {

struct Context;

/// A line of sight under one sun, in several azimuths.
struct SightLine {
  double observer_altitude_km = 0.0;             ///< above the ground, in [0, top level]
  double view_zenith_deg = 0.0;                  ///< [0, 180]
  double sun_zenith_deg = 0.0;                   ///< [0, 99]
  std::span<const double> relative_azimuth_deg;  ///< [0, 180], 0 = towards the sun
};

/// A line of sight under several suns, in several azimuths each: what belongs to the line alone is worked out
/// once.
struct SightFan {
  double observer_altitude_km = 0.0;             ///< above the ground, in [0, top level]
  double view_zenith_deg = 0.0;                  ///< [0, 180]
  std::span<const double> sun_zenith_deg;        ///< [0, 99]
  std::span<const double> relative_azimuth_deg;  ///< [0, 180], 0 = towards the sun
};

/// Columns whose diffuse fields are solved and kept, so that lines of sight can be asked at any time: what
/// solve_sky_radiance does at once, taken apart. Its answers are the same, to the last bit.
///
/// The radiance is also given in parts that know no phase function. Along a straight line the scattering
/// angle Θ is constant, so that for one column
///   L = Σ_s P_s(Θ) A_s - Q1_s(Θ) B_s + Q2_s(Θ) C_s + D,
/// A_s being the amplitude of single scattering by scatterer s, B_s and C_s those of the spread of its
/// forward peak, D the rest. All that is sharp in a sky sits in the factors P, Q1, Q2; the parts A, B, C, D
/// are smooth. [theory.md §4.9]
///
/// Immutable once built; its functions may be called by several threads.
class SolvedColumns {
 public:
  /// @param sun_zeniths_deg  that will be asked for, each with its neighbours (sun bands); [0, 99]
  /// @throws  as solve_sky_radiance; InputError also if the fields of all columns do not fit the memory
  SolvedColumns(const Context& context, Shells shells, std::vector<OpticalColumn> columns,
                std::span<const double> sun_zeniths_deg, const TransferOptions& options);
  ~SolvedColumns();
  SolvedColumns(SolvedColumns&&) noexcept;
  SolvedColumns& operator=(SolvedColumns&&) noexcept;

  std::size_t columns() const;
  /// The most that a column has; parts of those that another lacks are 0.
  std::size_t scatterers() const;
  /// A of each scatterer, B of each, C of each, D; then the diffuse Q and U where TransferOptions::stokes
  /// asks.
  std::size_t parts() const;

  /// @param radiance  sr⁻¹, [column][azimuth]; >= 0
  /// @throws InputError  for values out of range, or a sun whose band was not asked for
  void radiance(const SightLine& line, std::span<float> radiance) const;

  /// The parts along several lines under one sun, as many azimuths each: neighbours in zenith angle together
  /// cost much less than one by one.
  /// @param parts  sr⁻¹, [line][part][azimuth][column]
  /// @throws  as radiance
  void radiance_parts(std::span<const SightLine> lines, std::span<float> parts) const;

  /// The parts along one line under many suns at once: a fraction of the cost of one sun after another,
  /// least where all suns are in one band (DiscretisationOptions::sun_bands off).
  /// @param parts  sr⁻¹, [sun][part][azimuth][column]
  /// @throws  as radiance
  void radiance_parts(const SightFan& fan, std::span<float> parts) const;

  /// What each part is multiplied by at a scattering angle: P_s, -Q1_s, Q2_s, 1. [part]
  void part_factors(std::size_t column, double cos_scattering_angle, std::span<double> factors) const;

  const Shells& shells() const;
  const TransferReport& report() const;

 private:
  struct Solution;
  std::unique_ptr<const Solution> solution_;
};

}  // namespace skylut
