#include "skylut/export/sky_picture.hpp"

#include <algorithm>
#include <deque>

#include "export/exr_file.hpp"
#include "export/exr_header.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/export/picture_sampler.hpp"

namespace skylut {

namespace fs = std::filesystem;

namespace {

constexpr int kBlockRows = 16;         // of OpenEXR's ZIP compression
constexpr int kStripPixels = 1 << 15;  // at least, so that threads have enough rows of a narrow picture

const char* ending_of(SkyChannels channels) {
  switch (channels) {
    case SkyChannels::rgb:
      return "_rgb";
    case SkyChannels::xyz:
      return "_xyz";
    case SkyChannels::luminance:
      return "_luminance";
    case SkyChannels::spectral:
      return "_spectral";
  }
  return "";
}

// Nothing but what is added to it; horizon and sun are where no pixel need be cut for them.
class Darkness final : public SkyLight {
 public:
  explicit Darkness(const WavelengthGrid& wavelengths) : wavelengths_(wavelengths) {}
  const WavelengthGrid& wavelengths() const override { return wavelengths_; }
  Direction sun() const override { return {180.0, 0.0}; }
  double horizon_zenith_deg() const override { return -180.0; }
  void radiance(std::span<const Direction>, std::span<float> radiance) const override {
    std::fill(radiance.begin(), radiance.end(), 0.0f);
  }
  void colour(std::span<const Direction>, std::span<Xyz> colour) const override {
    std::fill(colour.begin(), colour.end(), Xyz{});
  }

 private:
  WavelengthGrid wavelengths_;
};

// The pictures of one projection: the sky, and where it has one of its own the sun.
std::vector<bool> suns_alone(const PictureOptions& options) {
  return options.sun == SunPicture::file ? std::vector{false, true} : std::vector{false};
}

std::string sun_disc_text(const PictureOptions& options, bool sun_alone) {
  if (sun_alone) return "alone: no sky";
  switch (options.sun) {
    case SunPicture::off:
      return "not included";
    case SunPicture::disc:
      return "included: its light is in the pixels that hold it";
    case SunPicture::file:
      return "not included: in a picture of its own";
  }
  return "";
}

fs::path file_of(const fs::path& path, const PictureOptions& options, SkyChannels channels,
                 const Projection& projection, bool sun_alone) {
  std::string name = path.stem().string();
  if (options.channels.size() > 1) name += ending_of(channels);
  if (sun_alone) name += "_sun";
  if (!projection.face().empty()) name += "_" + projection.face();
  fs::path file = path;
  return file.replace_filename(name + path.extension().string());
}

bool wants_spectra(const PictureOptions& options) {
  const auto& kinds = options.channels;
  return std::find(kinds.begin(), kinds.end(), SkyChannels::spectral) != kinds.end();
}

// Some rows of a picture.
struct Strip {
  int first_row = 0;
  int rows = 0;
  std::vector<Xyz> colour;             // [row][column]
  std::vector<float> radiance;         // [row][column][wavelength], or empty
  std::vector<PictureSummary> of_row;  // without files
};

// One picture on its way: its files, and the strip that is being computed while the one before is written.
class PictureWriter {
 public:
  PictureWriter(const Context& context, const SkyLight& sky, const SunDisc* disc,
                const Projection& projection, const PictureOptions& options, PictureSummary& summary)
      : context_(context),
        sampler_(sky, projection, disc),
        projection_(projection),
        options_(options),
        rgb_(rgb_space(options.rgb_space), options.adaptation),
        wavelengths_(wants_spectra(options) ? sky.wavelengths().size() : 0),
        summary_(summary) {}

  /// @param files  one per kind of channels, in their order
  /// @param done   rows of the faces before; @param all  rows of all faces
  void write(std::deque<ExrFile>& files, std::size_t first_file, std::size_t done, std::size_t all) {
    const int height = projection_.height();
    const int blocks = std::max(1, kStripPixels / (kBlockRows * projection_.width()));
    Strip written;
    for (int row = 0; row < height || written.rows > 0;) {
      Strip strip = strip_at(row, std::min(kBlockRows * blocks, height - row));
      parallel_for(static_cast<std::size_t>(strip.rows) + 1, context_.threads, [&](std::size_t task) {
        if (context_.cancel.stop_requested()) throw Cancelled();
        if (task > 0) return sample(strip, task - 1);
        for (std::size_t i = 0; i < options_.channels.size() && written.rows > 0; ++i)
          write_strip(files[first_file + i], written, options_.channels[i]);
      });
      for (const PictureSummary& row_summary : strip.of_row) summary_.add(row_summary);
      row += strip.rows;
      written = std::move(strip);
      if (context_.progress) context_.progress("picture", done + static_cast<std::size_t>(row), all);
    }
  }

 private:
  Strip strip_at(int first_row, int rows) const {
    Strip strip{first_row, rows, {}, {}, {}};
    const auto count = static_cast<std::size_t>(rows);
    strip.colour.resize(count * width());
    strip.radiance.resize(count * width() * wavelengths_);
    strip.of_row.resize(count);
    return strip;
  }

  void sample(Strip& strip, std::size_t row) const {
    const std::span<Xyz> colour(strip.colour);
    const std::span<float> radiance(strip.radiance);
    const std::size_t values = width() * wavelengths_;
    const int picture_row = strip.first_row + static_cast<int>(row);
    const auto row_colour = colour.subspan(row * width(), width());
    PictureSummary& summary = strip.of_row[row];
    summary.directions = sampler_.sample_row(picture_row, row_colour, radiance.subspan(row * values, values));
    for (int column = 0; column < projection_.width(); ++column)
      if (projection_.direction(column, picture_row))
        summary.add(pixel_summary(row_colour[static_cast<std::size_t>(column)]));
  }

  PictureSummary pixel_summary(const Xyz& colour) const {
    const LinearRgb rgb = rgb_.to_rgb(colour);
    // Rounding of a colour on the edge of the space is not outside.
    const bool outside = std::min({rgb.r, rgb.g, rgb.b}) < -1e-7 * colour.Y;
    return {{}, 1, 0, colour.Y, colour.Y, outside ? 1u : 0u};
  }

  void write_strip(ExrFile& file, const Strip& strip, SkyChannels channels) const {
    const std::vector<float> colours = colours_of(strip, channels);
    if (channels == SkyChannels::spectral)
      file.write_rows(strip.rows, {colours, strip.radiance});
    else
      file.write_rows(strip.rows, {colours});
  }

  // As the file holds them: [row][column][channel].
  std::vector<float> colours_of(const Strip& strip, SkyChannels channels) const {
    std::vector<float> values;
    values.reserve(3 * strip.colour.size());
    const auto add = [&values](double value) { values.push_back(static_cast<float>(value)); };
    for (const Xyz& colour : strip.colour) {
      if (channels == SkyChannels::luminance) {
        add(colour.Y);
        continue;
      }
      const LinearRgb rgb = rgb_.to_rgb(colour);
      const bool xyz = channels == SkyChannels::xyz;
      add(xyz ? colour.X : rgb.r);
      add(xyz ? colour.Y : rgb.g);
      add(xyz ? colour.Z : rgb.b);
    }
    return values;
  }

  std::size_t width() const { return static_cast<std::size_t>(projection_.width()); }

  const Context& context_;
  PictureSampler sampler_;
  const Projection& projection_;
  const PictureOptions& options_;
  RgbConversion rgb_;
  std::size_t wavelengths_;
  PictureSummary& summary_;
};

}  // namespace

void PictureSummary::add(const PictureSummary& other) {
  files.insert(files.end(), other.files.begin(), other.files.end());
  pixels += other.pixels;
  directions += other.directions;
  darkest_cd_m2 = std::min(darkest_cd_m2, other.darkest_cd_m2);
  brightest_cd_m2 = std::max(brightest_cd_m2, other.brightest_cd_m2);
  outside_rgb += other.outside_rgb;
}

std::vector<fs::path> picture_files(const fs::path& path, const PictureOptions& options) {
  std::vector<fs::path> files;
  for (const auto& projection : make_projections(options.projection))
    for (const bool sun_alone : suns_alone(options))
      for (const SkyChannels channels : options.channels)
        files.push_back(file_of(path, options, channels, *projection, sun_alone));
  return files;
}

PictureSummary write_pictures(const Context& context, const fs::path& path, const SkyLight& sky,
                              const PictureOptions& options, const PictureLabels& labels, const SunDisc* disc,
                              std::span<const FileText> also) {
  SKYLUT_CHECK(disc != nullptr || options.sun == SunPicture::off);
  const Darkness darkness(sky.wavelengths());
  const auto projections = make_projections(options.projection);
  PictureSummary summary;
  summary.files = picture_files(path, options);

  std::size_t rows = 0;
  for (const auto& projection : projections)
    rows += static_cast<std::size_t>(projection->height()) * suns_alone(options).size();
  std::deque<ExrFile> files;
  std::size_t done = 0;
  PictureSummary of_suns;  // which says nothing of the sky
  for (const auto& projection : projections)
    for (const bool sun_alone : suns_alone(options)) {
      const std::size_t first_file = files.size();
      for (const SkyChannels channels : options.channels)
        files.emplace_back(
            summary.files[files.size()],
            exr_header(channels, *projection, sky, options, labels, sun_disc_text(options, sun_alone)),
            channel_names(channels, sky.wavelengths()));
      const SkyLight& light = sun_alone ? darkness : sky;
      const bool with_disc = sun_alone || options.sun == SunPicture::disc;
      PictureWriter(context, light, with_disc ? disc : nullptr, *projection, options,
                    sun_alone ? of_suns : summary)
          .write(files, first_file, done, rows);
      done += static_cast<std::size_t>(projection->height());
    }

  std::deque<AtomicFile> others;
  std::vector<AtomicFile*> together;
  for (ExrFile& file : files) {
    file.close();
    together.push_back(&file.file());
  }
  for (const auto& [other, text] : also) {
    others.emplace_back(other).write(text);
    together.push_back(&others.back());
  }
  AtomicFile::publish(together);
  return summary;
}

}  // namespace skylut
