#pragma once

#include <array>
#include <cstddef>

namespace skylut::compact {

/// What stands for the sky at one zenith angle: fields, each a cosine series in azimuth φ from the sun, for
/// every channel (X, Y, Z and any wavelengths). With P the phase function of molecules, u_k(Θ) functions that
/// span those of the haze, l the haze's optical depth, w the ground's share (CompactSky):
///   T      ln of the sky's brightness t_Y, were every scatterer isotropic, over a ground of albedo 0.2
///   x      ln t/t_Y of the other channels
///   ρ      molecules' single scattering, in t: R = ρ t
///   α      haze's single scattering: ln(a/(l t) + ε)
///   κ_k    its further terms, in a + ε l t; k = 1, 2, …
///   γ      ground's light: ln of its azimuthal mean in e^{mean of ln t}, and its other orders in that mean:
///   G
/// and the radiance is
///   L = P R + [u_0 a + Σ u_k κ_k (a + ε l t)]/ū_0 + (t - R - a - G/5) + w G. [models.md]
/// Everything is of the order of 1 and smooth in all conditions, and t is never negative.
///
/// Fields stand in the order of how many cosines they have, so that an order m is a run of them.
class Layout {
 public:
  /// @param terms  u_k, at least 1
  constexpr Layout(std::size_t channels, std::size_t terms) : channels_(channels), terms_(terms) {
    std::size_t fields = 0;
    for (const auto& [first, count, orders] :
         {Group{brightness(), 1, 9}, Group{haze(0), channels, 7}, Group{molecules(0), channels, 5},
          Group{ratio(0), channels - 1, 5}, Group{term(1, 0), (terms - 1) * channels, 3},
          Group{ground(0), channels, 3}}) {
      fields = first + count;
      for (std::size_t m = 0; m < orders; ++m) fields_of_order_[m] = fields;
    }
    for (std::size_t m = 0; m < kOrders; ++m) {
      offset_[m] = size_;
      size_ += fields_of_order_[m];
    }
  }

  static constexpr std::size_t kOrders = 9;
  static constexpr double kFloor = 1e-3;  ///< ε

  std::size_t channels() const { return channels_; }
  std::size_t terms() const { return terms_; }
  /// Numbers of one zenith angle: [m][fields of that order].
  std::size_t size() const { return size_; }
  std::size_t fields() const { return fields_of_order_[0]; }
  std::size_t fields_of_order(std::size_t m) const { return fields_of_order_[m]; }
  std::size_t offset(std::size_t m) const { return offset_[m]; }
  std::size_t at(std::size_t m, std::size_t field) const { return offset_[m] + field; }
  /// Orders of a field.
  std::size_t orders(std::size_t field) const {
    std::size_t m = 0;
    while (m < kOrders && field < fields_of_order_[m]) ++m;
    return m;
  }

  // Indices of the fields. The ratio's channels leave out the second, Y.
  constexpr std::size_t brightness() const { return 0; }
  constexpr std::size_t haze(std::size_t channel) const { return 1 + channel; }
  constexpr std::size_t molecules(std::size_t channel) const { return 1 + channels_ + channel; }
  constexpr std::size_t ratio(std::size_t other) const { return 1 + 2 * channels_ + other; }
  constexpr std::size_t term(std::size_t k, std::size_t channel) const {
    return 3 * channels_ + (k - 1) * channels_ + channel;
  }
  constexpr std::size_t ground(std::size_t channel) const { return (2 + terms_) * channels_ + channel; }

  static constexpr std::size_t kY = 1;  ///< the channel that the others are divided by
  /// Index among the ratios of a channel other than Y.
  static constexpr std::size_t other(std::size_t channel) { return channel < kY ? channel : channel - 1; }

 private:
  struct Group {
    std::size_t first;
    std::size_t count;
    std::size_t orders;
  };
  std::size_t channels_;
  std::size_t terms_;
  std::array<std::size_t, kOrders> fields_of_order_{};
  std::array<std::size_t, kOrders> offset_{};
  std::size_t size_ = 0;
};

}  // namespace skylut::compact
