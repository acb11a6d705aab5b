#include "skylut/models/compact_sky.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "compact/clones.hpp"
#include "compact/expansion.hpp"
#include "compact/fast_math.hpp"
#include "compact/weighted_rows.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

using compact::Expansion;
using compact::fast_acos;
using compact::fast_exp;
using compact::Layout;
using compact::SplineTaps;
using compact::weighted_rows;
using compact::ZenithGrid;

/// Below this share of the sky's brightness nothing falls, whatever the table says.
constexpr float kDarkest = 1e-3f;
/// The ground that t is over.
constexpr float kUsualAlbedo = 0.2f;
/// The smallest load that the haze is divided by.
constexpr double kLeastLoad = 1e-4;

/// One direction as the sky needs it.
struct View {
  float cos_azimuth;
  float cos_scattering;
};

/// Any number of channels and terms.
struct AnyShape {
  using Numbers = std::vector<float>;
  static Numbers numbers(std::size_t count) { return Numbers(count); }
  explicit AnyShape(const Layout& of) : layout(of) {}
  const Layout& layout;
};

/// X, Y, Z and five terms, known to the compiler.
struct ColourShape {
  using Numbers = std::array<float, 141>;
  static Numbers numbers(std::size_t) { return {}; }
  explicit ColourShape(const Layout&) {}
  static constexpr Layout layout{3, 5};
  static bool fits(const Layout& other) {
    return other.channels() == layout.channels() && other.terms() == layout.terms();
  }
};

/// Works out the channels of one direction after another.
template <class Shape>
class Synthesis {
 public:
  Synthesis(const Expansion& expansion, double aod500)
      : expansion_(expansion),
        shape_(expansion.layout()),
        tables_(expansion.tables()),
        load_(static_cast<float>(std::max(aod500, kLeastLoad))),
        inverse_mean_(static_cast<float>(1.0 / tables_.haze_mean)),
        scratch_(Shape::numbers(shape_.layout.size() + shape_.layout.fields() + shape_.layout.terms() +
                                4 * shape_.layout.channels())) {
    std::span<float> left(scratch_);
    const auto take = [&left](std::size_t count) {
      const std::span<float> taken = left.first(count);
      left = left.subspan(count);
      return taken;
    };
    row_ = take(shape_.layout.size());
    sum_ = take(shape_.layout.fields());
    haze_ = take(shape_.layout.terms());
    powers_ = take(3 * shape_.layout.channels());
    radiance_ = take(shape_.layout.channels());
  }
  Synthesis(const Synthesis&) = delete;
  Synthesis& operator=(const Synthesis&) = delete;

  /// The zenith angle from now on.
  void look_at(std::span<const float> features, const SplineTaps& taps) {
    float weight[4];
    std::copy_n(taps.weight, 4, weight);
    weighted_rows(weight, features.data() + taps.first * shape_.layout.size(), row_);
  }

  /// What channels() works out. [channel]
  std::span<float> radiance() { return radiance_; }

  void channels(const View& view, std::span<const float> ground_share) {
    sum_series(view.cos_azimuth);
    haze_at(view.cos_scattering);
    const std::size_t channels = shape_.layout.channels();
    // Three exponentials per channel: brightness, haze, ground's mean. [channel], [channel], [channel]
    for (std::size_t c = 0; c < channels; ++c) {
      const bool first = c == Layout::kY;
      powers_[c] = sum_[0] + (first ? 0.0f : sum_[shape_.layout.ratio(Layout::other(c))]);
      powers_[channels + c] = sum_[shape_.layout.haze(c)];
      powers_[2 * channels + c] = row_[0] + (first ? 0.0f : row_[shape_.layout.ratio(Layout::other(c))]) +
                                  row_[shape_.layout.ground(c)];
    }
    for (float& power : powers_) power = fast_exp(power);
    const std::span<const float> rayleigh_90 = expansion_.rayleigh_90();
    const std::span<const float> rayleigh_rise = expansion_.rayleigh_rise();
    const float polar = view.cos_scattering * view.cos_scattering;
    constexpr auto kFloor = static_cast<float>(Layout::kFloor);
    for (std::size_t c = 0; c < channels; ++c) {
      const float brightness = powers_[c];
      const float molecules = sum_[shape_.layout.molecules(c)] * brightness;
      const float unit = load_ * brightness;
      const float haze = std::max(powers_[channels + c] - kFloor, 0.0f) * unit;
      float terms = 0.0f;
      for (std::size_t k = 1; k < shape_.layout.terms(); ++k)
        terms += haze_[k] * sum_[shape_.layout.term(k, c)];
      const std::size_t g = shape_.layout.ground(c);
      const float mean_ground = powers_[2 * channels + c];
      const float ground = mean_ground * (1.0f + sum_[g] - row_[g]);
      const float value = (rayleigh_90[c] + rayleigh_rise[c] * polar) * molecules +
                          (haze_[0] * haze + terms * (haze + kFloor * unit)) * inverse_mean_ +
                          (brightness - molecules - haze - kUsualAlbedo * mean_ground) +
                          ground_share[c] * ground;
      radiance_[c] = std::max(value, kDarkest * brightness);
    }
  }

 private:
  // Σ_m cos(mφ) row_m of every field.
  void sum_series(float cos_azimuth) {
    for (std::size_t i = 0; i < shape_.layout.fields(); ++i) sum_[i] = row_[i];
    float before = 1.0f;
    float cosine = cos_azimuth;
    for (std::size_t m = 1; m < Layout::kOrders; ++m) {
      const float* order = row_.data() + shape_.layout.offset(m);
      for (std::size_t i = 0; i < shape_.layout.fields_of_order(m); ++i) sum_[i] += cosine * order[i];
      before = std::exchange(cosine, 2.0f * cos_azimuth * cosine - before);
    }
  }

  // u_k, linear between angles that lie 0.003° apart near the sun.
  void haze_at(float cos_scattering) {
    const std::size_t terms = shape_.layout.terms();
    const std::size_t angles = tables_.haze_terms.size() / terms;
    const auto last = static_cast<float>(angles - 1);
    const float angle = fast_acos(cos_scattering);
    const float at = std::sqrt(angle * static_cast<float>(1.0 / kPi)) * last;
    const float below = std::min(std::floor(at), last - 1.0f);
    const float t = at - below;
    const float* from = tables_.haze_terms.data() + static_cast<std::size_t>(below) * terms;
    for (std::size_t k = 0; k < terms; ++k) haze_[k] = from[k] + t * (from[terms + k] - from[k]);
  }

  const Expansion& expansion_;
  [[no_unique_address]] Shape shape_;
  const compact::Tables& tables_;
  float load_;
  float inverse_mean_;
  typename Shape::Numbers scratch_;  // of all that follow
  std::span<float> row_;             // [number], at one zenith angle
  std::span<float> sum_;             // [field], in one direction
  std::span<float> haze_;            // u_k
  std::span<float> powers_;          // [3][channel]
  std::span<float> radiance_;        // [channel]
};

SKYLUT_CLONES void synthesise(Synthesis<ColourShape>& synthesis, const View& view,
                              std::span<const float> ground_share) {
  synthesis.channels(view, ground_share);
}

SKYLUT_CLONES void synthesise(Synthesis<AnyShape>& synthesis, const View& view,
                              std::span<const float> ground_share) {
  synthesis.channels(view, ground_share);
}

class CompactSky final : public Sky {
 public:
  CompactSky(std::shared_ptr<const Expansion> expansion, const SkyConditions& conditions, const Range& views)
      : expansion_(std::move(expansion)),
        altitude_km_(conditions.altitude_km),
        aod500_(conditions.turbidity.value),
        sun_(conditions.sun),
        views_(views),
        features_(expansion_->features(altitude_km_, aod500_, sun_.zenith_deg)),
        sky_share_(expansion_->ground_share(aod500_, conditions.albedo, false)),
        ground_share_(expansion_->ground_share(aod500_, conditions.albedo, true)) {
    const std::vector<double>& nm = expansion_->tables().wavelengths_nm;
    if (nm.size() > 1) wavelengths_.emplace(nm.front(), nm.back(), nm[1] - nm[0]);
    if (nm.size() == 1) wavelengths_.emplace(nm.front(), nm.front(), 5.0);
  }

  using Sky::colour;
  void colour(std::span<const Direction> views, std::span<Yxy> colours) const override {
    SKYLUT_CHECK_EQ(views.size(), colours.size());
    look(views, [&](std::size_t i, std::span<const float> channels) {
      colours[i] = to_yxy({static_cast<double>(channels[0]), static_cast<double>(channels[1]),
                           static_cast<double>(channels[2])});
    });
  }

  const WavelengthGrid* wavelengths() const override { return wavelengths_ ? &*wavelengths_ : nullptr; }

  void radiance(std::span<const Direction> views, std::span<float> radiance) const override {
    if (!wavelengths_) return Sky::radiance(views, radiance);
    const std::size_t width = wavelengths_->size();
    SKYLUT_CHECK_EQ(views.size() * width, radiance.size());
    look_with<AnyShape>(views, [&](std::size_t i, std::span<const float> channels) {
      std::copy_n(channels.data() + 3, width, radiance.data() + i * width);
    });
  }

 private:
  template <class Use>
  void look(std::span<const Direction> views, const Use& use) const {
    if (ColourShape::fits(expansion_->layout())) return look_with<ColourShape>(views, use);
    look_with<AnyShape>(views, use);
  }

  template <class Shape, class Use>
  void look_with(std::span<const Direction> views, const Use& use) const {
    Synthesis<Shape> synthesis(*expansion_, aod500_);
    const std::span<float> channels = synthesis.radiance();
    const double cos_sun = std::cos(sun_.zenith_deg * kRadiansPerDegree);
    const double sin_sun = std::sin(sun_.zenith_deg * kRadiansPerDegree);
    const ZenithGrid::Counts& counts = expansion_->zenith().counts();
    const std::size_t sky_nodes = counts.above + counts.limb;
    std::span<const float> share = sky_share_;
    double cos_view = 0.0;
    double sin_view = 0.0;
    for (std::size_t i = 0; i < views.size(); ++i) {
      const Direction& view = views[i];
      if (i == 0 || view.zenith_deg != views[i - 1].zenith_deg) {
        require_within("view zenith angle", view.zenith_deg, views_);
        const SplineTaps taps = expansion_->zenith().taps(view.zenith_deg, altitude_km_);
        share = taps.first >= sky_nodes ? ground_share_ : sky_share_;
        synthesis.look_at(features_, taps);
        cos_view = std::cos(view.zenith_deg * kRadiansPerDegree);
        sin_view = std::sqrt(std::max(0.0, 1.0 - cos_view * cos_view));
      }
      const double cos_azimuth = std::cos((view.azimuth_deg - sun_.azimuth_deg) * kRadiansPerDegree);
      synthesise(synthesis,
                 {static_cast<float>(cos_azimuth),
                  static_cast<float>(cos_view * cos_sun + sin_view * sin_sun * cos_azimuth)},
                 share);
      use(i, channels);
    }
  }

  std::shared_ptr<const Expansion> expansion_;
  double altitude_km_;
  double aod500_;
  Direction sun_;
  Range views_;
  std::optional<WavelengthGrid> wavelengths_;
  std::vector<float> features_;      // [zenith node][number]
  std::vector<float> sky_share_;     // of the ground in the light of the sky, [channel]
  std::vector<float> ground_share_;  // in that of the ground in view
};

}  // namespace

CompactSkyModel::CompactSkyModel(ModelInfo info, compact::Tables tables)
    : info_(std::move(info)), expansion_(std::make_shared<const Expansion>(std::move(tables))) {}

CompactSkyModel::~CompactSkyModel() = default;

std::unique_ptr<const SkyModel> CompactSkyModel::read(const ModelInfo& info, const JsonReader& model) {
  return std::make_unique<const CompactSkyModel>(info, compact::read_tables(model));
}

std::unique_ptr<const Sky> CompactSkyModel::at(const SkyConditions& conditions) const {
  if (conditions.turbidity.kind != info_.turbidity_kind)
    throw InputError("{}: turbidity of kind {}: must be {}", info_.name,
                     turbidity_kind_name(conditions.turbidity.kind),
                     turbidity_kind_name(info_.turbidity_kind));
  require_within("altitude", conditions.altitude_km, info_.altitude_km);
  require_within("aod500", conditions.turbidity.value, info_.turbidity);
  require_within("ground albedo", conditions.albedo, *info_.albedo);
  require_within("sun zenith angle", conditions.sun.zenith_deg, info_.sun_zenith_deg);
  return std::make_unique<const CompactSky>(expansion_, conditions, info_.view_zenith_deg);
}

}  // namespace skylut
