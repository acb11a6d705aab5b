#include "skylut/export/picture_sampler.hpp"

#include <algorithm>
#include <vector>

#include "export/disc_pixels.hpp"
#include "export/pixel_pieces.hpp"
#include "skylut/core/check.hpp"

namespace skylut {

namespace {

constexpr std::size_t kBatch = 4096;  // directions: bounds the memory of their spectra
constexpr int kColumns = 1024;        // at a time: bounds the memory of the sums

// Neighbours that share a zenith angle cost the sky least. Stable: the order is the same at any time.
void sort_by_zenith(std::vector<PixelSample>& samples) {
  const auto higher = [](const PixelSample& a, const PixelSample& b) {
    return a.direction.zenith_deg < b.direction.zenith_deg;
  };
  if (!std::is_sorted(samples.begin(), samples.end(), higher))
    std::stable_sort(samples.begin(), samples.end(), higher);
}

template <class Use>
void for_batches(std::span<const PixelSample> samples, const Use& use) {
  std::vector<Direction> directions;
  for (std::size_t first = 0; first < samples.size(); first += kBatch) {
    const auto batch = samples.subspan(first, std::min(kBatch, samples.size() - first));
    directions.clear();
    for (const PixelSample& sample : batch) directions.push_back(sample.direction);
    use(batch, directions);
  }
}

}  // namespace

PictureSampler::PictureSampler(const SkyLight& sky, const Projection& projection, const SunDisc* disc)
    : sky_(sky), projection_(projection) {
  if (disc == nullptr) return;
  SKYLUT_CHECK_EQ(disc->wavelengths().size(), sky.wavelengths().size());
  disc_ = std::make_shared<const DiscPixels>(*disc, projection);
}

std::size_t PictureSampler::sample_row(int row, std::span<Xyz> colour, std::span<float> radiance) const {
  const std::size_t wavelengths = sky_.wavelengths().size();
  SKYLUT_CHECK_EQ(colour.size(), static_cast<std::size_t>(projection_.width()));
  SKYLUT_CHECK(radiance.empty() || radiance.size() == colour.size() * wavelengths);
  std::vector<double> sums;  // of many pieces: a float would lose digits
  std::size_t looks = 0;
  const PixelPieces pieces(projection_, sky_.horizon_zenith_deg(), sky_.sun());
  for (int first = 0; first < projection_.width(); first += kColumns) {
    const int last = std::min(first + kColumns, projection_.width());
    std::vector<PixelSample> samples = pieces.of_columns(row, first, last);
    sort_by_zenith(samples);
    looks += samples.size();
    const auto begin = static_cast<std::size_t>(first);
    const auto count = static_cast<std::size_t>(last - first);
    add_colours(samples, colour.subspan(begin, count));
    if (radiance.empty()) continue;
    sums.assign(count * wavelengths, 0.0);
    add_spectra(samples, sums);
    std::transform(sums.begin(), sums.end(),
                   radiance.begin() + static_cast<std::ptrdiff_t>(begin * wavelengths),
                   [](double sum) { return static_cast<float>(sum); });
  }
  if (disc_) disc_->add_to_row(row, colour, radiance);
  return looks;
}

void PictureSampler::add_colours(std::span<const PixelSample> samples, std::span<Xyz> colour) const {
  std::fill(colour.begin(), colour.end(), Xyz{});
  std::vector<Xyz> values;
  for_batches(samples, [&](std::span<const PixelSample> batch, std::span<const Direction> directions) {
    values.resize(batch.size());
    sky_.colour(directions, values);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      Xyz& pixel = colour[batch[i].column];
      pixel.X += batch[i].weight * values[i].X;
      pixel.Y += batch[i].weight * values[i].Y;
      pixel.Z += batch[i].weight * values[i].Z;
    }
  });
}

void PictureSampler::add_spectra(std::span<const PixelSample> samples, std::span<double> sums) const {
  const std::size_t wavelengths = sky_.wavelengths().size();
  std::vector<float> values;
  for_batches(samples, [&](std::span<const PixelSample> batch, std::span<const Direction> directions) {
    values.resize(batch.size() * wavelengths);
    sky_.radiance(directions, values);
    for (std::size_t i = 0; i < batch.size(); ++i)
      for (std::size_t w = 0; w < wavelengths; ++w)
        sums[batch[i].column * wavelengths + w] +=
            batch[i].weight * static_cast<double>(values[i * wavelengths + w]);
  });
}

}  // namespace skylut
