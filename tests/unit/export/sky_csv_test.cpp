#include "skylut/export/sky_csv.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <sstream>

#include "test_map.hpp"

namespace skylut {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(SkyCsv, HeaderColumnsAndRows) {
  const std::vector<std::string> lines =
      lines_of(sky_csv(made_up_map({{0.0, 0.0}, {45.0, 270.0}}), Provenance("skylut map")));
  ASSERT_EQ(lines.size(), 1u + 9u + 2u);
  for (std::size_t i = 1; i < 10; ++i) EXPECT_EQ(lines[i].substr(0, 2), "# ");
  EXPECT_EQ(lines[2], "# altitude_km=6");
  EXPECT_EQ(lines[3], "# turbidity=0.25");
  EXPECT_EQ(lines[4], "# turbidity_kind=aod500");
  EXPECT_EQ(lines[5], "# sun_zenith_deg=45");
  EXPECT_EQ(lines[6], "# sun_azimuth_deg=90");
  EXPECT_EQ(lines[8], "# command: skylut map");
  EXPECT_EQ(lines[9].substr(0, 15), "# provenance: {");
  EXPECT_EQ(lines[0],
            "zenith_deg,azimuth_deg,gamma_deg,Y_cd_m2,x,y,L_400,L_450,L_500,L_550,L_600,L_650,L_700");
}

// Every number reads back to the same bits; the sun is 45° from the zenith and 90° from its antipode's side.
TEST(SkyCsv, NumbersReadBackExactly) {
  const SkyMap map = made_up_map({{0.0, 0.0}, {45.0, 270.0}});
  const std::vector<std::string> lines = lines_of(sky_csv(map, Provenance("skylut map")));
  std::istringstream row(lines.back());
  std::vector<std::string> fields;
  for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
  ASSERT_EQ(fields.size(), 13u);
  EXPECT_EQ(std::strtod(fields[0].c_str(), nullptr), 45.0);
  EXPECT_EQ(std::strtod(fields[1].c_str(), nullptr), 270.0);
  EXPECT_NEAR(std::strtod(fields[2].c_str(), nullptr), 90.0, 1e-12);
  EXPECT_EQ(std::strtod(fields[3].c_str(), nullptr), map.colour[1].Y);
  EXPECT_EQ(std::strtod(fields[5].c_str(), nullptr), map.colour[1].y);
  EXPECT_EQ(std::strtof(fields[12].c_str(), nullptr), map.spectrum(1)[6]);
}

TEST(SkyCsv, AMapWithoutRadiancesHasNoColumnsOfThem) {
  SkyMap map = made_up_map({{12.5, 0.5}});
  map.radiance.clear();
  const std::string text = sky_csv(map, Provenance("skylut eval"));
  EXPECT_EQ(text.substr(0, text.find('\n')), "zenith_deg,azimuth_deg,gamma_deg,Y_cd_m2,x,y");
  EXPECT_EQ(text.substr(text.rfind('\n', text.size() - 2) + 1, 9), "12.5,0.5,");
}

TEST(SkyCsv, DoesNotDependOnTheLocale) {
  const SkyMap map = made_up_map({{12.5, 0.5}});
  const std::string before = sky_csv(map, Provenance("skylut map"));
  const std::string old = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "no locale with a decimal comma";
  const std::string after = sky_csv(map, Provenance("skylut map"));
  std::setlocale(LC_ALL, old.c_str());
  EXPECT_EQ(before, after);
}

}  // namespace
}  // namespace skylut
