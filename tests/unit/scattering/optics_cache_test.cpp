#include "optics_cache.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

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

  static std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_;
  Context context_ = test::context;
  std::error_code ignored_;
};

const PolarisationMoments kNone{{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
const std::vector<ParticleOptics> kResults{
    {1.0 / 3.0, 0.1, {1.0, 0.7, -1e-9}, {{0.0, 0.0, 0.6}, {0.0, 0.0, 1e-5}, {0.0, 0.0, -0.24}}},
    {2e-12, 1e-12, {1.0, 0.1}, kNone}};

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
    EXPECT_EQ((*found)[i].polarisation.alpha2, kResults[i].polarisation.alpha2);
    EXPECT_EQ((*found)[i].polarisation.alpha3, kResults[i].polarisation.alpha3);
    EXPECT_EQ((*found)[i].polarisation.beta1, kResults[i].polarisation.beta1);
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

// One number changed by hand: the checksum tells.
TEST_F(OpticsCache, ChangedNumbersAreNotBelieved) {
  keep_in_cache(context_, "key", kResults);
  const fs::path file = only_file();
  const std::string whole = text_of(file);
  for (const auto& [from, to] : {std::pair{"0.1 1 0.7", "0.05 1 0.7"},  // scattering halved
                                 {" 1 0.7", " 7 0.7"},                  // moment 0
                                 {" 1 0.7", " inf 0.7"},
                                 {" 1 0.7", " nan 0.7"},
                                 {"0.7", "0.8"},
                                 {"end\n", "end\n\n"},
                                 {"2e-12", "3e-12"}}) {
    std::string changed = whole;
    changed.replace(changed.rfind(from), std::string(from).size(), to);
    ASSERT_NE(changed, whole);
    std::ofstream(file) << changed;
    EXPECT_FALSE(find_in_cache(context_, "key")) << from << " to " << to;
  }
  std::ofstream(file) << whole.substr(0, whole.size() / 2);
  EXPECT_FALSE(find_in_cache(context_, "key"));
  std::ofstream(file) << whole;
  EXPECT_TRUE(find_in_cache(context_, "key"));
}

// Numbers that no sphere has, with the checksum they would have.
TEST_F(OpticsCache, ImpossibleNumbersAreNotBelieved) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const ParticleOptics& impossible :
       {ParticleOptics{1.0, 1.1, {1.0, 0.5}, kNone}, ParticleOptics{-1.0, -1.0, {1.0, 0.5}, kNone},
        ParticleOptics{infinity, 1.0, {1.0, 0.5}, kNone}, ParticleOptics{1.0, NAN, {1.0, 0.5}, kNone},
        ParticleOptics{1.0, 0.5, {7.0, 0.5}, kNone}, ParticleOptics{1.0, 0.5, {1.0, 1.5}, kNone},
        ParticleOptics{1.0, 0.5, {1.0, infinity}, kNone}, ParticleOptics{1.0, 0.5, {1.0, 0.5}},
        ParticleOptics{1.0, 0.5, {1.0, 0.5}, {{0.0, 0.0}, {0.0, 0.0}, {0.0, -1.5}}}}) {
    keep_in_cache(context_, "key", {kResults[0], impossible});
    EXPECT_FALSE(find_in_cache(context_, "key"));
  }
}

// A pipe would keep the reader waiting for ever, a link shows another file: neither is a file of ours,
// neither is written to.
TEST_F(OpticsCache, OnlyRegularFilesCount) {
  keep_in_cache(context_, "key", kResults);
  const fs::path file = only_file();
  const fs::path moved = folder_ / "moved";
  fs::rename(file, moved);
  fs::create_symlink(moved, file);
  EXPECT_FALSE(find_in_cache(context_, "key"));
  keep_in_cache(context_, "key", {});
  EXPECT_TRUE(fs::is_symlink(file));
  fs::remove(file);
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  EXPECT_FALSE(find_in_cache(context_, "key"));
  keep_in_cache(context_, "key", kResults);
  EXPECT_TRUE(fs::is_fifo(file));
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_FALSE(find_in_cache(context_, "key"));
  EXPECT_NO_THROW(keep_in_cache(context_, "key", kResults));
  fs::remove(file);
  std::ofstream(file) << "x";
  fs::resize_file(file, 1'000'000'000);
  EXPECT_FALSE(find_in_cache(context_, "key"));
}

TEST_F(OpticsCache, WithoutAFolderNothingIsKept) {
  context_.cache_folder.clear();
  keep_in_cache(context_, "key", kResults);
  EXPECT_FALSE(find_in_cache(context_, "key"));
  EXPECT_FALSE(fs::exists(folder_));
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
