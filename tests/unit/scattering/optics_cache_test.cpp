#include "optics_cache.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "support/test_context.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

class OpticsCache : public testing::Test {
 protected:
  OpticsCache() : folder_(fs::temp_directory_path() / ("skylut-cache-" + std::to_string(::getpid()))) {
    context_.cache_folder = folder_ / "skylut";
  }
  ~OpticsCache() override {
    fs::permissions(folder_, fs::perms::owner_all, ignored_);
    fs::remove_all(folder_, ignored_);
  }

  fs::path only_file() const { return fs::directory_iterator(folder_ / "skylut")->path(); }

  fs::path folder_;
  Context context_ = test::context;
  std::error_code ignored_;
};

const std::vector<ParticleOptics> kResults{{1.0 / 3.0, 0.1, {1.0, 0.7, -1e-9}}, {2e-12, 1e-12, {1.0, 0.1}}};

TEST_F(OpticsCache, GivesBackWhatItGot) {
  EXPECT_FALSE(find_in_cache(context_, "key"));
  keep_in_cache(context_, "key", kResults);
  const auto found = find_in_cache(context_, "key");
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ((*found)[i].extinction_um2, kResults[i].extinction_um2);
    EXPECT_EQ((*found)[i].scattering_um2, kResults[i].scattering_um2);
    EXPECT_EQ((*found)[i].moments, kResults[i].moments);
  }
  EXPECT_FALSE(find_in_cache(context_, "another key"));
}

TEST_F(OpticsCache, IgnoresWhatIsDamaged) {
  keep_in_cache(context_, "key", kResults);
  const fs::path file = only_file();
  for (const char* text :
       {"", "key\n0.3 0.1 1 0.7\n", "key\n0.3 0.1 one 0.7\nend\n", "other\n0.3 0.1 1 0.7\nend\n"}) {
    std::ofstream(file) << text;
    EXPECT_FALSE(find_in_cache(context_, "key")) << text;
  }
  keep_in_cache(context_, "key", kResults);
  EXPECT_TRUE(find_in_cache(context_, "key"));
}

TEST_F(OpticsCache, NeedsNoPlace) {
  std::ofstream(folder_) << "a file where the folder should be";
  EXPECT_NO_THROW(keep_in_cache(context_, "key", kResults));
  EXPECT_FALSE(find_in_cache(context_, "key"));
}

TEST(OpticsKey, NamesEveryNumber) {
  AerosolComponent component;
  component.wavelength_nm = {500.0};
  component.n = {1.5};
  component.k = {0.01};
  const std::string key = optics_key({component}, {400.0, 500.0});
  AerosolComponent other = component;
  other.k = {0.010000000000000002};
  EXPECT_NE(optics_key({other}, {400.0, 500.0}), key);
  other = component;
  other.size.sigma_g = 2.1;
  EXPECT_NE(optics_key({other}, {400.0, 500.0}), key);
  EXPECT_NE(optics_key({component}, {400.0}), key);
}

}  // namespace
}  // namespace skylut
