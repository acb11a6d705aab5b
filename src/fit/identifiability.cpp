#include "identifiability.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "skylut/core/check.hpp"

namespace skylut::fit_detail {

namespace {

// A coefficient known to within this is known, however small it is.
constexpr double kNegligible = 0.1;
// Below this share of the largest singular value a direction moves no residual beyond rounding.
constexpr double kRankTolerance = 1e-8;
// What moves a coefficient by less than this share of its size leaves it where it is.
constexpr double kStays = 1e-6;

}  // namespace

std::vector<Identifiability> identifiability(const FitAtMinimum& fit) {
  const Eigen::Index count = fit.jacobian.cols();
  SKYLUT_CHECK_EQ(fit.coefficient_derivatives.cols(), count);
  SKYLUT_CHECK_EQ(fit.coefficients.size(), static_cast<std::size_t>(count));
  Eigen::VectorXd scale(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double norm = fit.jacobian.col(i).norm();
    scale(i) = norm > 0.0 ? 1.0 / norm : 1.0;
  }
  const Eigen::MatrixXd scaled = fit.jacobian * scale.asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinV);
  const Eigen::MatrixXd moves = fit.coefficient_derivatives * scale.asDiagonal() * svd.matrixV();

  std::vector<Identifiability> result(fit.coefficients.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const double size = std::max(std::abs(fit.coefficients[index]), kNegligible);
    double sum = 0.0;
    bool fixed = true;
    for (Eigen::Index k = 0; k < count; ++k) {
      const double singular = svd.singularValues()(k);
      if (singular > kRankTolerance * svd.singularValues()(0))
        sum += moves(i, k) * moves(i, k) / (singular * singular);
      else if (std::abs(moves(i, k)) > kStays * size * moves.col(k).cwiseAbs().maxCoeff())
        fixed = false;
    }
    result[index].standard_error =
        fixed ? std::sqrt(fit.variance * sum) : std::numeric_limits<double>::infinity();
    result[index].determined = fixed && std::sqrt(fit.careful_variance * sum) <= size;
  }
  return result;
}

}  // namespace skylut::fit_detail
