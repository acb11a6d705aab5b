#include "map_pictures.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "advice.hpp"
#include "output.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/export/frame_loop.hpp"
#include "skylut/export/frames_csv.hpp"
#include "skylut/sky/continuous_sky.hpp"
#include "skylut/sky/exact_sky.hpp"
#include "skylut/sky/limb_darkening.hpp"
#include "skylut/sky/solved_sky.hpp"
#include "skylut/sky/sun_disc.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

// The skies of a job: solved once for all frames.
class JobSkies {
 public:
  JobSkies(const Context& context, const PictureJob& job)
      : job_(job),
        solved_(std::make_shared<const SolvedSky>(
            context, job.scene, job.scene_options.transfer(),
            job.request.sun() == SunPicture::off ? SunShape::point : SunShape::disc)) {}

  double altitude_km() const { return job_.scene.altitudes_km.front(); }

  // What stands in the scene where there is but one frame.
  SkyScene scene_of(const SunFrame& frame) const {
    SkyScene scene = job_.scene;
    scene.suns = {frame.sun};
    scene.sun_distance_au = frame.sun_distance_au;
    if (frame.time) scene.time = format_time(*frame.time);
    return scene;
  }

  Provenance provenance(const Context& context, const SkyScene& scene, std::string command) const {
    Provenance provenance = job_.scene_options.provenance(context, scene, std::move(command));
    describe_into(solved_->report(), provenance);
    if (job_.request.sun() != SunPicture::off) provenance.add_source(context, LimbDarkening::file(context));
    if (!job_.times_file.empty()) provenance.add_source(context, job_.times_file);
    return provenance;
  }

  // Continuous, or with --exact line of sight by line of sight; says how well.
  std::unique_ptr<SkyLight> sky(const Context& context, const SunFrame& frame, Provenance& provenance) const {
    if (job_.scene_options.exact())
      return std::make_unique<ExactSky>(solved_, altitude_km(), frame.sun, frame.sun_distance_au);
    auto sky =
        std::make_unique<ContinuousSky>(context, solved_, altitude_km(), frame.sun, frame.sun_distance_au);
    provenance.describe("continuous_sky", {{"error", sky->error()}, {"nodes", sky->nodes()}});
    return sky;
  }

 private:
  const PictureJob& job_;
  std::shared_ptr<const SolvedSky> solved_;
};

void print_scene(const PictureJob& job) {
  fmt::print("{}\n", turbidity_text(job.scene.turbidities.front(), *job.scene.atmosphere));
}

}  // namespace

void write_picture(const Context& context, const PictureJob& job, const SunFrame& sun) {
  job.request.check(job.out);
  const JobSkies skies(context, job);
  const SkyScene scene = skies.scene_of(sun);
  PictureLabels labels{skies.altitude_km(), scene.turbidities.front(),
                       skies.provenance(context, scene, job.command)};
  const std::unique_ptr<SkyLight> sky = skies.sky(context, sun, labels.provenance);
  std::optional<SunDisc> disc;
  if (job.request.sun() != SunPicture::off) disc.emplace(context, scene);
  const std::string report =
      job.request.write(context, job.out, job.request.preview(), *sky, disc ? &*disc : nullptr, labels);
  fmt::print("altitude {} km, sun {:.6g}:{:.6g} deg, {} wavelengths\n", skies.altitude_km(),
             sun.sun.zenith_deg, sun.sun.azimuth_deg, scene.wavelengths.size());
  print_scene(job);
  fmt::print("{}", report);
}

void write_series(const Context& context, const PictureJob& job, const SunSeries& series, std::size_t only) {
  const std::size_t count = series.frames.size();
  if (only > count) throw InputError("--frame {}: the series has {} frames", only, count);
  const fs::path table = fs::path(job.out).replace_extension(".csv");
  const std::size_t first = only > 0 ? only - 1 : 0;
  job.request.check(frame_file(job.out, first + 1, count));
  if (only == 0) require_writable("-o", table);
  const JobSkies skies(context, job);
  std::vector<FrameRow> rows(only > 0 ? 1 : count);
  for_frames(context, rows.size(), job.request.small(), [&](const Context& of_frame, std::size_t row) {
    const SunFrame& frame = series.frames[first + row];
    const SkyScene scene = skies.scene_of(frame);
    const std::string command = fmt::format("{} --frame {}", job.command, frame.index);
    PictureLabels labels{skies.altitude_km(), scene.turbidities.front(),
                         skies.provenance(of_frame, scene, command)};
    const std::unique_ptr<SkyLight> sky = skies.sky(of_frame, frame, labels.provenance);
    const SunDisc disc(of_frame, scene);
    std::optional<fs::path> preview = job.request.preview();
    if (preview) preview = frame_file(*preview, frame.index, count);
    const fs::path out = frame_file(job.out, frame.index, count);
    job.request.write(of_frame, out, preview, *sky, &disc, labels);
    const fs::path file = picture_files(out, job.request.options()).front();
    rows[row] = frame_row(frame, *sky, disc, file.filename().string());
  });
  print_scene(job);
  if (series.too_dark > 0)
    fmt::print("{} suns are more than 99 deg from the zenith (night): they have no frame\n", series.too_dark);
  fmt::print("wrote {} frames, {} to {}\n", rows.size(), frame_file(job.out, first + 1, count).string(),
             frame_file(job.out, first + rows.size(), count).string());
  if (only > 0) return;
  SkyScene scene = job.scene;
  scene.suns.clear();  // the table's own rows
  write_text_atomically(table, frames_csv(rows, skies.provenance(context, scene, job.command)));
  fmt::print("wrote {}\n", table.string());
}

}  // namespace skylut::cli
