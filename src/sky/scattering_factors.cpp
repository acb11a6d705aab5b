#include "scattering_factors.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {

namespace {

constexpr std::size_t kNodes = 1024;
/// Relative to the phase function's mean over the wavelengths.
constexpr double kTermTolerance = 1e-4;

/// Of means over the disc.
constexpr double kWidestMean_deg = 10.0;
constexpr int kRings = 8;
constexpr int kOnHalfARing = 12;

/// Scattering angle of a node: Θ = π (i/(n-1))².
double node_angle(std::size_t node) {
  const double t = static_cast<double>(node) / (kNodes - 1);
  return kPi * t * t;
}

}  // namespace

ScatteringFactors::ScatteringFactors(const SolvedColumns& columns, std::span<const std::size_t> first_column)
    : wavelengths_(first_column.size()), scatterers_(columns.scatterers()) {
  const std::size_t all = columns.parts();
  std::vector<double> whole(kNodes * all * wavelengths_);  // [node][part][wavelength]
  std::vector<double> factors(all);
  std::vector<bool> wanted(all, false);
  for (std::size_t node = 0; node < kNodes; ++node)
    for (std::size_t i = 0; i < wavelengths_; ++i) {
      columns.part_factors(first_column[i], std::cos(node_angle(node)), factors);
      for (std::size_t part = 0; part < all; ++part) {
        whole[(node * all + part) * wavelengths_ + i] = factors[part];
        if (factors[part] != 0.0) wanted[part] = true;
      }
    }
  for (std::size_t part = 0; part < all; ++part)
    if (wanted[part]) part_.push_back(part);
  spectral_.reserve(kNodes * part_.size() * wavelengths_);
  for (std::size_t node = 0; node < kNodes; ++node)
    for (const std::size_t part : part_)
      for (std::size_t i = 0; i < wavelengths_; ++i)
        spectral_.push_back(static_cast<float>(whole[(node * all + part) * wavelengths_ + i]));
  decompose();
}

void ScatteringFactors::decompose() {
  term_.clear();
  at_node_.clear();
  // A scatterer's factors count beside its phase function.
  std::vector<std::vector<float>> u;
  for (std::size_t part = 0; part + 1 < part_.size(); ++part) {
    std::vector<double> scale(kNodes);
    const auto phase = static_cast<std::size_t>(
        std::find(part_.begin(), part_.end(), part_[part] % scatterers_) - part_.begin());
    for (std::size_t node = 0; node < kNodes; ++node) {
      for (std::size_t i = 0; i < wavelengths_; ++i)
        scale[node] += static_cast<double>(spectral_[(node * part_.size() + phase) * wavelengths_ + i]) /
                       static_cast<double>(wavelengths_);
      scale[node] = std::max(scale[node], 1e-12);
    }
    decompose(part, scale, u);
  }
  term_.push_back({part_.size() - 1, std::vector<double>(wavelengths_, 1.0)});
  u.emplace_back(kNodes, 1.0f);
  for (std::size_t node = 0; node < kNodes; ++node)
    for (const std::vector<float>& term : u) at_node_.push_back(term[node]);
}

void ScatteringFactors::decompose(std::size_t part, std::span<const double> scale,
                                  std::vector<std::vector<float>>& columns) {
  const auto rows = static_cast<Eigen::Index>(kNodes);
  const auto width = static_cast<Eigen::Index>(wavelengths_);
  Eigen::MatrixXd relative(rows, width);
  for (Eigen::Index node = 0; node < rows; ++node)
    for (Eigen::Index i = 0; i < width; ++i)
      relative(node, i) =
          static_cast<double>(
              spectral_[(static_cast<std::size_t>(node) * part_.size() + part) * wavelengths_ +
                        static_cast<std::size_t>(i)]) /
          scale[static_cast<std::size_t>(node)];
  // Its right singular vectors are the eigenvectors of the small Gram matrix, the largest last.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(relative.transpose() * relative);
  for (Eigen::Index k = width - 1; k >= 0; --k) {
    if (relative.cwiseAbs().maxCoeff() < kTermTolerance) break;
    Eigen::VectorXd spectrum = gram.eigenvectors().col(k);
    if (spectrum.sum() < 0.0) spectrum = -spectrum;
    const Eigen::VectorXd u = relative * spectrum;
    relative -= u * spectrum.transpose();
    Term term{part, {spectrum.data(), spectrum.data() + width}};
    std::vector<float> scaled;
    for (Eigen::Index node = 0; node < rows; ++node)
      scaled.push_back(static_cast<float>(u(node) * scale[static_cast<std::size_t>(node)]));
    term_.push_back(std::move(term));
    columns.push_back(std::move(scaled));
  }
}

ScatteringFactors::Stencil ScatteringFactors::stencil(double cos_scattering) const {
  const double angle = std::acos(std::clamp(cos_scattering, -1.0, 1.0));
  const double t = std::sqrt(angle / kPi) * (kNodes - 1);
  const auto below = static_cast<std::ptrdiff_t>(t);
  const auto first = std::clamp<std::ptrdiff_t>(below - 1, 0, static_cast<std::ptrdiff_t>(kNodes) - 4);
  const double u = t - static_cast<double>(first);
  return {static_cast<std::size_t>(first),
          {static_cast<float>((u - 1.0) * (u - 2.0) * (u - 3.0) / -6.0),
           static_cast<float>(u * (u - 2.0) * (u - 3.0) / 2.0),
           static_cast<float>(u * (u - 1.0) * (u - 3.0) / -2.0),
           static_cast<float>(u * (u - 1.0) * (u - 2.0) / 6.0)}};
}

namespace {

void interpolate(const float* rows, std::size_t width, const float (&weight)[4], std::span<float> out) {
  for (std::size_t i = 0; i < width; ++i)
    out[i] = weight[0] * rows[i] + weight[1] * rows[width + i] + weight[2] * rows[2 * width + i] +
             weight[3] * rows[3 * width + i];
}

}  // namespace

// Of the disc's radius ρ0: with r = sin(ρ/2)/sin(ρ0/2), whose square is even in the disc's area, μ = √(1 -
// r²).
struct ScatteringFactors::Ring {
  double rho = 0.0;     // from the middle, radians
  double mu = 0.0;      // towards the limb's darkening
  double weight = 0.0;  // of the disc's area
};

ScatteringFactors ScatteringFactors::over_disc(double angular_radius_deg,
                                               std::span<const LimbDarkeningLaw> darkening) const {
  SKYLUT_CHECK_EQ(darkening.size(), wavelengths_);
  const double half_sine = std::sin(0.5 * angular_radius_deg * kRadiansPerDegree);
  const Quadrature mu = gauss_legendre(kRings, 0.0, 1.0);  // of the area: 2 μ dμ
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < mu.node.size(); ++i) {
    const double r = std::sqrt(1.0 - mu.node[i] * mu.node[i]);
    rings.push_back({2.0 * std::asin(r * half_sine), mu.node[i], 2.0 * mu.node[i] * mu.weight[i]});
  }
  ScatteringFactors averaged = *this;
  const std::size_t width = part_.size() * wavelengths_;
  for (std::size_t node = 0; node_angle(node) < kWidestMean_deg * kRadiansPerDegree; ++node)
    average(node, rings, darkening, std::span(averaged.spectral_).subspan(node * width, width));
  averaged.decompose();
  return averaged;
}

void ScatteringFactors::average(std::size_t node, std::span<const Ring> rings,
                                std::span<const LimbDarkeningLaw> darkening, std::span<float> mean) const {
  const double angle = node_angle(node);
  std::vector<float> at(mean.size());
  std::vector<double> around(mean.size());
  std::vector<double> sum(mean.size(), 0.0);
  for (const Ring& ring : rings) {
    std::fill(around.begin(), around.end(), 0.0);
    for (int k = 0; k < kOnHalfARing; ++k) {
      const double turn = kPi * (k + 0.5) / kOnHalfARing;
      spectral(std::cos(angle) * std::cos(ring.rho) + std::sin(angle) * std::sin(ring.rho) * std::cos(turn),
               at);
      for (std::size_t i = 0; i < at.size(); ++i) around[i] += static_cast<double>(at[i]) / kOnHalfARing;
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += ring.weight * darkening[i % wavelengths_](ring.mu) * around[i];
  }
  std::transform(sum.begin(), sum.end(), mean.begin(),
                 [](double value) { return static_cast<float>(value); });
}

void ScatteringFactors::spectral(double cos_scattering, std::span<float> factors) const {
  const Stencil at = stencil(cos_scattering);
  const std::size_t width = part_.size() * wavelengths_;
  interpolate(spectral_.data() + at.first * width, width, at.weight, factors);
}

void ScatteringFactors::terms_at(double cos_scattering, std::span<float> factors) const {
  const Stencil at = stencil(cos_scattering);
  interpolate(at_node_.data() + at.first * term_.size(), term_.size(), at.weight, factors);
}

}  // namespace skylut
