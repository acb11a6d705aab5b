#include "training_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "feature_encoder.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"

namespace skylut::compact {

namespace {

/// Where there is less haze, it is as bright per load as here.
constexpr double kLeastLoad = 1e-4;
/// Between them the light of a line is as the haze's typical.
constexpr std::array kTypicalAltitudes_km{0.0, 6.0, 20.0};
constexpr std::array kTypicalZeniths_deg{30.0, 80.0, 89.5};
constexpr std::array kTypicalSuns_deg{45.0, 85.0};
/// By which the spherical albedo is told.
constexpr double kGreyAlbedo = 0.5;

std::vector<double> azimuths(std::size_t count) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k)
    values.push_back(180.0 * static_cast<double>(k) / static_cast<double>(count - 1));
  return values;
}

SolvedColumns solved(const Context& context, const SkyScene& scene, const TrainingSpectrum& spectrum,
                     const Nodes& nodes, double albedo, TransferOptions options) {
  options.discretisation.sun_bands = false;  // every line is asked for under all suns
  std::vector<OpticalColumn> columns;
  for (const double load : nodes.aod500)
    for (OpticalColumn& column : spectrum.columns(*scene.atmosphere, std::max(load, kLeastLoad), albedo))
      columns.push_back(std::move(column));
  return {context, scene.atmosphere->shells(), std::move(columns), nodes.suns_deg, options};
}

/// Amplitudes per load, means over some lines. (column, part)
Eigen::MatrixXd typical_brightness(const SolvedColumns& sky, const Nodes& nodes) {
  const std::vector<double> around = azimuths(5);
  const std::size_t columns = sky.columns();
  const std::size_t parts = sky.parts();
  Eigen::MatrixXd sum =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(columns), static_cast<Eigen::Index>(parts));
  std::vector<float> values(kTypicalSuns_deg.size() * parts * around.size() * columns);
  for (const double altitude_km : kTypicalAltitudes_km)
    for (const double zenith_deg : kTypicalZeniths_deg) {
      sky.radiance_parts(SightFan{altitude_km, zenith_deg, kTypicalSuns_deg, around}, values);
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t column = i % columns;
        const std::size_t part = i / (columns * around.size()) % parts;
        sum(static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(part)) +=
            static_cast<double>(values[i]);
      }
    }
  const std::size_t samples = columns / nodes.aod500.size();
  for (std::size_t column = 0; column < columns; ++column)
    sum.row(static_cast<Eigen::Index>(column)) /= std::max(nodes.aod500[column / samples], kLeastLoad);
  return sum;
}

/// Where a node is looked at: those at the horizon on the side that their panel is on.
double beside_horizon(const ZenithGrid& zenith, std::size_t node, double altitude_km) {
  constexpr double kBeside_deg = 1e-6;
  const std::size_t ground = zenith.counts().above + zenith.counts().limb;
  const double zenith_deg = zenith.node_zenith_deg(node, altitude_km);
  return node + 1 == ground ? zenith_deg - kBeside_deg
         : node == ground   ? zenith_deg + kBeside_deg
                            : zenith_deg;
}

/// Collects the channels of one load from the parts of its columns.
class ChannelSums {
 public:
  ChannelSums(const TrainingSpectrum& spectrum, const HazeTerms& haze, std::size_t load, std::size_t parts)
      : first_(load * spectrum.samples()),
        samples_(spectrum.samples()),
        channels_(spectrum.channels()),
        parts_(parts),
        terms_(haze.terms()),
        weight_(static_cast<Eigen::Index>(parts * samples_),
                static_cast<Eigen::Index>((2 + terms_) * channels_)) {
    weight_.setZero();
    for (std::size_t c = 0; c < channels_; ++c)
      for (std::size_t i = 0; i < samples_; ++i) {
        const double weight = spectrum.weights()[c][i];
        at(0, i, 0, c) = static_cast<float>(weight);
        at(parts - 1, i, 1 + terms_, c) = static_cast<float>(weight);
        for (std::size_t part = 1; part + 1 < parts; ++part)
          for (std::size_t k = 0; k < terms_; ++k)
            at(part, i, 1 + k, c) = static_cast<float>(weight * haze.share(k, first_ + i, part));
      }
  }

  /// @param values  [part][azimuth][column] of one sun
  /// @return (azimuth, [molecules, haze terms, diffuse][channel])
  Eigen::MatrixXd operator()(std::span<const float> values, std::size_t azimuths, std::size_t columns) const {
    Eigen::MatrixXf gathered(static_cast<Eigen::Index>(azimuths),
                             static_cast<Eigen::Index>(parts_ * samples_));
    for (std::size_t part = 0; part < parts_; ++part)
      for (std::size_t azimuth = 0; azimuth < azimuths; ++azimuth)
        for (std::size_t i = 0; i < samples_; ++i)
          gathered(static_cast<Eigen::Index>(azimuth), static_cast<Eigen::Index>(part * samples_ + i)) =
              values[(part * azimuths + azimuth) * columns + first_ + i];
    return (gathered * weight_).cast<double>();
  }

 private:
  float& at(std::size_t part, std::size_t sample, std::size_t field, std::size_t channel) {
    return weight_(static_cast<Eigen::Index>(part * samples_ + sample),
                   static_cast<Eigen::Index>(field * channels_ + channel));
  }

  std::size_t first_;
  std::size_t samples_;
  std::size_t channels_;
  std::size_t parts_;
  std::size_t terms_;
  Eigen::MatrixXf weight_;  // (part and sample, field and channel)
};

/// All the lines of a training.
class Trainer {
 public:
  Trainer(const Context& context, const SkyScene& scene, const TrainingSpectrum& spectrum, const Nodes& nodes,
          std::size_t haze_terms, const TransferOptions& options)
      : context_(context),
        spectrum_(spectrum),
        nodes_(nodes),
        black_(solved(context, scene, spectrum, nodes, 0.0, options)),
        white_(solved(context, scene, spectrum, nodes, 1.0, options)),
        haze_(black_, typical_brightness(black_, nodes), haze_terms),
        layout_(spectrum.channels(), haze_terms),
        encoder_(layout_, haze_.mean()) {
    for (std::size_t load = 0; load < nodes.aod500.size(); ++load)
      sums_.emplace_back(spectrum, haze_, load, black_.parts());
  }

  const HazeTerms& haze() const { return haze_; }
  const SolvedColumns& black() const { return black_; }

  void follow_all(const ZenithGrid& zenith, std::vector<float>& features) const {
    const std::size_t altitudes = nodes_.altitudes_km.size();
    features.assign(
        nodes_.aod500.size() * altitudes * nodes_.suns_deg.size() * zenith.size() * layout_.size(), 0.0f);
    parallel_for(altitudes * zenith.size(), context_.threads, [&](std::size_t line) {
      if (context_.cancel.stop_requested()) throw Cancelled();
      follow(zenith, line / zenith.size(), line % zenith.size(), features);
    });
  }

  /// P of molecules at an angle as each channel sees it.
  std::vector<double> rayleigh(double cos_scattering) const {
    std::vector<double> factors(black_.parts());
    std::vector<double> values;
    for (const std::vector<double>& weights : spectrum_.weights()) {
      double sum = 0.0;
      double weight = 0.0;
      for (std::size_t i = 0; i < spectrum_.samples(); ++i) {
        black_.part_factors(i, cos_scattering, factors);
        sum += weights[i] * factors.front();
        weight += weights[i];
      }
      values.push_back(sum / weight);
    }
    return values;
  }

  /// S, from how much of a white ground's light a grey one gives: w = A (1 - S)/(1 - A S); in the light of
  /// the sky, then of the ground itself. [2][load][channel]
  std::vector<float> spherical_albedo(const SolvedColumns& grey) const {
    std::vector<float> result;
    for (const double zenith_deg : {45.0, 150.0}) {
      const std::vector<float> none = diffuse_light(black_, zenith_deg);
      const std::vector<float> half = diffuse_light(grey, zenith_deg);
      const std::vector<float> all = diffuse_light(white_, zenith_deg);
      for (std::size_t load = 0; load < nodes_.aod500.size(); ++load)
        for (const std::vector<double>& weights : spectrum_.weights()) {
          double of_grey = 0.0;
          double of_white = 0.0;
          for (std::size_t i = 0; i < weights.size(); ++i) {
            const std::size_t column = load * weights.size() + i;
            of_grey += weights[i] * static_cast<double>(half[column] - none[column]);
            of_white += weights[i] * static_cast<double>(all[column] - none[column]);
          }
          const double w = of_grey / of_white;
          result.push_back(
              static_cast<float>(std::clamp((kGreyAlbedo - w) / (kGreyAlbedo * (1.0 - w)), 0.0, 0.9)));
        }
    }
    return result;
  }

 private:
  // At one zenith angle from the ground. [column]
  static std::vector<float> diffuse_light(const SolvedColumns& sky, double zenith_deg) {
    const std::array view_azimuth{90.0};
    const std::array sun_deg{54.0};
    std::vector<float> values(sky.parts() * sky.columns());
    sky.radiance_parts(SightFan{0.0, zenith_deg, sun_deg, view_azimuth}, values);
    return {values.end() - static_cast<std::ptrdiff_t>(sky.columns()), values.end()};
  }

  void follow(const ZenithGrid& zenith, std::size_t altitude, std::size_t node,
              std::vector<float>& features) const {
    const double altitude_km = nodes_.altitudes_km[altitude];
    const double zenith_deg = beside_horizon(zenith, node, altitude_km);
    const std::size_t suns = nodes_.suns_deg.size();
    const std::size_t columns = black_.columns();
    const std::size_t parts = black_.parts();
    const std::vector<double> around = azimuths(SkyRow::kAzimuths);
    const std::vector<double> around_ground = azimuths(SkyRow::kGroundAzimuths);
    std::vector<float> black(suns * parts * around.size() * columns);
    std::vector<float> white(suns * parts * around_ground.size() * columns);
    black_.radiance_parts(SightFan{altitude_km, zenith_deg, nodes_.suns_deg, around}, black);
    white_.radiance_parts(SightFan{altitude_km, zenith_deg, nodes_.suns_deg, around_ground}, white);
    for (std::size_t load = 0; load < nodes_.aod500.size(); ++load)
      for (std::size_t sun = 0; sun < suns; ++sun) {
        const auto of_sun = [&](const std::vector<float>& values) {
          const std::size_t each = values.size() / suns;
          return std::span(values).subspan(sun * each, each);
        };
        const std::size_t condition = (load * nodes_.altitudes_km.size() + altitude) * suns + sun;
        encoder_.encode(
            row(sums_[load](of_sun(black), around.size(), columns),
                sums_[load](of_sun(white), around_ground.size(), columns)),
            std::max(nodes_.aod500[load], kLeastLoad),
            std::span(features).subspan((condition * zenith.size() + node) * layout_.size(), layout_.size()));
      }
  }

  SkyRow row(const Eigen::MatrixXd& black, const Eigen::MatrixXd& white) const {
    const auto channels = static_cast<Eigen::Index>(layout_.channels());
    const auto field = [&](const Eigen::MatrixXd& from, std::size_t index) {
      return from.middleCols(static_cast<Eigen::Index>(index) * channels, channels);
    };
    SkyRow row;
    row.molecules = field(black, 0);
    for (std::size_t k = 0; k < haze_.terms(); ++k) row.haze.emplace_back(field(black, 1 + k));
    row.diffuse = field(black, 1 + haze_.terms());
    row.ground = field(white, 1 + haze_.terms());
    const auto step = static_cast<Eigen::Index>((SkyRow::kAzimuths - 1) / (SkyRow::kGroundAzimuths - 1));
    for (Eigen::Index i = 0; i < row.ground.rows(); ++i) row.ground.row(i) -= row.diffuse.row(step * i);
    return row;
  }

  const Context& context_;
  const TrainingSpectrum& spectrum_;
  const Nodes& nodes_;
  SolvedColumns black_;
  SolvedColumns white_;
  HazeTerms haze_;
  Layout layout_;
  FeatureEncoder encoder_;
  std::vector<ChannelSums> sums_;  // [load]
};

}  // namespace

TrainingFields training_fields(const Context& context, const SkyScene& scene,
                               const TrainingSpectrum& spectrum, const Nodes& nodes,
                               const ZenithGrid::Counts& zenith_counts, std::size_t haze_terms,
                               const TransferOptions& options) {
  const Trainer trainer(context, scene, spectrum, nodes, haze_terms, options);
  TrainingFields fields;
  fields.nodes = nodes;
  fields.planet_radius_km = scene.atmosphere->shells().planet_radius_km;
  fields.zenith = ZenithGrid(zenith_counts, fields.planet_radius_km);
  fields.haze = std::make_unique<const HazeTerms>(trainer.haze());
  fields.rayleigh_0 = trainer.rayleigh(1.0);
  fields.rayleigh_90 = trainer.rayleigh(0.0);
  fields.spherical_albedo =
      trainer.spherical_albedo(solved(context, scene, spectrum, nodes, kGreyAlbedo, options));
  trainer.follow_all(fields.zenith, fields.features);
  return fields;
}

}  // namespace skylut::compact
