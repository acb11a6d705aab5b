#include "feature_encoder.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/cosine_series.hpp"

namespace skylut::compact {

namespace {

/// The albedo of the ground that the brightness t is over.
constexpr double kUsualAlbedo = 0.2;
/// Light is never less than this share of the brightest: deep in the Earth's shadow it may be none.
constexpr double kNight = 1e-12;
constexpr double kLeastGround = 1e-6;

Eigen::MatrixXd series_of(std::size_t count) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const std::vector<double> weights = cosine_series(count);
  const auto n = static_cast<Eigen::Index>(count);
  return Eigen::Map<const RowMajor>(weights.data(), n, n);
}

}  // namespace

FeatureEncoder::FeatureEncoder(const Layout& layout, double haze_mean)
    : layout_(layout),
      haze_mean_(haze_mean),
      series_(series_of(SkyRow::kAzimuths)),
      ground_series_(series_of(SkyRow::kGroundAzimuths)) {}

void FeatureEncoder::encode(const SkyRow& row, double aod500, std::span<float> features) const {
  const auto channels = static_cast<Eigen::Index>(layout_.channels());
  const auto put = [&](std::size_t field, const Eigen::VectorXd& values) {
    const Eigen::VectorXd orders = series_ * values;
    for (std::size_t m = 0; m < layout_.orders(field); ++m)
      features[layout_.at(m, field)] = static_cast<float>(orders(static_cast<Eigen::Index>(m)));
  };
  const Eigen::MatrixXd ground = ground_series_ * row.ground.cwiseMax(0.0);  // (order, channel)
  const Eigen::MatrixXd haze = (row.haze.front() * haze_mean_).cwiseMax(0.0);
  Eigen::MatrixXd brightness = row.molecules + haze + row.diffuse;
  brightness.rowwise() += kUsualAlbedo * ground.row(0);
  brightness = brightness.cwiseMax(std::max(brightness.maxCoeff() * kNight, 1e-300));

  const auto y = static_cast<Eigen::Index>(Layout::kY);
  const Eigen::MatrixXd log_brightness = brightness.array().log();
  put(layout_.brightness(), log_brightness.col(y));
  for (Eigen::Index c = 0; c < channels; ++c) {
    const auto channel = static_cast<std::size_t>(c);
    const Eigen::VectorXd t = brightness.col(c);
    if (c != y) put(layout_.ratio(Layout::other(channel)), log_brightness.col(c) - log_brightness.col(y));
    put(layout_.molecules(channel), row.molecules.col(c).cwiseQuotient(t));
    put(layout_.haze(channel),
        ((haze.col(c).array() / (aod500 * t.array())) + Layout::kFloor).log().matrix());
    const Eigen::VectorXd unit = haze.col(c) + Layout::kFloor * aod500 * t;
    for (std::size_t k = 1; k < layout_.terms(); ++k)
      put(layout_.term(k, channel), haze_mean_ * row.haze[k].col(c).cwiseQuotient(unit));
    const double log_mean = (series_.row(0) * log_brightness.col(c))(0);
    const std::size_t g = layout_.ground(channel);
    features[layout_.at(0, g)] =
        static_cast<float>(std::log(ground(0, c) * std::exp(-log_mean) + kLeastGround));
    for (std::size_t m = 1; m < layout_.orders(g); ++m)
      features[layout_.at(m, g)] =
          static_cast<float>(ground(static_cast<Eigen::Index>(m), c) / std::max(ground(0, c), 1e-300));
  }
}

}  // namespace skylut::compact
