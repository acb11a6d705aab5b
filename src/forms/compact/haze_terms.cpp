#include "haze_terms.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::compact {

namespace {

/// Angles that the decomposition looks at.
constexpr std::size_t kEvery = 4;

double angle(std::size_t i) {
  const double t = static_cast<double>(i) / (HazeTerms::kAngles - 1);
  return kPi * t * t;
}

}  // namespace

HazeTerms::HazeTerms(const SolvedColumns& columns, const Eigen::MatrixXd& brightness, std::size_t terms)
    : terms_(terms) {
  const std::size_t parts = columns.parts();
  const std::size_t scatterers = columns.scatterers();
  // The parts of molecules, the first scatterer, and the diffuse light are left out.
  std::vector<std::size_t> wanted;
  for (std::size_t part = 0; part + 1 < parts; ++part)
    if (part % scatterers != 0) wanted.push_back(part);
  const auto count = static_cast<Eigen::Index>(columns.columns() * wanted.size());
  const auto angles = static_cast<Eigen::Index>(kAngles);
  Eigen::MatrixXd bright(angles, count);  // every function times its brightness
  Eigen::VectorXd whole = Eigen::VectorXd::Zero(angles);
  std::vector<double> factors(parts);
  for (Eigen::Index i = 0; i < angles; ++i)
    for (std::size_t column = 0; column < columns.columns(); ++column) {
      columns.part_factors(column, std::cos(angle(static_cast<std::size_t>(i))), factors);
      for (std::size_t w = 0; w < wanted.size(); ++w) {
        const double value = factors[wanted[w]] * brightness(static_cast<Eigen::Index>(column),
                                                             static_cast<Eigen::Index>(wanted[w]));
        bright(i, static_cast<Eigen::Index>(column * wanted.size() + w)) = value;
        if (wanted[w] < scatterers) whole(i) += value;
      }
    }
  bright = whole.cwiseInverse().asDiagonal() * bright;

  const auto few = static_cast<Eigen::Index>((kAngles + kEvery - 1) / kEvery);
  const Eigen::MatrixXd some = bright(Eigen::seqN(0, few, static_cast<Eigen::Index>(kEvery)), Eigen::all);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(some * some.transpose());
  functions_.resize(kAngles * terms);
  for (std::size_t k = 0; k < terms; ++k) {
    const Eigen::Index from_last = few - 1 - static_cast<Eigen::Index>(k);
    const double size = std::sqrt(std::max(gram.eigenvalues()(from_last), 1e-300));
    Eigen::VectorXd v = some.transpose() * gram.eigenvectors().col(from_last) / size;
    if (v.sum() < 0.0) v = -v;
    const Eigen::VectorXd u = whole.cwiseProduct(bright * v);
    for (std::size_t i = 0; i < kAngles; ++i)
      functions_[i * terms + k] = static_cast<float>(u(static_cast<Eigen::Index>(i)));
    share_.emplace_back(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(columns.columns()),
                                              static_cast<Eigen::Index>(parts)));
    for (std::size_t column = 0; column < columns.columns(); ++column)
      for (std::size_t w = 0; w < wanted.size(); ++w) {
        const double typical =
            brightness(static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(wanted[w]));
        if (typical > 0.0)
          share_[k](static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(wanted[w])) =
              v(static_cast<Eigen::Index>(column * wanted.size() + w)) / typical;
      }
  }
  // ∫ u_0 sinΘ dΘ / 2 by the trapezoidal rule in √Θ.
  for (std::size_t i = 1; i < kAngles; ++i)
    mean_ += 0.25 * (angle(i) - angle(i - 1)) *
             (static_cast<double>(functions_[i * terms]) * std::sin(angle(i)) +
              static_cast<double>(functions_[(i - 1) * terms]) * std::sin(angle(i - 1)));
}

}  // namespace skylut::compact
