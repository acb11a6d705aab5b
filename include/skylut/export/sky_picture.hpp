#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/colour/rgb_space.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/core/provenance.hpp"
#include "skylut/export/projection.hpp"
#include "skylut/export/sky_channels.hpp"
#include "skylut/sky/sky_light.hpp"
#include "skylut/sky/sun_disc.hpp"

namespace skylut {

struct Context;

/// Where the sun's disc is drawn.
enum class SunPicture {
  off,   ///< nowhere: diffuse light alone
  disc,  ///< in the sky
  file   ///< in a picture of its own beside that of the sky, dark but for the disc
};

/// What pictures of a sky to write.
struct PictureOptions {
  ProjectionChoice projection;
  std::vector<SkyChannels> channels{SkyChannels::rgb};  ///< each once
  std::string rgb_space = "rec709";                     ///< of rgb_spaces()
  WhiteAdaptation adaptation = WhiteAdaptation::bradford;
  SunPicture sun = SunPicture::off;
};

/// What the files say about the sky beside what the sky knows.
struct PictureLabels {
  double altitude_km = 0.0;
  Turbidity turbidity;
  Provenance provenance;
};

/// What was written. The numbers are those of the sky's pictures; a sun of its own only has files.
struct PictureSummary {
  std::vector<std::filesystem::path> files;
  std::size_t pixels = 0;      ///< with a direction, of all faces
  std::size_t directions = 0;  ///< looked in for them: more where a pixel is a mean of several
  double darkest_cd_m2 = std::numeric_limits<double>::infinity();  ///< of the pixels with a direction
  double brightest_cd_m2 = 0.0;
  std::size_t outside_rgb = 0;  ///< pixels with a negative R, G or B

  /// Counts another's pixels, too.
  void add(const PictureSummary& other);
};

/// The files of a picture that is to be called `path`: that name itself if there is one kind of channels and
/// no faces; else sky_rgb.exr, sky_spectral.exr; sky_px.exr; sky_rgb_px.exr. A sun of its own goes to
/// sky_sun.exr, sky_rgb_sun.exr, sky_rgb_sun_px.exr. By face, the sky before the sun.
std::vector<std::filesystem::path> picture_files(const std::filesystem::path& path,
                                                 const PictureOptions& options);

/// Writes the pictures as OpenEXR files: 32-bit floats, ZIP compression, attributes that say altitude,
/// turbidity, sun, units, orientation, version and how the picture was made (docs/user-guide.md lists them).
/// Pixels are means over their solid angles (PictureSampler). Negative R, G or B are kept.
///
/// Rows are computed in strips, in parallel, and written while the next strip is at work: memory grows with a
/// picture's width, not with its height. The bytes do not depend on the number of threads. The files take
/// their names together when all are complete; a failure, a cancelled context or a signal (with
/// remove_unfinished_files()) leaves none.
/// @param disc  of options.sun, unless that is off; of the sky's wavelengths
/// @param also  other files of the same command that take their names with them
/// @throws InputError  for an unknown projection or RGB space, a size out of range
/// @throws WorkError   if a file cannot be written
/// @throws Cancelled   if context.cancel was asked
PictureSummary write_pictures(const Context& context, const std::filesystem::path& path, const SkyLight& sky,
                              const PictureOptions& options, const PictureLabels& labels,
                              const SunDisc* disc = nullptr, std::span<const FileText> also = {});

}  // namespace skylut
