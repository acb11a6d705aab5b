#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "skylut/core/json_reader.hpp"
#include "skylut/models/compact/cubic_spline.hpp"
#include "skylut/models/compact/layout.hpp"
#include "skylut/models/compact/zenith_grid.hpp"

namespace skylut::compact {

/// The conditions at which a compact sky was computed. The first load, 0, stands apart: up to the load of the
/// stratosphere alone, the second, everything is linear; from there on splines.
struct Nodes {
  std::vector<double> altitudes_km;
  std::vector<double> aod500;
  std::vector<double> suns_deg;
};

/// A matrix in products of few: values[i][j] = Σ_k left[i][k] right[k][j].
struct Basis {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<float> values;  ///< [row][column]
};

/// The numbers of a compact sky as its file holds them: a truncated higher-order singular value decomposition
/// (De Lathauwer, De Moor, Vandewalle 2000, doi:10.1137/S0895479896305696) of spline coefficients,
///   feature[load][altitude][sun][zenith][number] = mean + Σ_r u_r[load][altitude][sun] v_r[zenith][number],
/// u and v each in products of bases of their axes.
struct Tables {
  Nodes nodes;
  double planet_radius_km = 0.0;
  ZenithGrid::Counts zenith_counts;
  std::vector<std::string> channels;   ///< "X", "Y", "Z", then wavelengths in nm
  std::vector<double> wavelengths_nm;  ///< of the channels after the third
  std::size_t terms = 0;               ///< u_k of the haze's phase functions

  std::vector<float> haze_terms;    ///< [angle][k], Θ = π (i/(n-1))²
  double haze_mean = 0.0;           ///< ū_0
  std::vector<double> rayleigh_0;   ///< [channel] P(0°)
  std::vector<double> rayleigh_90;  ///< [channel] P(90°)
  std::vector<float>
      spherical_albedo;  ///< S of the air, for the sky and for the ground in view [2][load][channel]

  Basis load;
  Basis altitude;
  Basis sun;
  Basis zenith;
  std::size_t rank = 0;
  std::vector<float> condition_core;  ///< [rank][load basis][altitude basis][sun basis]
  std::vector<float> feature_core;    ///< [rank][zenith basis][number]
  std::vector<float> mean;            ///< [zenith][number]
  double step = 0.0;                  ///< that both cores are rounded to, of u_r v_r together

  Layout layout() const { return {channels.size(), terms}; }
};

nlohmann::ordered_json tables_json(const Tables& tables);

/// @throws InputError  naming the key
Tables read_tables(const JsonReader& model);

}  // namespace skylut::compact
