#include "channel_samples.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "skylut/colour/cie1931.hpp"
#include "skylut/core/errors.hpp"

namespace skylut::forms_detail {

namespace {

/// Shares of the simulated bands in one band of the model: [band][wavelength], each row summing to 1.
std::vector<std::vector<double>> shares(const WavelengthGrid& bands, const WavelengthGrid& simulated) {
  std::vector<std::vector<double>> all;
  for (std::size_t band = 0; band < bands.size(); ++band) {
    std::vector<double>& share = all.emplace_back(simulated.size(), 0.0);
    const double lower = bands[band] - 0.5 * bands.step_nm();
    const double upper = bands[band] + 0.5 * bands.step_nm();
    double sum = 0.0;
    for (std::size_t i = 0; i < simulated.size(); ++i) {
      const double half = 0.5 * simulated.step_nm();
      share[i] = std::max(0.0, std::min(upper, simulated[i] + half) - std::max(lower, simulated[i] - half));
      sum += share[i];
    }
    if (!(sum > 0.0))
      throw InputError("band at {} nm: must lie within the input's wavelengths, {} to {} nm", bands[band],
                       simulated.first_nm(), simulated.last_nm());
    for (double& one : share) one /= sum;
  }
  return all;
}

std::vector<double> band_values(const TrainingSky& sky, const std::vector<std::vector<double>>& shares) {
  std::vector<double> values;
  const std::size_t width = shares.front().size();
  for (std::size_t view = 0; view < sky.colours.size(); ++view)
    for (const std::vector<double>& share : shares) {
      double sum = 0.0;
      for (std::size_t i = 0; i < width; ++i)
        sum += share[i] * static_cast<double>(sky.radiance[view * width + i]);
      values.push_back(sum);
    }
  return values;
}

/// Weights w near w0 with w · L = target for all skies, relatively: ridge regression.
Eigen::VectorXd fitted_weights(const Eigen::MatrixXd& spectra, const Eigen::VectorXd& scale,
                               const Eigen::VectorXd& cie) {
  // Spectra of skies are so alike that weights without a rein would cancel one another and blow up the errors
  // of a fit.
  constexpr double kRein = 1e-5;
  const Eigen::MatrixXd relative = scale.asDiagonal() * spectra;
  const double rein = kRein * static_cast<double>(spectra.rows()) / cie.squaredNorm();
  const Eigen::VectorXd left = Eigen::VectorXd::Ones(spectra.rows()) - relative * cie;
  Eigen::MatrixXd normal = relative.transpose() * relative;
  normal.diagonal().array() += rein;
  return cie + normal.ldlt().solve(relative.transpose() * left);
}

}  // namespace

SkyChannels band_channels(const Context& context, const SkySupply& supply, const WavelengthGrid& bands,
                          std::span<const TrainingSky> skies) {
  if (supply.wavelengths() == nullptr || skies.empty() || skies.front().radiance.empty())
    throw InputError("bands: need an input with spectra, columns L_<nm> or a table folder");
  const std::vector<std::vector<double>> share = shares(bands, *supply.wavelengths());
  SkyChannels channels{.kind = SkyChannels::Kind::bands, .wavelengths = bands, .colour_weights = {}};
  channels.colour_weights = ColourMatching::load(context).weights(bands);

  std::size_t rows = 0;
  for (const TrainingSky& sky : skies) rows += sky.colours.size();
  Eigen::MatrixXd spectra(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(bands.size()));
  std::vector<Xyz> colours;
  Eigen::Index row = 0;
  for (const TrainingSky& sky : skies) {
    const std::vector<double> values = band_values(sky, share);
    for (std::size_t view = 0; view < sky.colours.size(); ++view, ++row) {
      for (std::size_t band = 0; band < bands.size(); ++band)
        spectra(row, static_cast<Eigen::Index>(band)) = values[view * bands.size() + band];
      colours.push_back(to_xyz(sky.colours[view]));
    }
  }
  for (double Xyz::*channel : {&Xyz::X, &Xyz::Y, &Xyz::Z}) {
    Eigen::VectorXd scale(spectra.rows());
    Eigen::VectorXd cie(spectra.cols());
    for (Eigen::Index i = 0; i < scale.size(); ++i)
      scale[i] = 1.0 / (colours[static_cast<std::size_t>(i)].*channel);
    for (Eigen::Index i = 0; i < cie.size(); ++i)
      cie[i] = channels.colour_weights[static_cast<std::size_t>(i)].*channel;
    const Eigen::VectorXd weights = fitted_weights(spectra, scale, cie);
    for (Eigen::Index i = 0; i < cie.size(); ++i)
      channels.colour_weights[static_cast<std::size_t>(i)].*channel = weights[i];
  }
  return channels;
}

std::vector<double> channel_values(const TrainingSky& sky, const SkyChannels& channels,
                                   const WavelengthGrid* wavelengths) {
  if (channels.kind == SkyChannels::Kind::bands)
    return band_values(sky, shares(*channels.wavelengths, *wavelengths));
  std::vector<double> values;
  for (const Yxy& colour : sky.colours)
    for (const double value : channels.values(colour)) values.push_back(value);
  return values;
}

}  // namespace skylut::forms_detail
