#include "options/options.hpp"

#include <gtest/gtest.h>

#include "options/command.hpp"
#include "options/file_kinds.hpp"
#include "options/number_kinds.hpp"

namespace skylut::cli {
namespace {

struct Values {
  std::string profile = "ussa1976";
  double height_m = 0.0;
  std::optional<double> ozone_du;
  NamedNumbers limits;
  std::int64_t threads = 0;
  bool diffuse = false;
};

Command program(Values& values) {
  Command command;
  command.name = "show";
  OptionSet& set = command.options;
  set.add("--profile", values.profile, name_or_file(), "");
  set.add("--height-m", values.height_m, number({-500.0, 9000.0, "m"}), "");
  set.add("--ozone-du", values.ozone_du, number({0.0, 1000.0, "DU"}), "");
  set.add("--limit", values.limits, named_numbers(), "").repeatable = true;
  set.add("--threads", values.threads, whole_number({0.0, 1024.0, ""}), "").recorded = false;
  set.add_flag("--diffuse", values.diffuse, "");
  command.run = [](const OptionSet&) {};
  Command program;
  program.name = "skylut";
  program.subcommands.push_back(std::move(command));
  return program;
}

std::string run(Values& values, std::vector<const char*> arguments) {
  Command skylut = program(values);
  arguments.insert(arguments.begin(), {"skylut", "show"});
  try {
    run_command_line(skylut, static_cast<int>(arguments.size()), arguments.data());
  } catch (const InputError& error) {
    return error.what();
  }
  return skylut.subcommands[0].options.command_line("skylut show");
}

TEST(Options, RecordDefaultsAndWhatWasGiven) {
  Values values;
  EXPECT_EQ(run(values, {}), "skylut show --profile ussa1976 --height-m 0");
  EXPECT_EQ(run(values, {"--ozone-du", "+250", "--threads=3", "--diffuse"}),
            "skylut show --profile ussa1976 --height-m 0 --ozone-du 250 --diffuse");
  EXPECT_EQ(values.threads, 3);
}

TEST(Options, RecordedValuesAreQuoted) {
  Values values;
  EXPECT_EQ(run(values, {"--profile", "my dir/it's $HOME.toml", "--height-m", "-12"}),
            R"(skylut show --profile 'my dir/it'\''s $HOME.toml' --height-m=-12)");
}

TEST(Options, NegativeValuesNeedNoEqualsSign) {
  Values values;
  run(values, {"--height-m", "-12.5"});
  EXPECT_EQ(values.height_m, -12.5);
}

TEST(Options, OnlyListsAreGivenTwice) {
  Values values;
  EXPECT_EQ(run(values, {"--height-m", "1", "--height-m", "2"}),
            "--height-m: must be given once, not 2 times");
  run(values, {"--limit", "a=1", "--limit", "b=2"});
  EXPECT_EQ(values.limits.size(), 2u);
}

TEST(Options, AValueThatIsMissingIsNoOtherOption) {
  Values values;
  EXPECT_EQ(run(values, {"--profile", "--diffuse"}), "--profile: its value is missing before --diffuse");
  EXPECT_EQ(run(values, {"--profile"}), "--profile: its value is missing (see skylut show --help)");
}

TEST(Options, SayWhatIsUnknown) {
  Values values;
  EXPECT_EQ(run(values, {"--ozone", "3"}),
            "--ozone: unknown option, did you mean --ozone-du? (see skylut show --help)");
  EXPECT_EQ(run(values, {"more"}), "'more': belongs to no option (see skylut show --help)");
  EXPECT_EQ(run(values, {"--diffuse=3"}), "--diffuse: takes no value (see skylut show --help)");
}

TEST(Options, TakeNoControlCharacters) {
  Values values;
  EXPECT_EQ(run(values, {"--profile", "a\nb"}), "--profile: must not hold a control character");
}

TEST(ShellQuoted, LeavesPlainWords) {
  EXPECT_EQ(shell_quoted("380:780:5"), "380:780:5");
  EXPECT_EQ(shell_quoted(""), "''");
  EXPECT_EQ(shell_quoted("a b"), "'a b'");
  EXPECT_EQ(shell_quoted("~x"), "'~x'");
  EXPECT_EQ(shell_quoted("'"), R"(''\''')");
}

TEST(ShellWords, ReadWhatWasQuoted) {
  const std::vector<std::string> words{"skylut",      "a b", "it's", "", "$HOME `x` \"y\" *;&.{}",
                                       "back\\slash", "-1,2"};
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_quoted(word);
  EXPECT_EQ(shell_words(line), words);
  EXPECT_EQ(shell_words("a  b'c d'e"), (std::vector<std::string>{"a", "bc de"}));
  EXPECT_TRUE(shell_words("").empty());
  EXPECT_THROW(shell_words("a 'b"), InputError);
}

}  // namespace
}  // namespace skylut::cli
