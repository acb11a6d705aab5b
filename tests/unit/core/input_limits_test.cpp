#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "core/toml_reader.hpp"
#include "skylut/core/csv.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/json_reader.hpp"

// Files that would exhaust stack or memory, and what a tree of their contents would hide, end in one line.
namespace skylut {
namespace {

namespace fs = std::filesystem;

class InputLimits : public testing::Test {
 protected:
  InputLimits() : file_(fs::temp_directory_path() / ("skylut-limits-" + std::to_string(::getpid()))) {}
  ~InputLimits() override { fs::remove(file_); }

  // The message without the file's name.
  std::string refusal(const std::string& text, const std::function<void(const std::string&)>& read) const {
    std::ofstream(file_, std::ios::binary) << text;
    try {
      read(file_.string());
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos);
      EXPECT_LT(message.size(), 400u);
      EXPECT_TRUE(message.starts_with(file_.string()));
      return message.substr(file_.string().size());
    }
    return "read";
  }
  std::string json(const std::string& text) const {
    return refusal(text, [](const std::string& path) { read_json_file(path); });
  }
  std::string toml(const std::string& text) const {
    return refusal(text, [](const std::string& path) { TomlReader::parse(path); });
  }
  std::string csv(const std::string& text) const {
    return refusal(text, [](const std::string& path) { CsvTable::read(path); });
  }

  fs::path file_;
};

std::string repeated(const std::string& text, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

std::string nested(const std::string& open, const std::string& close, std::size_t levels) {
  return repeated(open, levels) + repeated(close, levels);
}

TEST_F(InputLimits, DeepJson) {
  EXPECT_EQ(json("{\"a\":" + nested("[", "]", domain::kDeepestNesting - 1) + "}"), "read");
  EXPECT_EQ(json("{\"a\":" + nested("[", "]", domain::kDeepestNesting) + "}"),
            ": nested deeper than 64 levels");
  EXPECT_EQ(json(nested("{\"a\":", "}", 100'000)), ": nested deeper than 64 levels");
  EXPECT_EQ(json("{\"outputs\":1,\"geometry\":" + nested("[", "]", 65'000) + "}"),
            ": nested deeper than 64 levels");
  EXPECT_EQ(json(repeated("[", 1'000'000)), ": nested deeper than 64 levels");
}

TEST_F(InputLimits, JsonThatIsNone) {
  EXPECT_EQ(json("{\"a\": 1,"), ": not valid JSON near byte 9");
  EXPECT_EQ(json("{\"a\": NaN}"), ": not valid JSON near byte 7");
  EXPECT_EQ(json("{\"a\": Infinity}"), ": not valid JSON near byte 7");
  EXPECT_EQ(json("{\"a\": 1e999}"), ": holds a number out of range: must fit in double precision");
  EXPECT_EQ(json(""), ": not valid JSON near byte 1");
  EXPECT_EQ(json("\"\xFF\""), ": not valid JSON near byte 2");
}

TEST_F(InputLimits, JsonKeysAreGivenOnce) {
  EXPECT_EQ(json(R"({"albedo": 0.1, "layers": [{"tau": 1}], "albedo": 0.9})"),
            ": key \"albedo\" is given twice in one object: must be given once");
  EXPECT_EQ(json(R"({"a": {"tau": 1}, "b": {"tau": 1}, "tau": 1})"), "read");
}

TEST_F(InputLimits, DeepToml) {
  EXPECT_NE(toml("a = " + nested("[", "]", 100'000)).find("broken TOML"), std::string::npos);
  EXPECT_NE(toml("a = " + nested("{a = ", "}", 100'000)).find("broken TOML"), std::string::npos);
  for (const char* text : {"a = [1, nan, inf]\n", "[a.b.c]\nd = 1\n"}) EXPECT_EQ(toml(text), "read");
  EXPECT_NE(toml("a = 1\na = 2\n").find("broken TOML"), std::string::npos);
  EXPECT_EQ(toml("[a" + repeated(".a", 100'000) + "]\n"), ":1: a dotted key of more than 64 parts");
  EXPECT_EQ(toml("b = 1\na" + repeated(" . \"a\"", 100'000) + " = 1\n"),
            ":2: a dotted key of more than 64 parts");
}

TEST_F(InputLimits, LongLines) {
  EXPECT_EQ(csv("a,b\n1,2\n"), "read");
  EXPECT_EQ(csv("a,b\n" + std::string(domain::kLongestLine_bytes + 1, '1') + "\n"),
            ":2: longer than 1000000 bytes: must be a line of comma-separated values");
  EXPECT_THROW(CsvTable::read("/dev/zero"), InputError);
}

TEST_F(InputLimits, LargeFiles) {
  std::ofstream(file_) << "{";
  fs::resize_file(file_, domain::kLargestInput_bytes + 1);
  EXPECT_THROW(read_json_file(file_.string()), InputError);
  EXPECT_THROW(TomlReader::parse(file_.string()), InputError);
}

}  // namespace
}  // namespace skylut
