#include "skylut/core/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "core/unfinished_file.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class AtomicFiles : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::ptrdiff_t files_in_folder() const { return std::distance(fs::directory_iterator(folder_), {}); }
  void put(const fs::path& path, const std::string& text) const {
    std::ofstream(path, std::ios::binary) << text;
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("skylut_atomic_file_test." + std::to_string(::getpid()));
};

TEST_F(AtomicFiles, WritesTheTextAndNothingElse) {
  write_text_atomically(folder_ / "a.txt", "hello\n");
  EXPECT_EQ(text_of(folder_ / "a.txt"), "hello\n");
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(AtomicFiles, AFullDiskLeavesTheOldFile) {
  put(folder_ / "a.txt", "old");
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{1000, limit.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(write_text_atomically(folder_ / "a.txt", std::string(2000, 'x')), WorkError);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(text_of(folder_ / "a.txt"), "old");
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(AtomicFiles, SaysWhatIsInTheWay) {
  EXPECT_THROW(write_text_atomically(folder_, "x"), WorkError);
  EXPECT_THROW(write_text_atomically(folder_ / "missing" / "a.txt", "x"), WorkError);
  EXPECT_THROW(write_text_atomically("/dev/full", "x"), WorkError);
}

TEST_F(AtomicFiles, ANewFileHasThePermissionsOfTheUmaskAReplacedOneItsOwn) {
  const mode_t old_mask = ::umask(027);
  write_text_atomically(folder_ / "a.txt", "new");
  ::umask(old_mask);
  EXPECT_EQ(fs::status(folder_ / "a.txt").permissions(), fs::perms{0640});
  fs::permissions(folder_ / "a.txt", fs::perms{0600});
  write_text_atomically(folder_ / "a.txt", "newer");
  EXPECT_EQ(fs::status(folder_ / "a.txt").permissions(), fs::perms{0600});
}

TEST_F(AtomicFiles, ALinkOfThatNameIsReplacedNotFollowed) {
  put(folder_ / "victim", "precious");
  fs::create_symlink("victim", folder_ / "a.txt");
  write_text_atomically(folder_ / "a.txt", "mine");
  EXPECT_EQ(text_of(folder_ / "victim"), "precious");
  EXPECT_FALSE(fs::is_symlink(folder_ / "a.txt"));
  EXPECT_EQ(text_of(folder_ / "a.txt"), "mine");
}

TEST_F(AtomicFiles, ATemporaryNameThatIsTakenIsNeitherFollowedNorOverwritten) {
  put(folder_ / "victim", "precious");
  const fs::path planted = temporary_path(folder_ / "a.txt");
  fs::create_symlink("victim", planted);
  EXPECT_THROW(UnfinishedFile(planted, folder_ / "a.txt"), WorkError);
  fs::remove(planted);
  fs::create_symlink("missing", planted);
  EXPECT_THROW(UnfinishedFile(planted, folder_ / "a.txt"), WorkError);
  fs::remove(planted);
  put(planted, "somebody's");
  EXPECT_THROW(UnfinishedFile(planted, folder_ / "a.txt"), WorkError);
  EXPECT_EQ(text_of(planted), "somebody's");
  EXPECT_EQ(text_of(folder_ / "victim"), "precious");
  EXPECT_FALSE(fs::exists(folder_ / "missing"));
}

TEST_F(AtomicFiles, TemporaryNamesDiffer) {
  EXPECT_NE(temporary_path(folder_ / "a.txt"), temporary_path(folder_ / "a.txt"));
}

TEST_F(AtomicFiles, TheLongestNameStillFits) {
  const fs::path path = folder_ / std::string(255, 'n');
  write_text_atomically(path, "long");
  EXPECT_EQ(text_of(path), "long");
}

TEST_F(AtomicFiles, LeftoversOfAKilledRunAreClearedOthersStay) {
  const fs::path leftover = temporary_path(folder_ / "a.txt");
  put(leftover, "half");
  const fs::path link = temporary_path(folder_ / "a.txt");
  put(folder_ / "victim", "precious");
  fs::create_symlink("victim", link);
  const fs::path another_file = temporary_path(folder_ / "b.txt");
  put(another_file, "half");
  put(folder_ / "a.txt.skylut-notes.tmp", "the user's");
  const fs::path under_way_path = temporary_path(folder_ / "a.txt");
  const UnfinishedFile under_way(under_way_path, folder_ / "a.txt");

  write_text_atomically(folder_ / "a.txt", "whole");
  EXPECT_FALSE(fs::exists(leftover));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(text_of(folder_ / "victim"), "precious");
  EXPECT_TRUE(fs::exists(another_file));
  EXPECT_TRUE(fs::exists(folder_ / "a.txt.skylut-notes.tmp"));
  EXPECT_TRUE(fs::exists(under_way_path)) << "locked by its writer";
}

TEST_F(AtomicFiles, RemovesWhatIsUnderWayOnASignal) {
  const fs::path path = temporary_path(folder_ / "a.txt");
  const UnfinishedFile file(path, folder_ / "a.txt");
  write_all(file.descriptor(), "half", path);
  ASSERT_TRUE(fs::exists(path));
  remove_unfinished_files();
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(AtomicFiles, WritersOfOneNameDoNotMix) {
  constexpr std::size_t kSize = 100'000;
  constexpr std::array<char, 3> kLetters{'x', 'y', 'z'};
  std::array<std::thread, 3> writers;
  for (std::size_t i = 0; i < writers.size(); ++i)
    writers[i] = std::thread([this, letter = kLetters[i]] {
      for (int round = 0; round < 20; ++round)
        write_text_atomically(folder_ / "a.txt", std::string(kSize, letter));
    });
  for (std::thread& writer : writers) writer.join();
  const std::string text = text_of(folder_ / "a.txt");
  ASSERT_EQ(text.size(), kSize);
  EXPECT_EQ(text, std::string(kSize, text[0]));
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(AtomicFiles, AnOpenDescriptorIsWrittenToWhereItStands) {
  std::FILE* file = std::fopen((folder_ / "out").c_str(), "w");
  ASSERT_NE(file, nullptr);
  std::fputs("before ", file);
  std::fflush(file);
  write_text_atomically("/proc/self/fd/" + std::to_string(::fileno(file)), "text ");
  std::fputs("after", file);
  std::fclose(file);
  EXPECT_EQ(text_of(folder_ / "out"), "before text after");
}

TEST_F(AtomicFiles, PiecesGoWhereTheyAreSoughtAndAppearWhenPublished) {
  {
    AtomicFile file(folder_ / "a.txt");
    file.write("0123456789");
    file.seek(4);
    file.write("four");
    EXPECT_EQ(file.position(), 8u);
    EXPECT_FALSE(fs::exists(folder_ / "a.txt"));
    std::array<AtomicFile*, 1> files{&file};
    AtomicFile::publish(files);
    EXPECT_EQ(text_of(folder_ / "a.txt"), "0123four89");
  }
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(AtomicFiles, AnUnpublishedFileLeavesNothing) {
  {
    AtomicFile file(folder_ / "a.txt");
    file.write("half");
    EXPECT_EQ(files_in_folder(), 1);
  }
  EXPECT_EQ(files_in_folder(), 0);
}

// Whoever swallows the failure of one piece, as OpenEXR's destructors do, gets no file all the same.
TEST_F(AtomicFiles, AMissingPieceIsNotForgotten) {
  put(folder_ / "b.txt", "old");
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{1000, limit.rlim_max};
  AtomicFile whole(folder_ / "a.txt");
  AtomicFile broken(folder_ / "b.txt");
  whole.write("whole");
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(broken.write(std::string(2000, 'x')), WorkError);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler);
  broken.seek(0);
  broken.write("small");
  std::array<AtomicFile*, 2> files{&whole, &broken};
  EXPECT_THROW(AtomicFile::publish(files), WorkError);
  EXPECT_FALSE(fs::exists(folder_ / "a.txt"));
  EXPECT_EQ(text_of(folder_ / "b.txt"), "old");
}

TEST_F(AtomicFiles, ADeviceIsWrittenToWhenPublished) {
  AtomicFile full("/dev/full");
  full.write("x");
  std::array<AtomicFile*, 1> files{&full};
  EXPECT_THROW(AtomicFile::publish(files), WorkError);
}

}  // namespace
}  // namespace skylut
