#include "picture_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "options/choice_list.hpp"
#include "options/file_kinds.hpp"
#include "options/number_kinds.hpp"
#include "output.hpp"
#include "skylut/export/sky_preview.hpp"
#include "skylut/report/picture_report.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

Kind<std::string> rgb_space_kind() {
  std::vector<std::string> list;
  for (const RgbSpace& space : rgb_spaces()) list.push_back(space.name);
  return choice(list);
}

Kind<SkyPart> part_kind() {
  return choice<SkyPart>({{"full", SkyPart::sphere}, {"half", SkyPart::hemisphere}});
}

Kind<SunPicture> sun_kind() {
  return choice<SunPicture>(
      {{"off", SunPicture::off}, {"disc", SunPicture::disc}, {"file", SunPicture::file}});
}

Kind<SkyChannels> channels_kind() {
  return choice<SkyChannels>({{"rgb", SkyChannels::rgb},
                              {"xyz", SkyChannels::xyz},
                              {"luminance", SkyChannels::luminance},
                              {"spectral", SkyChannels::spectral}});
}

Kind<WhiteAdaptation> adaptation_kind() {
  return choice<WhiteAdaptation>({{"bradford", WhiteAdaptation::bradford}, {"none", WhiteAdaptation::none}});
}

}  // namespace

void PictureRequest::add_to(OptionSet& set) {
  add_shape_to(set);
  set.add("--sun", sun_, sun_kind(),
          "its disc: off (default), disc: in the sky, or file: alone in sky_sun.exr beside it");
  add_light_to(set);
}

void PictureRequest::add_without_sun_to(OptionSet& set) {
  add_shape_to(set);
  add_light_to(set);
}

void PictureRequest::add_shape_to(OptionSet& set) {
  set.group(kGroup);
  set.add("--projection", projection_, choice(projection_names()),
          "latlong (default), fisheye, fisheye-equisolid, cube, cube-cross or octahedral");
  set.add("--size", size_, whole_number(domain::kPictureSize_pixels),
          "height in pixels, default 256; of a cube, of one face");
  set.add("--sky", part_, part_kind(), "full or half: above the horizon (default of the fisheyes)");
}

void PictureRequest::add_light_to(OptionSet& set) {
  set.add("--channels", channels_, choice_list(channels_kind()),
          "rgb (default), xyz, luminance, spectral or several: rgb,spectral");
  set.add("--rgb-space", rgb_space_, rgb_space_kind(), "rec709 (default), rec2020, p3, acescg or aces2065-1");
  set.add("--rgb-adaptation", adaptation_, adaptation_kind(),
          "of D65 to another white: bradford (default) or none");
  set.add("--preview", preview_, file_named({".png"}), "also a small sRGB picture to look at").recorded =
      false;
  set.add("--preview-size", preview_size_, whole_number(domain::kPictureSize_pixels),
          "its height in pixels, default 256");
  set.add("--preview-grey-cd-m2", preview_grey_cd_m2_, number(domain::kMiddleGrey_cd_m2),
          "luminance shown as middle grey, default that of the sky");
}

void PictureRequest::settle() {
  projection_ = projection_.value_or("latlong");
  size_ = size_.value_or(256);
  part_ = part_.value_or(default_part(*projection_));
  sun_ = sun_.value_or(SunPicture::off);
  channels_ = channels_.value_or(std::vector{SkyChannels::rgb});
  rgb_space_ = rgb_space_.value_or("rec709");
  adaptation_ = adaptation_.value_or(WhiteAdaptation::bradford);
  if (preview_) preview_size_ = preview_size_.value_or(256);
}

void PictureRequest::check(const fs::path& out) const {
  if (part_ == SkyPart::hemisphere && !shows_hemispheres(*projection_))
    throw InputError("--sky half: is for latlong, fisheye and fisheye-equisolid, must not be given with {}",
                     *projection_);
  if (!preview_ && preview_size_) throw InputError("--preview-size: needs --preview");
  if (!preview_ && preview_grey_cd_m2_) throw InputError("--preview-grey-cd-m2: needs --preview");
  for (const fs::path& file : picture_files(out, options())) require_writable("-o", file);
}

PictureOptions PictureRequest::options() const {
  return {{*projection_, static_cast<int>(*size_), part_}, *channels_, *rgb_space_, *adaptation_, *sun_};
}

std::string PictureRequest::write(const Context& context, const fs::path& out,
                                  const std::optional<fs::path>& preview_file, const SkyLight& sky,
                                  const SunDisc* disc, const PictureLabels& labels) const {
  Preview preview;
  std::vector<FileText> also;
  if (preview_file) {
    const ProjectionChoice choice{*projection_, static_cast<int>(*preview_size_), part_};
    preview = make_preview(context, sky, {choice, preview_grey_cd_m2_}, labels.provenance,
                           sun() == SunPicture::disc ? disc : nullptr);
    also.push_back({*preview_file, preview.png});
  }
  const PictureSummary summary = write_pictures(context, out, sky, options(), labels, disc, also);
  std::string report = picture_report(summary, *rgb_space_);
  if (preview_file) report += fmt::format("wrote {}: {}\n", preview_file->string(), preview.description);
  return report;
}

void refuse_options_of_other_files(const OptionSet& given, const fs::path& out,
                                   const std::vector<std::string>& of_csv) {
  const bool picture = ending_of(out) == ".exr";
  for (const Option& option : given.all()) {
    if (!option.given) continue;
    const bool is_of_csv = std::find(of_csv.begin(), of_csv.end(), option.name) != of_csv.end();
    if (picture ? is_of_csv : option.group == PictureRequest::kGroup)
      throw InputError("{}: is for {} files, must not be given with {}", option.name,
                       picture ? ".csv" : ".exr", out.string());
  }
}

}  // namespace skylut::cli
