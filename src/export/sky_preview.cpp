#include "skylut/export/sky_preview.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "export/png_writer.hpp"
#include "export/tone.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/core/version.hpp"
#include "skylut/export/picture_sampler.hpp"

namespace skylut {

namespace {

constexpr double kVisible = 1.0 / 255.0;  // change of a channel that counts

// The light of a small picture, [row][column].
std::vector<Xyz> light_of(const Context& context, const SkyLight& sky, const SunDisc* disc,
                          const Projection& projection) {
  const auto width = static_cast<std::size_t>(projection.width());
  const auto height = static_cast<std::size_t>(projection.height());
  std::vector<Xyz> light(width * height);
  const PictureSampler sampler(sky, projection, disc);
  parallel_for(height, context.threads, [&](std::size_t row) {
    if (context.cancel.stop_requested()) throw Cancelled();
    sampler.sample_row(static_cast<int>(row), std::span(light).subspan(row * width, width), {});
  });
  return light;
}

// exp of the mean of ln Y over the solid angle of the pixels that have light (Reinhard et al. 2002 eq. 1).
double typical_luminance(const Projection& projection, const std::vector<Xyz>& light) {
  double sum = 0.0;
  double all = 0.0;
  std::size_t i = 0;
  for (int row = 0; row < projection.height(); ++row)
    for (int column = 0; column < projection.width(); ++column, ++i) {
      if (!(light[i].Y > 0.0)) continue;
      const double solid_angle = projection.solid_angle_sr(column, row);
      sum += solid_angle * std::log(light[i].Y);
      all += solid_angle;
    }
  return all > 0.0 ? std::exp(sum / all) : 1.0;
}

}  // namespace

Preview make_preview(const Context& context, const SkyLight& sky, const PreviewOptions& options,
                     const Provenance& provenance, const SunDisc* disc) {
  if (options.middle_grey_cd_m2)
    require_within("middle grey", *options.middle_grey_cd_m2, domain::kMiddleGrey_cd_m2);
  ProjectionChoice choice = options.projection;
  if (choice.name == "cube") choice.name = "cube-cross";
  const auto projections = make_projections(choice);
  const Projection& projection = *projections.front();
  const std::vector<Xyz> light = light_of(context, sky, disc, projection);

  Preview preview;
  preview.width = projection.width();
  preview.height = projection.height();
  preview.middle_grey_cd_m2 = options.middle_grey_cd_m2.value_or(typical_luminance(projection, light));
  for (const Xyz& colour : light) preview.white_cd_m2 = std::max(preview.white_cd_m2, colour.Y);
  const ToneCurve curve(preview.middle_grey_cd_m2, preview.white_cd_m2);
  std::vector<std::uint8_t> pixels;
  pixels.reserve(3 * light.size());
  for (const Xyz& colour : light) {
    const DisplayedColour shown = displayed(colour, curve);
    if (shown.change > kVisible) ++preview.desaturated;
    for (const double channel : {shown.rgb.r, shown.rgb.g, shown.rgb.b})
      pixels.push_back(static_cast<std::uint8_t>(std::lround(255.0 * srgb_encoded(channel))));
  }
  preview.description = fmt::format(
      "exposure: {:.4g} cd/m2 is middle grey (0.18); tone curve: Reinhard et al. 2002 eq. 4 on the "
      "luminance, white "
      "at {:.4g} cd/m2; {} of {} pixels mixed with white of the same luminance to fit into sRGB",
      preview.middle_grey_cd_m2, preview.white_cd_m2, preview.desaturated, light.size());
  preview.png = png_of(preview.width, preview.height, pixels,
                       {{"Software", std::string("skylut ") + kVersion},
                        {"Source", provenance.command()},
                        {"Description", projection.name() + ": " + projection.orientation()},
                        {"Comment", preview.description}});
  return preview;
}

}  // namespace skylut
