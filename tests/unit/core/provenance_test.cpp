#include "skylut/core/provenance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "skylut/core/errors.hpp"
#include "skylut/core/version.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

TEST(Provenance, SaysHowAFileCameAbout) {
  Provenance provenance("skylut map --turbidity 0.1");
  provenance.describe("ground", nlohmann::ordered_json{{"albedo", 0.2}});
  provenance.describe("ground", nlohmann::ordered_json{{"albedo", 0.3}});
  provenance.set_instruction_set("avx2");
  provenance.add_source(test::context, test::context.data_file("ussa1976.toml"));
  provenance.add_source(test::context, test::context.data_file("ussa1976.toml"));
  const nlohmann::ordered_json json = provenance.json();
  EXPECT_EQ(json["skylut_version"], kVersion);
  EXPECT_EQ(json["command"], "skylut map --turbidity 0.1");
  EXPECT_EQ(json["instruction_set"], "avx2");
  EXPECT_EQ(json["inputs"]["ground"]["albedo"], 0.3);
  ASSERT_EQ(json["sources"].size(), 1u);
  EXPECT_EQ(json["sources"][0]["file"], "profiles/ussa1976.toml");
  EXPECT_EQ(json["sources"][0]["sha256"].get<std::string>().size(), 64u);
}

TEST(Provenance, CommentLinesHoldItInOneLineEach) {
  Provenance provenance("skylut map --profile 'two\nlines'");
  provenance.describe("note", std::string("a\nb=c"));
  const std::string lines = provenance.comment_lines();
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2);
  EXPECT_EQ(lines.find("# command: skylut map"), 0u);
  const std::string json = lines.substr(lines.find("# provenance: ") + 14);
  EXPECT_EQ(nlohmann::json::parse(json)["inputs"]["note"], "a\nb=c");
  EXPECT_EQ(json.find('='), std::string::npos);
}

TEST(Provenance, ASourceThatCannotBeReadIsAFailure) {
  Provenance provenance("skylut");
  EXPECT_THROW(provenance.add_source(test::context, "no/such/file"), WorkError);
}

}  // namespace
}  // namespace skylut
