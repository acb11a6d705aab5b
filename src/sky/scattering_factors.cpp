#include "scattering_factors.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

constexpr std::size_t kNodes = 1024;
/// Relative to the phase function's mean over the wavelengths.
constexpr double kTermTolerance = 1e-4;

/// Scattering angle of a node: Θ = π (i/(n-1))².
double node_angle(std::size_t node) {
  const double t = static_cast<double>(node) / (kNodes - 1);
  return kPi * t * t;
}

}  // namespace

ScatteringFactors::ScatteringFactors(const SolvedColumns& columns, std::span<const std::size_t> first_column)
    : wavelengths_(first_column.size()) {
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

  // A scatterer's factors count beside its phase function.
  const std::size_t scatterers = columns.scatterers();
  std::vector<std::vector<float>> u;
  for (std::size_t part = 0; part + 1 < part_.size(); ++part) {
    std::vector<double> scale(kNodes);
    const std::size_t phase = part_[part] % scatterers;
    for (std::size_t node = 0; node < kNodes; ++node) {
      for (std::size_t i = 0; i < wavelengths_; ++i)
        scale[node] += whole[(node * all + phase) * wavelengths_ + i] / static_cast<double>(wavelengths_);
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
