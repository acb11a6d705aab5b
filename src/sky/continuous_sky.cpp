#include "skylut/sky/continuous_sky.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "horizon.hpp"
#include "sky_patch.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/transfer/refraction.hpp"

namespace skylut {

namespace {

constexpr int kPoints = 6;
constexpr int kAzimuths = 9;
constexpr int kMostAzimuths = 65;

/// What a patch is compared in: lines of sight at three zenith angles. The first two lie between the patch's
/// points, the third at one. The first azimuths are the patch's own, the others lie between them.
struct Comparison {
  double zenith_deg;
  std::vector<double> azimuths_deg;
  std::size_t at_nodes;      ///< of the azimuths
  std::vector<float> exact;  ///< [azimuth][wavelength]
};

/// A patch while it is built.
struct Draft {
  SkyPatch patch;
  int refinements = 0;
  std::vector<Comparison> comparisons;
  double zenith_error = 0.0;   ///< where the azimuth is the patch's own
  double azimuth_error = 0.0;  ///< between the patch's azimuths

  double error() const { return std::max(zenith_error, azimuth_error); }
};

double between(const SkyPatch& patch, int point) {
  return patch.panel().zenith_deg(0.5 * (patch.point(point) + patch.point(point + 1)));
}

std::vector<Comparison> comparisons_of(const SkyPatch& patch) {
  if (patch.points() < kPoints) return {};
  const std::vector<double>& own = patch.azimuths_deg();
  const std::size_t last = own.size() - 1;
  std::vector<double> azimuths_deg;
  for (const std::size_t node : {std::size_t{0}, last / 4, last / 2, 3 * last / 4, last})
    azimuths_deg.push_back(own[node]);
  const std::size_t at_nodes = azimuths_deg.size();
  if (last > 0)
    for (const std::size_t node : {std::size_t{0}, last / 4, last / 2, 3 * last / 4, last - 1})
      azimuths_deg.push_back(own[node] + 0.5 * own[1]);
  return {{between(patch, 0), azimuths_deg, at_nodes, {}},
          {between(patch, 2), azimuths_deg, at_nodes, {}},
          {patch.point_zenith_deg(2), azimuths_deg, at_nodes, {}}};
}

/// The relative error of luminance, or a third of that of the worst wavelength if it is more.
double relative_error(const SolvedSky& sky, std::span<const float> found, std::span<const float> exact) {
  constexpr double kWavelengthShare = 1.0 / 3.0;
  double largest = 0.0;
  double luminance = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const auto value = static_cast<double>(exact[i]);
    const double off = static_cast<double>(found[i]) - value;
    if (value > 0.0) largest = std::max(largest, kWavelengthShare * std::abs(off) / value);
    luminance += sky.colour_weights()[i].Y * value;
    difference += sky.colour_weights()[i].Y * off;
  }
  return luminance > 0.0 ? std::max(largest, std::abs(difference) / luminance) : largest;
}

/// Builds the patches of one sky, in rounds: whatever is not yet within the tolerance goes into the next.
class PatchBuilder {
 public:
  PatchBuilder(const Context& context, const SolvedSky& sky, double observer_km, double sun_zenith_deg,
               const ContinuousSkyOptions& options)
      : context_(context),
        sky_(sky),
        observer_km_(observer_km),
        sun_deg_(sun_zenith_deg),
        apparent_(apparent_shells(sky.shells())),
        apparent_km_(apparent_altitude_km(sky.shells(), observer_km)),
        apparent_sun_deg_(apparent_sun(sky.shells(), observer_km, sun_zenith_deg).zenith_deg),
        options_(options) {}

  std::vector<SkyPatch> build(double& error) {
    std::vector<Draft> open;
    for (const ZenithPanel& panel :
         zenith_panels(apparent_.levels_km, apparent_km_, apparent_.planet_radius_km))
      open.push_back(draft(panel));
    std::vector<SkyPatch> done;
    while (!open.empty()) {
      compute(open);
      std::vector<Draft> next;
      for (Draft& draft : open) {
        compare(draft);
        if (draft.error() > options_.tolerance && draft.refinements < options_.most_refinements) {
          refine(draft, next);
          continue;
        }
        error = std::max(error, draft.error());
        draft.patch.set_colours(sky_);
        done.push_back(std::move(draft.patch));
      }
      open = std::move(next);
    }
    std::sort(done.begin(), done.end(), [](const SkyPatch& a, const SkyPatch& b) {
      return a.panel().lowest_zenith_deg() < b.panel().lowest_zenith_deg();
    });
    return done;
  }

 private:
  /// Where the sun stands overhead nothing depends on azimuth, nor does the ground under one's feet.
  Draft draft(const ZenithPanel& panel) const {
    const bool ground = observer_km_ == 0.0 && panel.kind() == ZenithPanel::Kind::ground;
    const bool overhead = sun_deg_ < 1e-9;
    return {SkyPatch(panel, ground ? 2 : kPoints, ground || overhead ? 1 : kAzimuths), 0, {}, 0.0, 0.0};
  }

  /// All lines of sight of all drafts, in parallel: the points of a patch together, each comparison.
  void compute(std::vector<Draft>& drafts) const {
    struct Task {
      Draft* draft;
      Comparison* comparison;  // null: the points
    };
    std::vector<Task> tasks;
    for (Draft& draft : drafts) {
      draft.comparisons = comparisons_of(draft.patch);
      tasks.push_back({&draft, nullptr});
      for (Comparison& comparison : draft.comparisons) tasks.push_back({&draft, &comparison});
    }
    parallel_for(tasks.size(), context_.threads, [&](std::size_t index) {
      if (context_.cancel.stop_requested()) throw Cancelled();
      const auto& [draft, with] = tasks[index];
      if (with == nullptr) {
        draft->patch.set_points(sky_, observer_km_, sun_deg_);
        return;
      }
      with->exact.resize(with->azimuths_deg.size() * sky_.wavelengths().size());
      sky_.radiance({observer_km_, with->zenith_deg, sun_deg_, with->azimuths_deg}, with->exact);
    });
  }

  void compare(Draft& draft) const {
    const std::size_t width = sky_.wavelengths().size();
    std::vector<float> row(draft.patch.row_size());
    std::vector<float> scratch;
    std::vector<float> found(width);
    for (const Comparison& with : draft.comparisons) {
      draft.patch.row(with.zenith_deg, row);
      for (std::size_t k = 0; k < with.azimuths_deg.size(); ++k) {
        SkyPatch::radiance(sky_.factors_of_point(), row,
                           patch_direction(with.zenith_deg, with.azimuths_deg[k], apparent_sun_deg_), scratch,
                           found);
        double& error = k < with.at_nodes ? draft.zenith_error : draft.azimuth_error;
        error = std::max(error, relative_error(sky_, found, std::span(with.exact).subspan(k * width, width)));
      }
    }
  }

  void refine(const Draft& draft, std::vector<Draft>& next) const {
    const int azimuths = draft.patch.azimuths();
    // Between the azimuths both errors are felt: the azimuths are too few if it is clearly more there.
    const bool around = draft.azimuth_error > std::max(options_.tolerance, 1.5 * draft.zenith_error) &&
                        azimuths < kMostAzimuths;
    const int finer = around ? 2 * azimuths - 1 : azimuths;
    if (draft.zenith_error > options_.tolerance || !around) {
      for (const ZenithPanel& half : draft.patch.panel().halves())
        next.push_back({SkyPatch(half, kPoints, finer), draft.refinements + 1, {}, 0.0, 0.0});
    } else {
      next.push_back({SkyPatch(draft.patch.panel(), kPoints, finer), draft.refinements + 1, {}, 0.0, 0.0});
    }
  }

  const Context& context_;
  const SolvedSky& sky_;
  double observer_km_;
  double sun_deg_;
  Shells apparent_;  ///< in which panels end at tangents
  double apparent_km_;
  double apparent_sun_deg_;
  const ContinuousSkyOptions& options_;
};

}  // namespace

ContinuousSky::ContinuousSky(const Context& context, std::shared_ptr<const SolvedSky> solved,
                             double altitude_km, const Direction& sun, double sun_distance_au,
                             const ContinuousSkyOptions& options)
    : solved_(std::move(solved)),
      sun_(sun),
      apparent_sun_deg_(apparent_sun(solved_->shells(), altitude_km, sun.zenith_deg).zenith_deg),
      horizon_zenith_deg_(skylut::horizon_zenith_deg(solved_->shells(), altitude_km)),
      scale_(1.0 / (sun_distance_au * sun_distance_au)) {
  require_within("altitude", altitude_km, domain::kObserver_km);
  require_within("sun zenith angle", sun.zenith_deg, domain::kSunZenith_deg);
  if (!(sun_distance_au > 0.0)) throw InputError("sun's distance {} au: must be > 0", sun_distance_au);
  if (!(options.tolerance >= 1e-5 && options.tolerance <= 0.1))
    throw InputError("sky tolerance {}: must lie within 1e-5 to 0.1", options.tolerance);
  patches_ = PatchBuilder(context, *solved_, altitude_km, sun.zenith_deg, options).build(error_);
}

ContinuousSky::~ContinuousSky() = default;

std::size_t ContinuousSky::patch_of(double zenith_deg) const {
  const auto found = std::lower_bound(
      patches_.begin(), patches_.end(), zenith_deg,
      [](const SkyPatch& patch, double angle) { return patch.panel().highest_zenith_deg() < angle; });
  return std::min(static_cast<std::size_t>(found - patches_.begin()), patches_.size() - 1);
}

std::size_t ContinuousSky::nodes() const {
  std::size_t sum = 0;
  for (const SkyPatch& patch : patches_) sum += static_cast<std::size_t>(patch.points() * patch.azimuths());
  return sum;
}

template <class Row, class Use>
void ContinuousSky::look(std::span<const Direction> directions, const Row& row_of, const Use& use) const {
  std::vector<float> row;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Direction& direction = directions[i];
    if (i == 0 || direction.zenith_deg != directions[i - 1].zenith_deg)
      row_of(patches_[patch_of(direction.zenith_deg)], direction.zenith_deg, row);
    use(i, row,
        patch_direction(direction.zenith_deg, direction.azimuth_deg - sun_.azimuth_deg, apparent_sun_deg_));
  }
}

void ContinuousSky::radiance(std::span<const Direction> directions, std::span<float> radiance) const {
  const std::size_t width = wavelengths().size();
  SKYLUT_CHECK_EQ(radiance.size(), directions.size() * width);
  std::vector<float> scratch;
  look(
      directions,
      [](const SkyPatch& patch, double zenith_deg, std::vector<float>& row) {
        row.resize(patch.row_size());
        patch.row(zenith_deg, row);
      },
      [&](std::size_t i, std::span<const float> row, const PatchDirection& direction) {
        const std::span<float> to = radiance.subspan(i * width, width);
        SkyPatch::radiance(solved_->factors(), row, direction, scratch, to);
        if (scale_ != 1.0)
          for (float& value : to) value *= static_cast<float>(scale_);
      });
}

void ContinuousSky::colour(std::span<const Direction> directions, std::span<Xyz> colour) const {
  SKYLUT_CHECK_EQ(colour.size(), directions.size());
  std::vector<float> scratch;
  look(
      directions,
      [](const SkyPatch& patch, double zenith_deg, std::vector<float>& row) {
        row.resize(patch.colour_row_size());
        patch.colour_row(zenith_deg, row);
      },
      [&](std::size_t i, std::span<const float> row, const PatchDirection& direction) {
        const Xyz found = SkyPatch::colour(*solved_, row, direction, scratch);
        colour[i] = {scale_ * found.X, scale_ * found.Y, scale_ * found.Z};
      });
}

}  // namespace skylut
