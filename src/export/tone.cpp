#include "export/tone.hpp"

#include <algorithm>
#include <cmath>

namespace skylut {

namespace {

constexpr double kMiddleGrey = 0.18;  // Reinhard et al. 2002 §3.1

// How much of the way from white of luminance Y to a channel's value stays within 0 to 1.
double kept_share(double channel, double Y) {
  if (channel < 0.0) return Y / (Y - channel);
  if (channel > 1.0) return (1.0 - Y) / (channel - Y);
  return 1.0;
}

}  // namespace

ToneCurve::ToneCurve(double grey_cd_m2, double white_cd_m2)
    : scale_(kMiddleGrey / grey_cd_m2), white_(scale_ * white_cd_m2) {}

double ToneCurve::operator()(double luminance_cd_m2) const {
  const double L = scale_ * luminance_cd_m2;
  if (L >= white_) return L > 0.0 ? 1.0 : 0.0;
  return std::min(1.0, L * (1.0 + L / (white_ * white_)) / (1.0 + L));
}

DisplayedColour displayed(const Xyz& light, const ToneCurve& curve) {
  if (!(light.Y > 0.0)) return {};
  const double Y = curve(light.Y);
  const double scale = Y / light.Y;
  const LinearRgb rgb = to_linear_srgb(Xyz{scale * light.X, Y, scale * light.Z});
  const double kept = std::min({kept_share(rgb.r, Y), kept_share(rgb.g, Y), kept_share(rgb.b, Y)});
  const auto mixed = [&](double channel) { return std::clamp(Y + kept * (channel - Y), 0.0, 1.0); };
  const double farthest = std::max({std::abs(rgb.r - Y), std::abs(rgb.g - Y), std::abs(rgb.b - Y)});
  return {{mixed(rgb.r), mixed(rgb.g), mixed(rgb.b)}, (1.0 - kept) * farthest};
}

double srgb_encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

}  // namespace skylut
