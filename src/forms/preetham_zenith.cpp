#include "preetham_zenith.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "skylut/core/constants.hpp"

namespace skylut::forms_detail {

namespace {

/// Luminance for one pair of χ's constants, χ = (offset - T slope) (π - 2θ_s).
struct LuminanceFit {
  double cost = std::numeric_limits<double>::infinity();
  double offset = 0.0;
  double slope = 0.0;
  Eigen::Vector4d numbers = Eigen::Vector4d::Zero();  // T tan χ, tan χ, T, 1
};

LuminanceFit luminance_fit(std::span<const ZenithSample> samples, double offset, double slope) {
  constexpr double kLargestChi = 0.99 * 0.5 * kPi;
  LuminanceFit fit{.offset = offset, .slope = slope};
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(samples.size()), 4);
  Eigen::Index row = 0;
  for (const ZenithSample& sample : samples) {
    const double chi = (offset - slope * sample.turbidity) * (kPi - 2.0 * sample.sun_zenith_rad);
    if (!(chi < kLargestChi)) return fit;
    matrix.row(row++) =
        Eigen::RowVector4d(sample.turbidity * std::tan(chi), std::tan(chi), sample.turbidity, 1.0) /
        sample.colour.Y;
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(matrix.rows());
  fit.numbers = matrix.colPivHouseholderQr().solve(ones);
  fit.cost = (matrix * fit.numbers - ones).squaredNorm();
  return fit;
}

PreethamMatrices::ZenithLuminance luminance(std::span<const ZenithSample> samples) {
  constexpr int kHalf = 10;
  LuminanceFit best = luminance_fit(samples, 4.0 / 9.0, 1.0 / 120.0);
  double offset_step = 0.01;
  double slope_step = 0.001;
  for (int round = 0; round < 12; ++round) {
    const LuminanceFit middle = best;
    for (int i = -kHalf; i <= kHalf; ++i)
      for (int k = -kHalf; k <= kHalf; ++k) {
        const LuminanceFit tried =
            luminance_fit(samples, middle.offset + i * offset_step, middle.slope + k * slope_step);
        if (tried.cost < best.cost) best = tried;
      }
    offset_step *= 0.5;
    slope_step *= 0.5;
  }
  return {.chi_offset = best.offset,
          .chi_divisor = 1.0 / best.slope,
          .tangent = {best.numbers[0], best.numbers[1]},
          .rest = {best.numbers[2], best.numbers[3]}};
}

PreethamMatrices::Chromaticity chromaticity(std::span<const ZenithSample> samples, double Yxy::*channel) {
  constexpr Eigen::Index kNumbers = 12;
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(samples.size()), kNumbers);
  Eigen::VectorXd right(matrix.rows());
  Eigen::Index row = 0;
  for (const ZenithSample& sample : samples) {
    const double t = sample.sun_zenith_rad;
    const double T = sample.turbidity;
    Eigen::Index column = 0;
    for (const double by_T : {T * T, T, 1.0})
      for (const double by_sun : {t * t * t, t * t, t, 1.0}) matrix(row, column++) = by_T * by_sun;
    right[row++] = sample.colour.*channel;
  }
  const Eigen::VectorXd numbers = matrix.colPivHouseholderQr().solve(right);
  PreethamMatrices::Chromaticity result{};
  for (Eigen::Index i = 0; i < kNumbers; ++i)
    result[static_cast<std::size_t>(i / 4)][static_cast<std::size_t>(i % 4)] = numbers[i];
  return result;
}

}  // namespace

void fit_zenith(std::span<const ZenithSample> samples, PreethamMatrices& matrices) {
  matrices.zenith_Y = luminance(samples);
  matrices.zenith_x = chromaticity(samples, &Yxy::x);
  matrices.zenith_y = chromaticity(samples, &Yxy::y);
}

}  // namespace skylut::forms_detail
