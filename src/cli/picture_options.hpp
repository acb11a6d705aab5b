#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "options/options.hpp"
#include "skylut/export/sky_picture.hpp"

namespace skylut {
struct Context;
}

namespace skylut::cli {

/// What pictures of a sky are asked for, and their writing.
class PictureRequest {
 public:
  static constexpr const char* kGroup = "Picture (.exr)";

  /// Adds --projection, --size, --sky, --sun, --channels, --rgb-space, --rgb-adaptation, --preview,
  /// --preview-size and --preview-grey-cd-m2 under kGroup.
  void add_to(OptionSet& options);
  /// The same without --sun: pictures of diffuse light alone.
  void add_without_sun_to(OptionSet& options);

  /// Gives what was not given its default, so that it is recorded.
  void settle();

  /// @throws InputError  naming the option: a hemisphere of a cube, preview options without --preview, a file
  ///                     that cannot be written
  void check(const std::filesystem::path& out) const;

  PictureOptions options() const;

  const std::string& projection() const { return *projection_; }
  SunPicture sun() const { return *sun_; }
  /// Whether its frames have too little work for all threads each.
  bool small() const { return *size_ <= 1024; }

  /// Writes the pictures and the preview, which take their names together.
  /// @param preview  its name here
  /// @return         what they are, for the screen
  std::string write(const Context& context, const std::filesystem::path& out,
                    const std::optional<std::filesystem::path>& preview, const SkyLight& sky,
                    const SunDisc* disc, const PictureLabels& labels) const;
  const std::optional<std::filesystem::path>& preview() const { return preview_; }

 private:
  void add_shape_to(OptionSet& options);
  void add_light_to(OptionSet& options);

  std::optional<std::string> projection_;
  std::optional<std::int64_t> size_;
  std::optional<SkyPart> part_;
  std::optional<SunPicture> sun_;
  std::optional<std::vector<SkyChannels>> channels_;
  std::optional<std::string> rgb_space_;
  std::optional<WhiteAdaptation> adaptation_;
  std::optional<std::filesystem::path> preview_;
  std::optional<std::int64_t> preview_size_;
  std::optional<double> preview_grey_cd_m2_;
};

/// Options of the other kind of file were not meant for this one.
/// @param out     .exr takes the options of PictureRequest::kGroup, .csv does not
/// @param of_csv  options that .exr does not take
/// @throws InputError  naming the first that was given nevertheless
void refuse_options_of_other_files(const OptionSet& given, const std::filesystem::path& out,
                                   const std::vector<std::string>& of_csv);

}  // namespace skylut::cli
