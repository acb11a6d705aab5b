#include "skylut/core/atomic_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  const fs::path folder_ = fs::temp_directory_path() / "skylut_atomic_file_test";
};

TEST_F(AtomicFile, WritesTheTextAndNothingElse) {
  write_text_atomically(folder_ / "a.txt", "hello\n");
  std::ifstream file(folder_ / "a.txt");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "hello\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(AtomicFile, AFailedWriteLeavesTheOldFile) {
  write_text_atomically(folder_ / "a.txt", "old");
  EXPECT_THROW(write_atomically(folder_ / "a.txt",
                                [](const fs::path& temporary) {
                                  std::ofstream(temporary) << "half";
                                  throw WorkError("broken off");
                                }),
               WorkError);
  EXPECT_EQ(fs::file_size(folder_ / "a.txt"), 3u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(AtomicFile, SaysWhatIsInTheWay) {
  EXPECT_THROW(write_text_atomically(folder_, "x"), WorkError);
  EXPECT_THROW(write_text_atomically(folder_ / "missing" / "a.txt", "x"), WorkError);
  EXPECT_THROW(write_text_atomically("/dev/full", "x"), WorkError);
}

}  // namespace
}  // namespace skylut
