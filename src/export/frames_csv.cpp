#include "skylut/export/frames_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/sky/sky_irradiance.hpp"

namespace skylut {

std::filesystem::path frame_file(const std::filesystem::path& name, std::size_t index, std::size_t count) {
  SKYLUT_CHECK(index >= 1 && index <= count);
  constexpr std::size_t kFewestDigits = 4;
  const std::size_t digits = std::max(kFewestDigits, fmt::formatted_size("{}", count));
  std::filesystem::path numbered = name;
  numbered.replace_filename(
      fmt::format("{}_{:0{}}{}", name.stem().string(), index, digits, name.extension().string()));
  return numbered;
}

FrameRow frame_row(const SunFrame& frame, const SkyLight& sky, const SunDisc& disc, std::string file) {
  const double direct_lux = disc.illuminance().Y;
  const double cosine = std::max(0.0, std::cos(frame.sun.zenith_deg * kRadiansPerDegree));
  return {frame, direct_lux, cosine * direct_lux, diffuse_horizontal_illuminance(sky).Y, std::move(file)};
}

std::string frames_csv(std::span<const FrameRow> rows, const Provenance& provenance) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "index,time,sun_zenith_deg,sun_azimuth_deg,sun_distance_au,direct_normal_lux,"
                 "direct_horizontal_lux,diffuse_horizontal_lux,file\n{}",
                 provenance.comment_lines());
  for (const FrameRow& row : rows) {
    if (row.file.find_first_of(",\"\r\n") != std::string::npos)
      throw InputError("file name '{}': must have no comma, quote or line break in a CSV of frames",
                       row.file);
    const SunFrame& frame = row.frame;
    fmt::format_to(out, "{},{},{},{},{},{},{},{},{}\n", frame.index,
                   frame.time ? format_time(*frame.time) : std::string(), frame.sun.zenith_deg,
                   frame.sun.azimuth_deg, frame.sun_distance_au, row.direct_normal_lux,
                   row.direct_horizontal_lux, row.diffuse_horizontal_lux, row.file);
  }
  return fmt::to_string(text);
}

}  // namespace skylut
