#include "skylut/report/picture_report.hpp"

#include <fmt/format.h>

namespace skylut {

std::string picture_report(const PictureSummary& summary, const std::string& rgb_space) {
  const double per_pixel = static_cast<double>(summary.directions) / static_cast<double>(summary.pixels);
  std::string text = fmt::format("{} pixels, {:.2f} directions each\nluminance {:.5g} to {:.5g} cd/m2\n",
                                 summary.pixels, per_pixel, summary.darkest_cd_m2, summary.brightest_cd_m2);
  if (summary.outside_rgb > 0)
    text += fmt::format("{} pixels have a colour outside {}: a negative R, G or B, kept as it is\n",
                        summary.outside_rgb, rgb_space);
  for (const std::filesystem::path& file : summary.files) text += fmt::format("wrote {}\n", file.string());
  return text;
}

}  // namespace skylut
