#include "skylut/scattering/aerosol_description.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

class AerosolFile : public testing::Test {
 protected:
  AerosolFile() : folder_(fs::temp_directory_path() / ("skylut-aerosol-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~AerosolFile() override { fs::remove_all(folder_); }

  std::string write(const std::string& text) const {
    const fs::path path = folder_ / "mine.toml";
    std::ofstream(path) << text;
    return path.string();
  }

  // The message of the refusal.
  std::string refusal(const std::string& text) const {
    try {
      load_aerosol_description(test::context, write(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

 private:
  fs::path folder_;
};

const std::string kHead = "name = 'mine'\ndescription = 'a'\nsource = 'b'\n";
const std::string kSmoke =
    "[[component]]\nname = 'smoke'\nnumber_per_cm3 = 1000\nmode_radius_um = 0.1\nsigma_g = 1.8\n"
    "r_min_um = 0.01\nr_max_um = 5\nn = 1.5\nk = 0.02\n";

TEST_F(AerosolFile, UsersParticles) {
  const AerosolDescription aerosol = load_aerosol_description(
      test::context, write(kHead + kSmoke + "[shape]\nscale_height_km = 3\nmixed_layer_km = 1\n"));
  ASSERT_EQ(aerosol.components.size(), 1u);
  EXPECT_EQ(aerosol.components[0].size.sigma_g, 1.8);
  EXPECT_EQ(aerosol.components[0].k, std::vector<double>{0.02});
  EXPECT_EQ(aerosol.shape.haze_scale_height_km, 3.0);
  EXPECT_EQ(aerosol.shape.mixed_layer_km, 1.0);
  EXPECT_EQ(aerosol.shape.stratospheric_aod500, 0.005);
}

TEST_F(AerosolFile, MistakesAreNamed) {
  const auto names = [](const std::string& message, const std::vector<std::string>& parts) {
    for (const std::string& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << message << " lacks " << part;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  };
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return kHead + text;
  };
  names(refusal(kHead), {"mine.toml", "component", "must be given"});
  names(refusal(with(kSmoke, "sigma_g = 1.8", "sigma_g = 0.5")),
        {"mine.toml:8", "sigma_g", "0.5", "1.01 to 10"});
  names(refusal(with(kSmoke, "r_max_um = 5", "r_max_um = 0.001")),
        {"r_max_um", "0.001", "greater than r_min_um"});
  names(refusal(with(kSmoke, "k = 0.02", "k = -0.02")), {"k", "-0.02", "0 to 20"});
  names(refusal(with(kSmoke, "n = 1.5", "n = [1.5, 1.6]")), {"n", "2 values", "must have 1"});
  names(refusal(with(kSmoke, "sigma_g", "sigma")), {"sigma", "unknown key", "sigma_g"});
  names(refusal(with(kSmoke, "number_per_cm3 = 1000", "number_per_cm3 = -3")), {"number_per_cm3", "-3"});
  names(refusal(with(kSmoke, "name = 'smoke'", "name = 'smoke'\ndistribution = 'gamma'")),
        {"distribution", "gamma", "lognormal or power-law"});
  names(refusal(kHead + "[[component]]\nparticles = 'ash'\nnumber_per_cm3 = 1\n"),
        {"particles", "ash", "water-soluble"});
  names(refusal(kHead + "[[component]]\nparticles = 'water-soluble'\nnumber_per_cm3 = 1\n"),
        {"water-soluble", "humidity_percent"});
  names(refusal(kHead + kSmoke + "[shape]\nscale_height_km = 30\n"), {"scale height", "30", "0.1-20"});
  names(refusal(kHead + kSmoke + "[stratosphere]\naerosol = 'x'\n"), {"stratosphere.aerosol", "x", "rural"});
  EXPECT_THROW(load_aerosol_description(test::context, "mars"), InputError);
  EXPECT_THROW(load_aerosol_description(test::context, "./none.toml"), InputError);
  EXPECT_THROW(load_aerosol_description(test::context, "rural", 80.0), InputError);
  EXPECT_THROW(load_aerosol_description(test::context, "urban", 99.5), InputError);
}

TEST(AerosolDescription, PresetsCiteTheirSources) {
  for (const std::string& name : aerosol_names(test::context)) {
    const AerosolDescription aerosol = load_aerosol_description(test::context, name);
    EXPECT_EQ(aerosol.name, name);
    EXPECT_FALSE(aerosol.source.empty()) << name;
    EXPECT_EQ(aerosol.components.empty(), aerosol.optics.has_value()) << name;
    for (const AerosolComponent& component : aerosol.components) {
      EXPECT_EQ(component.n.size(), component.wavelength_nm.size()) << name;
      EXPECT_EQ(component.k.size(), component.wavelength_nm.size()) << name;
    }
  }
}

// OPAC's water-soluble particles: 0.0306 µm at 80 %, 0.0348 µm at 90 %; halfway, the geometric mean.
TEST(AerosolDescription, ParticlesGrowWithHumidity) {
  const auto radius = [](double humidity) {
    return load_aerosol_description(test::context, "continental-clean", humidity)
        .components[0]
        .size.mode_radius_um;
  };
  EXPECT_EQ(radius(80.0), 0.0306);
  EXPECT_EQ(radius(90.0), 0.0348);
  EXPECT_NEAR(radius(85.0), std::sqrt(0.0306 * 0.0348), 1e-12);
  const AerosolComponent dry =
      load_aerosol_description(test::context, "continental-clean", 0.0).components[0];
  const AerosolComponent wet =
      load_aerosol_description(test::context, "continental-clean", 99.0).components[0];
  EXPECT_GT(dry.n[5], 1.52);
  EXPECT_LT(wet.n[5], 1.36);  // nearly water, 1.333
}

TEST(AerosolDescription, SizeDistributionsHoldOneParticle) {
  SizeDistribution lognormal;
  lognormal.r_min_um = 1e-4;
  lognormal.r_max_um = 100.0;
  SizeDistribution power;
  power.kind = SizeDistribution::Kind::power_law;
  power.r_min_um = 0.04;
  power.r_max_um = 10.0;
  for (const SizeDistribution& size : {lognormal, power}) {
    const Quadrature rule = gauss_legendre(200, std::log(size.r_min_um), std::log(size.r_max_um));
    double particles = 0.0;
    for (std::size_t i = 0; i < rule.node.size(); ++i)
      particles += rule.weight[i] * size.per_log_radius(std::exp(rule.node[i]));
    EXPECT_NEAR(particles, 1.0, 1e-9);
    EXPECT_EQ(size.per_log_radius(2.0 * size.r_max_um), 0.0);
  }
  // dN/dr of the power law falls as r^-(exponent + 1).
  EXPECT_NEAR(power.per_log_radius(0.1) / power.per_log_radius(0.2), 8.0, 1e-12);
}

}  // namespace
}  // namespace skylut
