#include "skylut/models/channel_sky.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/models/model_conditions.hpp"

namespace skylut {

namespace {

// Formulas may fall below 0 where they fit badly; light does not, and its logarithm must exist.
constexpr double kLeastLight = 1e-30;

}  // namespace

void ChannelSky::colour(std::span<const Direction> views, std::span<Yxy> colours) const {
  require_views(frame_->info, views, colours.size());
  std::vector<double> channel(channels().size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    values(views[i], channel);
    colours[i] = channels().colour(channel);
  }
}

const WavelengthGrid* ChannelSky::wavelengths() const {
  return channels().wavelengths ? &*channels().wavelengths : nullptr;
}

void ChannelSky::radiance(std::span<const Direction> views, std::span<float> radiance) const {
  if (wavelengths() == nullptr) return Sky::radiance(views, radiance);
  const std::size_t width = channels().size();
  require_views(frame_->info, views, radiance.size() / width);
  std::vector<double> channel(width);
  for (std::size_t i = 0; i < views.size(); ++i) {
    values(views[i], channel);
    std::transform(channel.begin(), channel.end(), radiance.begin() + static_cast<std::ptrdiff_t>(i * width),
                   [](double value) { return static_cast<float>(value); });
  }
}

void BlendedSky::values(const Direction& view, std::span<double> values) const {
  if (parts_.size() == 1) return parts_.front().sky->values(view, values);
  std::vector<double> part(values.size());
  std::fill(values.begin(), values.end(), 0.0);
  for (const Part& blended : parts_) {
    blended.sky->values(view, part);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] +=
          blended.weight * (channels().is_light(i) ? std::log(std::max(part[i], kLeastLight)) : part[i]);
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    if (channels().is_light(i)) values[i] = std::exp(values[i]);
}

}  // namespace skylut
