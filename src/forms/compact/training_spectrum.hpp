#pragma once

#include <cstddef>
#include <vector>

#include "skylut/atmosphere/atmosphere.hpp"
#include "skylut/core/wavelength_grid.hpp"
#include "skylut/sky/sky_scene.hpp"

namespace skylut {
struct Context;
}

namespace skylut::compact {

/// The monochromatic columns whose weighted radiances are the model's channels: X, Y, Z by some 16
/// wavelengths instead of all bands, and every band that the model has spectra of.
///
/// Spectra of skies are smooth but for the sun's own lines and the gases' bands, which all of them share. So
/// the weights of few wavelengths that give the tristimulus values of a set of skies give those of all: least
/// squares of the relative errors, held to the plain sums over the neighbouring bands where the set does not
/// tell. (The idea is that of optimal spectral sampling, Moncet et al. 2008, doi:10.1175/2008JAS2711.1.)
class TrainingSpectrum {
 public:
  /// @param scene  whose atmosphere, solar spectrum and wavelengths X, Y, Z stand for; loads and suns are
  /// those
  ///               of the training
  /// @param bands  with spectra; none: null
  TrainingSpectrum(const Context& context, const SkyScene& scene, const WavelengthGrid* bands,
                   const TransferOptions& options);

  std::size_t channels() const { return weights_.size(); }
  std::size_t samples() const { return samples_.size(); }
  /// Of a channel, to be multiplied with the columns' radiances at unit solar irradiance. [channel][sample]
  const std::vector<std::vector<double>>& weights() const { return weights_; }
  /// The largest relative error of X, Y, Z that the set of skies was left with.
  double colour_error() const { return colour_error_; }

  /// The columns at a load over a ground of an albedo.
  std::vector<OpticalColumn> columns(const Atmosphere& air, double aod500, double albedo) const;

 private:
  void choose_colour_samples(const Context& context, const SkyScene& scene, const TransferOptions& options);
  void add_bands(const Context& context, const SkyScene& scene, const WavelengthGrid& bands);

  struct Sample {
    Band band;
    std::size_t term;  ///< of the band's columns
  };
  std::vector<Sample> samples_;
  std::vector<std::vector<double>> weights_;
  double colour_error_ = 0.0;
};

}  // namespace skylut::compact
