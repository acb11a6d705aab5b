#include "skylut/site/place.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/errors.hpp"
#include "skylut/site/sun.hpp"

namespace skylut {
namespace {

std::string refusal(const std::string& latitude, const std::string& longitude, double height_m = 0.0) {
  try {
    parse_place(latitude, longitude, height_m);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Place, DecimalAndDmsAreTheSame) {
  const double latitude_deg = 40.0 + 26.0 / 60.0 + 47.0 / 3600.0;
  const double longitude_deg = -(79.0 + 58.0 / 60.0 + 56.0 / 3600.0);
  for (const auto& [latitude, longitude] :
       {std::pair{"40d26'47\"N", "79d58'56\"W"}, {"40:26:47", "-79:58:56"}, {"N40°26′47″", "79°58′56″W"}}) {
    const Place place = parse_place(latitude, longitude, 300.0);
    EXPECT_NEAR(place.latitude_deg, latitude_deg, 1e-12) << latitude;
    EXPECT_NEAR(place.longitude_deg, longitude_deg, 1e-12) << longitude;
    EXPECT_EQ(place.height_m, 300.0);
  }
  EXPECT_EQ(parse_place("-33.9", "18.4E", 0.0), (Place{-33.9, 18.4, 0.0}));
}

// Wikipedia's and GPS receivers' ways to write the same two places; the sun there as astropy has it.
TEST(Place, BlanksPrimesAndLeadingHemisphere) {
  const Place paris = parse_place("48°51′24″N", "2°21′3″E", 0.0);
  for (const auto& [latitude, longitude] : {std::pair{"48° 51′ 24″ N", "2° 21′ 3″ E"},
                                            {"N 48° 51' 24\"", "E 2° 21' 3\""},
                                            {"48\u00A0°\u202F51\u2009′ 24 ″ N", "2d 21' 3'' E"},
                                            {" 48 51 24 N ", "E 2 21 3"},
                                            {"48:51:24 n", "+ 2:21:3"}})
    EXPECT_EQ(parse_place(latitude, longitude, 0.0), paris) << latitude << " " << longitude;
  const Direction sun = sun_direction(paris, parse_time("2024-06-21T09:00Z"));
  EXPECT_NEAR(sun.zenith_deg, 42.25870, 1e-3);
  EXPECT_NEAR(sun.azimuth_deg, 111.14814, 1e-3);

  const Place scotland = parse_place("N 59°12'7.7\"", "W 02°15'39.6\"", 0.0);
  EXPECT_NEAR(scotland.latitude_deg, 59.0 + 12.0 / 60.0 + 7.7 / 3600.0, 1e-12);
  EXPECT_NEAR(scotland.longitude_deg, -(2.0 + 15.0 / 60.0 + 39.6 / 3600.0), 1e-12);
  const Direction there = sun_direction(scotland, parse_time("2024-06-21T09:00Z"));
  EXPECT_NEAR(there.zenith_deg, 48.88438, 1e-3);
  EXPECT_NEAR(there.azimuth_deg, 115.67470, 1e-3);
}

// A blank beside a decimal point joins nothing: half a degree or half a minute would be a guess.
TEST(Place, BlanksThatCouldMeanTwoThings) {
  for (const char* latitude : {"48 .5", "48. 5", "4 8 5 1", "48 ° 51 ° 3", ""})
    EXPECT_THROW(parse_place(latitude, "0", 0.0), InputError) << latitude;
}

TEST(Place, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("ninety", "0"),
            "latitude 'ninety': is no angle; expected degrees or DMS, for example 40.5 or 40d30'N");
  EXPECT_EQ(
      refusal("10E", "0"),
      "latitude '10E': has the hemisphere of the other coordinate; expected for example 40.5 or 40d30'N");
  EXPECT_EQ(refusal("91", "0"), "latitude '91': must lie within -90 to 90 degrees");
  EXPECT_EQ(refusal("nan", "0"), "latitude 'nan': must lie within -90 to 90 degrees");
  EXPECT_EQ(refusal("0", "181"), "longitude '181': must lie within -180 to 180 degrees");
  EXPECT_EQ(refusal("0", "0", 1e5), "height 100000 m: must lie within -500 to 9000 m");
  EXPECT_THROW(normal_gravity_m_s2({99.0, 0.0, 0.0}), InputError);
}

// WGS84 defines γ_equator = 9.7803253359 and γ_pole = 9.8321849378 m/s² (NIMA TR8350.2, table 3.4);
// Somigliana's closed formula gives the rest of the ellipsoid.
TEST(Place, NormalGravityOfTheEllipsoid) {
  EXPECT_NEAR(normal_gravity_m_s2({0.0, 0.0, 0.0}), 9.7803253359, 1e-9);
  EXPECT_NEAR(normal_gravity_m_s2({90.0, 0.0, 0.0}), 9.8321849378, 1e-9);
  for (double latitude_deg : {-60.0, 30.0, 45.0}) {
    const double sine_squared = std::pow(std::sin(latitude_deg * M_PI / 180.0), 2);
    const double somigliana = 9.7803253359 * (1.0 + 0.00193185265241 * sine_squared) /
                              std::sqrt(1.0 - 0.00669437999014 * sine_squared);
    EXPECT_NEAR(normal_gravity_m_s2({latitude_deg, 10.0, 0.0}), somigliana, 1e-9);
  }
  // Free-air gradient at 45°: -2 γ/a (1 + f + m - 2 f sin²φ) = -3.0857e-6 1/s².
  EXPECT_NEAR((normal_gravity_m_s2({45.0, 0.0, 100.0}) - normal_gravity_m_s2({45.0, 0.0, 0.0})) / 100.0,
              -3.0857e-6, 2e-10);
}

// M = a (1-e²)/W³, N = a/W, W² = 1 - e² sin²φ: √(M N) = a √(1-e²) / W², b at the equator, a²/b at the poles.
TEST(Place, RadiusOfCurvature) {
  constexpr double kA_km = 6378.137;
  constexpr double kB_km = 6356.752314245;
  EXPECT_NEAR(radius_of_curvature_km({0.0, 0.0, 0.0}), kB_km, 1e-6);
  EXPECT_NEAR(radius_of_curvature_km({-90.0, 0.0, 0.0}), kA_km * kA_km / kB_km, 1e-6);
  EXPECT_NEAR(radius_of_curvature_km({45.0, 0.0, 0.0}), kB_km / (1.0 - 0.00669437999014 * 0.5), 1e-6);
}

}  // namespace
}  // namespace skylut
