#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "skylut/transfer/solved_columns.hpp"

namespace skylut::compact {

/// The functions of the scattering angle that everything but the molecules scatters by, of all loads and
/// wavelengths, in the span of few: f_j(Θ) ≈ Σ_k u_k(Θ) v_kj by a truncated singular value decomposition,
/// relative to their sum and weighted by how bright each is.
class HazeTerms {
 public:
  static constexpr std::size_t kAngles = 1024;  ///< Θ = π (i/(kAngles-1))²

  /// @param brightness  typical amplitude of every part of every column, [column][part]
  HazeTerms(const SolvedColumns& columns, const Eigen::MatrixXd& brightness, std::size_t terms);

  std::size_t terms() const { return terms_; }
  /// u_k, [angle][k]
  const std::vector<float>& functions() const { return functions_; }
  /// Mean of u_0 over all directions.
  double mean() const { return mean_; }
  /// v_k of a part of a column: what its amplitude adds to that of u_k. 0 for molecules and diffuse light.
  double share(std::size_t k, std::size_t column, std::size_t part) const {
    return share_[k](static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(part));
  }

 private:
  std::size_t terms_;
  std::vector<float> functions_;
  double mean_ = 0.0;
  std::vector<Eigen::MatrixXd> share_;  // [k] (column, part)
};

}  // namespace skylut::compact
