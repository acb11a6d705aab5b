#include "training_spectrum.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "grey_columns.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/transfer/solved_columns.hpp"

namespace skylut::compact {

namespace {

/// Where the colour matching functions have weight, and so that ozone's bands are seen: of some sets that
/// were tried the one with the smallest errors (0.04 % in Y, 0.03 % in X, 0.07 % in Z, root mean square).
constexpr std::array kColour_nm{400.0, 420.0, 435.0, 450.0, 465.0, 480.0, 500.0, 520.0,
                                540.0, 560.0, 575.0, 590.0, 605.0, 625.0, 645.0, 680.0};
/// How strongly a weight is held to the plain sum, against errors of the skies squared.
constexpr double kHold = 1e-6;

/// Not the scene's ground: it may be black, and then is not seen.
constexpr double kSetAlbedo = 0.3;
constexpr std::array kLoads{0.01, 0.2, 1.0};
constexpr std::array kSuns_deg{20.0, 75.0, 88.0, 91.0, 94.0};
constexpr std::array kAltitudes_km{0.0, 10.0, 28.0};
constexpr std::array kZeniths_deg{10.0, 60.0, 85.0, 89.5, 120.0};
constexpr std::array kAzimuths_deg{0.0, 70.0, 180.0};

/// The wavelengths of the scene nearest to those wanted, each once.
std::vector<std::size_t> chosen(const WavelengthGrid& grid) {
  std::vector<std::size_t> indices;
  for (const double wanted_nm : kColour_nm) {
    const double at = (wanted_nm - grid.first_nm()) / grid.step_nm();
    const auto index =
        static_cast<std::size_t>(std::clamp(std::round(at), 0.0, static_cast<double>(grid.size() - 1)));
    if (indices.empty() || indices.back() != index) indices.push_back(index);
  }
  return indices;
}

/// Every band's weight given to the chosen bands beside it, nearer ones more. [chosen]
std::vector<double> plain_sums(std::span<const std::size_t> indices, std::span<const double> weights) {
  std::vector<double> sums(indices.size(), 0.0);
  for (std::size_t band = 0; band < weights.size(); ++band) {
    const auto above = std::lower_bound(indices.begin(), indices.end(), band) - indices.begin();
    const auto to = static_cast<std::size_t>(above);
    if (to == 0 || to == indices.size()) {
      sums[std::min(to, indices.size() - 1)] += weights[band];
      continue;
    }
    const double t =
        static_cast<double>(band - indices[to - 1]) / static_cast<double>(indices[to] - indices[to - 1]);
    sums[to - 1] += (1.0 - t) * weights[band];
    sums[to] += t * weights[band];
  }
  return sums;
}

/// Spectra of all bands at unit solar irradiance, in many directions of many skies. [sky and direction][band]
Eigen::MatrixXd training_set(const Context& context, const SkyScene& scene, const TransferOptions& options) {
  const std::size_t lines = kAltitudes_km.size() * kZeniths_deg.size() * kSuns_deg.size();
  const std::size_t azimuths = kAzimuths_deg.size();
  Eigen::MatrixXd set = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(kLoads.size() * lines * azimuths),
                                              static_cast<Eigen::Index>(scene.wavelengths.size()));
  Eigen::Index first_row = 0;
  for (const double load : kLoads) {
    GreyColumns bands = grey_columns(scene, load, kSetAlbedo);
    const SolvedColumns sky(context, scene.atmosphere->shells(), std::move(bands.columns), kSuns_deg,
                            options);
    parallel_for(lines, context.threads, [&](std::size_t line) {
      const double altitude_km = kAltitudes_km[line / (kZeniths_deg.size() * kSuns_deg.size())];
      const double zenith_deg = kZeniths_deg[line / kSuns_deg.size() % kZeniths_deg.size()];
      std::vector<float> radiance(sky.columns() * azimuths);
      sky.radiance({altitude_km, zenith_deg, kSuns_deg[line % kSuns_deg.size()], kAzimuths_deg}, radiance);
      for (std::size_t column = 0; column < sky.columns(); ++column)
        for (std::size_t azimuth = 0; azimuth < azimuths; ++azimuth)
          set(first_row + static_cast<Eigen::Index>(line * azimuths + azimuth),
              static_cast<Eigen::Index>(bands.band[column])) +=
              bands.weight[column] * static_cast<double>(radiance[column * azimuths + azimuth]);
    });
    first_row += static_cast<Eigen::Index>(lines * azimuths);
  }
  return set;
}

/// The weights of few columns of a set that give the weighted sums of all: factors of the plain sums, held
/// to 1.
std::vector<double> fitted_weights(const Eigen::MatrixXd& set, std::span<const std::size_t> indices,
                                   std::span<const double> weights, double& worst) {
  const std::vector<double> plain = plain_sums(indices, weights);
  const Eigen::VectorXd sums = set * Eigen::Map<const Eigen::VectorXd>(weights.data(), set.cols());
  const auto count = static_cast<Eigen::Index>(indices.size());
  Eigen::MatrixXd relative(set.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i)
    relative.col(i) =
        plain[static_cast<std::size_t>(i)] *
        set.col(static_cast<Eigen::Index>(indices[static_cast<std::size_t>(i)])).cwiseQuotient(sums);
  const double hold = kHold * static_cast<double>(set.rows());
  Eigen::MatrixXd normal = relative.transpose() * relative;
  normal.diagonal().array() += hold;
  const Eigen::VectorXd right =
      relative.transpose() * Eigen::VectorXd::Ones(set.rows()) + Eigen::VectorXd::Constant(count, hold);
  const Eigen::VectorXd factor = normal.ldlt().solve(right);
  worst = std::max(worst, (relative * factor - Eigen::VectorXd::Ones(set.rows())).cwiseAbs().maxCoeff());
  std::vector<double> fitted;
  for (Eigen::Index i = 0; i < count; ++i) fitted.push_back(factor(i) * plain[static_cast<std::size_t>(i)]);
  return fitted;
}

}  // namespace

TrainingSpectrum::TrainingSpectrum(const Context& context, const SkyScene& scene, const WavelengthGrid* bands,
                                   const TransferOptions& options) {
  choose_colour_samples(context, scene, options);
  if (bands != nullptr) add_bands(context, scene, *bands);
  for (std::vector<double>& weight : weights_) weight.resize(samples_.size(), 0.0);
}

void TrainingSpectrum::choose_colour_samples(const Context& context, const SkyScene& scene,
                                             const TransferOptions& options) {
  const WavelengthGrid& grid = scene.wavelengths;
  const std::vector<double> irradiance = extraterrestrial_irradiance(context, scene);
  const std::vector<Xyz> colour = ColourMatching::load(context).weights(grid);
  const Eigen::MatrixXd set = training_set(context, scene, options);
  const std::vector<std::size_t> indices = chosen(grid);
  std::vector<std::size_t> of_band;   // [sample]
  std::vector<double> share_of_band;  // [sample]
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const Band band{grid[indices[i]], grid.step_nm()};
    const std::vector<BandColumn> terms = scene.atmosphere->band_columns(band, kLoads.front());
    for (std::size_t term = 0; term < terms.size(); ++term) {
      samples_.push_back({band, term});
      of_band.push_back(i);
      share_of_band.push_back(terms[term].weight);
    }
  }
  for (const auto channel : {&Xyz::X, &Xyz::Y, &Xyz::Z}) {
    std::vector<double> all;
    for (std::size_t i = 0; i < grid.size(); ++i) all.push_back(colour[i].*channel * irradiance[i]);
    const std::vector<double> fitted = fitted_weights(set, indices, all, colour_error_);
    std::vector<double> weights;
    for (std::size_t sample = 0; sample < samples_.size(); ++sample)
      weights.push_back(fitted[of_band[sample]] * share_of_band[sample]);
    weights_.push_back(std::move(weights));
  }
}

void TrainingSpectrum::add_bands(const Context& context, const SkyScene& scene, const WavelengthGrid& bands) {
  SkyScene of_bands = scene;
  of_bands.wavelengths = bands;
  const std::vector<double> irradiance = extraterrestrial_irradiance(context, of_bands);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const Band band{bands[i], bands.step_nm()};
    const std::vector<BandColumn> terms = scene.atmosphere->band_columns(band, kLoads.front());
    std::vector<double> weight(samples_.size(), 0.0);
    for (std::size_t term = 0; term < terms.size(); ++term) {
      samples_.push_back({band, term});
      weight.push_back(irradiance[i] * terms[term].weight);
    }
    weights_.push_back(std::move(weight));
  }
}

std::vector<OpticalColumn> TrainingSpectrum::columns(const Atmosphere& air, double aod500,
                                                     double albedo) const {
  std::vector<OpticalColumn> columns;
  for (const Sample& sample : samples_) {
    columns.push_back(air.band_columns(sample.band, aod500).at(sample.term).column);
    columns.back().ground_albedo = albedo;
  }
  return columns;
}

}  // namespace skylut::compact
