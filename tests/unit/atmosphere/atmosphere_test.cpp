#include "skylut/atmosphere/atmosphere.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "skylut/atmosphere/gas_cross_sections.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/scattering/rayleigh.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double depth_of(const std::vector<ConstituentDepth>& depths, const std::string& name) {
  for (const ConstituentDepth& depth : depths)
    if (depth.name == name) return depth.depth;
  ADD_FAILURE() << "no constituent " << name;
  return 0.0;
}

// Atmosphere::column knows no lines.
double smooth_depth(const std::vector<ConstituentDepth>& depths) {
  double total = 0.0;
  for (const ConstituentDepth& depth : depths) total += depth.depth;
  return total - depth_of(depths, "oxygen") - depth_of(depths, "water_vapour");
}

// Published: Bodhaine et al. 1999, eq. 30 (45°, sea level, 1013.25 hPa, 360 ppm CO2). Ours is 0.06 %
// more: they take gravity at 5.5 km, the median of the air's mass; its mean is at 7.3 km, which our
// hydrostatic profile has by itself (2 · 1.8 km / 6357 km = 0.057 %).
TEST(Atmosphere, RayleighDepthOfTheStandardAtmosphere) {
  AtmosphereOptions options;
  options.gravity_m_s2 = 9.80616;
  const Atmosphere air(test::context, load_profile(test::context, "ussa1976"), options);
  for (double wavelength_nm : {400.0, 500.0, 550.0, 600.0, 700.0}) {
    const double square = wavelength_nm * wavelength_nm * 1e-6;
    const double published = 0.0021520 * (1.0455996 - 341.29061 / square - 0.90230850 * square) /
                             (1.0 + 0.0027059889 / square - 85.968563 * square);
    EXPECT_NEAR(air.rayleigh_depth(wavelength_nm) / published, 1.0, 1e-3) << wavelength_nm;
    EXPECT_NEAR(air.rayleigh_depth(wavelength_nm) / published, 1.00057, 2e-4) << wavelength_nm;
  }
}

// τ = σ p / (m g): the column is inversely proportional to gravity, the air at the ground is not. The
// 3e-7th of the air above 100 km is missing, of which stretching by 0.5 % changes a part: 3e-8.
TEST(Atmosphere, GravityStretchesTheAir) {
  const Profile profile = load_profile(test::context, "ussa1976");
  AtmosphereOptions equator;
  equator.gravity_m_s2 = 9.7803;
  AtmosphereOptions pole;
  pole.gravity_m_s2 = 9.8322;
  const Atmosphere at_equator(test::context, profile, equator);
  const Atmosphere at_pole(test::context, profile, pole);
  EXPECT_NEAR(at_equator.rayleigh_depth(500.0) / at_pole.rayleigh_depth(500.0), 9.8322 / 9.7803, 3e-8);
  EXPECT_DOUBLE_EQ(at_equator.rayleigh_extinction_at_ground_per_km(500.0),
                   at_pole.rayleigh_extinction_at_ground_per_km(500.0));
}

TEST(Atmosphere, LayersAddUpToTheConstituents) {
  for (const char* name : {"ussa1976", "utm2005"}) {
    const Atmosphere air(test::context, load_profile(test::context, name), {});
    const std::size_t layers = air.shells().levels_km.size() - 1;
    EXPECT_EQ(air.shells().levels_km.front(), 0.0);
    EXPECT_EQ(air.shells().levels_km.back(), 100.0);
    for (double wavelength_nm : {300.0, 380.0, 550.0, 602.5, 1000.0})
      for (double aod500 : {0.0, 0.003, 0.5}) {
        const OpticalColumn column = air.column(wavelength_nm, aod500);
        ASSERT_EQ(column.extinction_depth.size(), layers);
        const double total = smooth_depth(air.optical_depths({.wavelength_nm = wavelength_nm}, aod500));
        EXPECT_NEAR(sum(column.extinction_depth) / total, 1.0, 1e-7) << name << " " << wavelength_nm;
        EXPECT_EQ(column.scatterers.size(), aod500 > 0.0 ? 2u : 1u);
        for (std::size_t layer = 0; layer < layers; ++layer) {
          double scattering = 0.0;
          for (const Scatterer& scatterer : column.scatterers)
            scattering += scatterer.scattering_depth[layer];
          EXPECT_LE(scattering, column.extinction_depth[layer]);
          EXPECT_GT(scattering, 0.0);
        }
        EXPECT_NEAR(sum(column.scatterers[0].scattering_depth), air.rayleigh_depth(wavelength_nm),
                    1e-8 * air.rayleigh_depth(wavelength_nm));
        if (aod500 > 0.0) {
          const AerosolOptics aerosol;
          EXPECT_NEAR(sum(column.scatterers[1].scattering_depth),
                      aod500 * aerosol.relative_depth(wavelength_nm) *
                          aerosol.single_scattering_albedo_at(wavelength_nm),
                      1e-12);
        }
      }
  }
}

// Optical depth above an altitude = layers above it; halfway through a layer = in between.
TEST(Atmosphere, DepthsAboveAnAltitude) {
  const Atmosphere air(test::context, load_profile(test::context, "ussa1976"), {});
  const auto total = [&](double altitude_km) {
    return smooth_depth(air.optical_depths({.wavelength_nm = 550.0}, 0.2, altitude_km));
  };
  const OpticalColumn column = air.column(550.0, 0.2);
  double above = 0.0;
  for (std::size_t layer = column.extinction_depth.size(); layer-- > 0;) {
    above += column.extinction_depth[layer];
    EXPECT_NEAR(total(air.shells().levels_km[layer]) / above, 1.0, 1e-7);
  }
  EXPECT_LT(total(12.5), total(12.0));
  EXPECT_EQ(total(100.0), 0.0);
  // Pressure falls to 193.99/1013.25 at 12 km, and the Rayleigh depth with it (but for gravity: 0.3 %).
  EXPECT_NEAR(air.optical_depths({.wavelength_nm = 550.0}, 0.0, 12.0)[0].depth / air.rayleigh_depth(550.0),
              193.99 / 1013.25, 0.001);
}

// Ozone by hand: 343.8 DU times the cross-section at the ozone's mean temperature; the cross-section's
// curvature over the temperatures of the stratosphere (±20 K) adds up to 0.3 %.
TEST(Atmosphere, OzoneDepth) {
  const Atmosphere air(test::context, load_profile(test::context, "ussa1976"), {});
  const CrossSection ozone = load_ozone_cross_section(test::context);
  const double mean_K = air.profile().quantities.front().ozone_temperature_K;
  for (double wavelength_nm : {500.0, 550.0, 600.0, 700.0}) {
    const double expected = 343.8 * kDobsonUnit_per_m2 * ozone.at_m2(wavelength_nm, mean_K);
    EXPECT_NEAR(depth_of(air.optical_depths({.wavelength_nm = wavelength_nm}, 0.0), "ozone") / expected, 1.0,
                3e-3)
        << wavelength_nm;
  }
  AtmosphereOptions options;
  options.ozone_du = 171.9;
  EXPECT_NEAR(depth_of(Atmosphere(test::context, load_profile(test::context, "ussa1976"), options)
                           .optical_depths({.wavelength_nm = 600.0}, 0.0),
                       "ozone"),
              0.5 * depth_of(air.optical_depths({.wavelength_nm = 600.0}, 0.0), "ozone"), 1e-12);
  options.ozone_du = 0.0;
  EXPECT_EQ(depth_of(Atmosphere(test::context, load_profile(test::context, "ussa1976"), options)
                         .optical_depths({.wavelength_nm = 600.0}, 0.0),
                     "ozone"),
            0.0);
}

TEST(Atmosphere, ProfileSaysWhereTheAerosolIs) {
  Profile profile = load_profile(test::context, "ussa1976");
  for (double z : profile.altitude_km) profile.relative_aerosol_extinction.push_back(z <= 1.0 ? 7.0 : 0.0);
  const Atmosphere air(test::context, profile, {});
  // 7 over the first kilometre, then linear to 0 over the second: 7 + 3.5.
  EXPECT_NEAR(depth_of(air.optical_depths({.wavelength_nm = 500.0}, 0.3, 1.0), "aerosol"), 0.3 * 3.5 / 10.5,
              1e-12);
  EXPECT_NEAR(air.aerosol_extinction_at_ground_per_km(500.0, 0.3), 0.3 / 1.5, 1e-12);
}

TEST(Atmosphere, OutOfRangeIsRefused) {
  const Profile profile = load_profile(test::context, "ussa1976");
  const auto refused = [&](auto change) {
    AtmosphereOptions options;
    change(options);
    EXPECT_THROW(Atmosphere(test::context, profile, options), InputError);
  };
  refused([](AtmosphereOptions& o) { o.ground_albedo = 1.1; });
  refused([](AtmosphereOptions& o) { o.ground_albedo = NAN; });
  refused([](AtmosphereOptions& o) { o.ozone_du = -1.0; });
  refused([](AtmosphereOptions& o) { o.no2_du = 101.0; });
  refused([](AtmosphereOptions& o) { o.water_cm = -0.1; });
  refused([](AtmosphereOptions& o) { o.surface_pressure_hPa = 299.0; });
  refused([](AtmosphereOptions& o) { o.gravity_m_s2 = 3.7; });
  refused([](AtmosphereOptions& o) { o.planet_radius_km = 0.0; });
  refused([](AtmosphereOptions& o) { o.aerosol.angstrom_exponent = 9.0; });
  const Atmosphere air(test::context, profile, {});
  EXPECT_THROW(air.column(299.0, 0.0), InputError);
  EXPECT_THROW(air.column(500.0, -0.1), InputError);
  EXPECT_THROW(air.column(500.0, INFINITY), InputError);
  EXPECT_THROW(air.optical_depths({.wavelength_nm = 500.0}, 0.0, 101.0), InputError);
  EXPECT_THROW(air.extinctions({500.0, 0.0}, 0.0), InputError);
  EXPECT_THROW(air.band_columns({500.0, -5.0}, 0.0), InputError);
}

}  // namespace
}  // namespace skylut
