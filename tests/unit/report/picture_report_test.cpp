#include "skylut/report/picture_report.hpp"

#include <gtest/gtest.h>

namespace skylut {
namespace {

TEST(PictureReport, SaysWhatWasWritten) {
  PictureSummary summary;
  summary.files = {"sky_px.exr", "sky_nx.exr"};
  summary.pixels = 200;
  summary.directions = 250;
  summary.darkest_cd_m2 = 12.5;
  summary.brightest_cd_m2 = 3456.78;
  EXPECT_EQ(picture_report(summary, "p3"),
            "200 pixels, 1.25 directions each\nluminance 12.5 to 3456.8 cd/m2\nwrote sky_px.exr\nwrote "
            "sky_nx.exr\n");
  summary.outside_rgb = 7;
  EXPECT_NE(picture_report(summary, "p3").find("7 pixels have a colour outside p3"), std::string::npos);
}

}  // namespace
}  // namespace skylut
