#include "skylut/site/time_steps.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

std::string refusal(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

TEST(Duration, AsPeopleAndAsIso8601WriteIt) {
  EXPECT_EQ(parse_duration_s("10min"), 600);
  EXPECT_EQ(parse_duration_s("1h"), 3600);
  EXPECT_EQ(parse_duration_s("30s"), 30);
  EXPECT_EQ(parse_duration_s("2d"), 172800);
  EXPECT_EQ(parse_duration_s("1h30min"), 5400);
  EXPECT_EQ(parse_duration_s("90min"), 5400);
  EXPECT_EQ(parse_duration_s("PT15M"), 900);
  EXPECT_EQ(parse_duration_s("PT1H30M5S"), 5405);
  EXPECT_EQ(parse_duration_s("P1DT12H"), 129600);
  EXPECT_EQ(parse_duration_s("P1D"), 86400);
  EXPECT_EQ(parse_duration_s("366d"), 366 * 86400);
}

TEST(Duration, RefusesWhatIsNone) {
  for (const char* text :
       {"",   "0min", "10",   "10m",  "min",  "-10min", "1.5h", "10 min",      "30min1h", "1h1h",
        "PT", "P",    "P15M", "PT15", "T15M", "PT15Mx", "367d", "9999999999s", "1w",      "pt15m"})
    EXPECT_EQ(refusal([&] { parse_duration_s(text); }),
              fmt::format(
                  "step '{}': must be a length of time from 1 s to 366 days, for example 10min, 1h or PT15M",
                  text));
}

TEST(Duration, IsWrittenAsItReads) {
  for (const char* text : {"10min", "1h", "36h", "30s", "90min", "2d", "5405s"}) {
    EXPECT_EQ(format_duration(parse_duration_s(text)), text);
  }
}

TEST(TimeSteps, RunFromTheStartToTheEnd) {
  const auto times = times_of(parse_time_steps("2024-06-21T22:00:30Z/2024-06-22T01:00:30+00:00/1h"));
  ASSERT_EQ(times.size(), 4U);
  EXPECT_EQ(format_time(times[0]), "2024-06-21T22:00:30Z");
  EXPECT_EQ(format_time(times[2]), "2024-06-22T00:00:30Z");
  EXPECT_EQ(format_time(times[3]), "2024-06-22T01:00:30Z");
  // An end that no step falls on is not among them; one moment is a series, too.
  EXPECT_EQ(times_of(parse_time_steps("2024-06-21T22:00Z/2024-06-21T22:59Z/15min")).size(), 4U);
  EXPECT_EQ(times_of(parse_time_steps("2024-06-21T22:00Z/2024-06-21T22:00Z/1d")).size(), 1U);
}

TEST(TimeSteps, CrossLeapDaysAndYears) {
  const auto times = times_of(parse_time_steps("2024-02-27T12:00Z/2024-03-02T12:00Z/P1D"));
  ASSERT_EQ(times.size(), 5U);
  EXPECT_EQ(format_time(times[2]), "2024-02-29T12:00:00Z");
  EXPECT_EQ(format_time(times[3]), "2024-03-01T12:00:00Z");
  // 2016 ended with a leap second, which is not counted: clocks go on showing whole hours.
  const auto new_year = times_of(parse_time_steps("2016-12-31T23:00Z/2017-01-01T01:00Z/1h"));
  EXPECT_EQ(format_time(new_year[1]), "2017-01-01T00:00:00Z");
  EXPECT_EQ(format_time(new_year[2]), "2017-01-01T01:00:00Z");
}

TEST(TimeSteps, ZonesMayDiffer) {
  EXPECT_EQ(times_of(parse_time_steps("2024-06-21T04:00+02:00/2024-06-21T04:00Z/30min")).size(), 5U);
}

TEST(TimeSteps, AreWrittenAsTheyRead) {
  const TimeSteps steps = parse_time_steps("2024-06-21T06:00+02:00/2024-06-21T20:00Z/PT15M");
  EXPECT_EQ(format_time_steps(steps), "2024-06-21T04:00:00Z/2024-06-21T20:00:00Z/15min");
  EXPECT_EQ(parse_time_steps(format_time_steps(steps)), steps);
}

TEST(TimeSteps, RefuseWhatCannotBe) {
  const auto why = [](const std::string& text) {
    const std::string message = refusal([&] { parse_time_steps(text); });
    const std::string prefix = "times '" + text + "': ";
    EXPECT_TRUE(message.starts_with(prefix)) << message;
    return message.substr(prefix.size());
  };
  EXPECT_EQ(why("2024-06-21T04:00Z"),
            "must be START/END/STEP, for example 2024-06-21T04:00Z/2024-06-21T20:00Z/10min");
  EXPECT_EQ(why("2024-06-21T20:00Z/2024-06-21T04:00Z/1h"),
            "end 2024-06-21T04:00:00Z lies before start 2024-06-21T20:00:00Z: must not");
  EXPECT_TRUE(why("2024-06-21T04:00Z/2024-06-21T20:00Z/0min").starts_with("step '0min': must be"));
  EXPECT_TRUE(
      why("2024-06-21T04:00/2024-06-21T20:00Z/1h").starts_with("time '2024-06-21T04:00': has no zone"));
  EXPECT_TRUE(why("2024-06-31T04:00Z/2024-06-21T20:00Z/1h").find("no day") != std::string::npos);
  EXPECT_EQ(why("2024-01-01T00:00Z/2024-01-02T03:46:40Z/1s"), "100001 times: must be at most 100000");
  EXPECT_EQ(times_of(parse_time_steps("2024-01-01T00:00Z/2024-01-02T03:46:39Z/1s")).size(), 100000U);
  EXPECT_TRUE(why("2024-06-21T04:00:00.5Z/2024-06-21T20:00Z/1h").find("must be a whole second") !=
              std::string::npos);
  EXPECT_TRUE(why("2016-12-31T23:59:60Z/2017-06-21T20:00Z/1h").find("no leap second") != std::string::npos);
}

class TimesCsv : public ::testing::Test {
 protected:
  std::filesystem::path file(const char* text) {
    std::ofstream(path_) << text;
    return path_;
  }
  void TearDown() override { std::filesystem::remove(path_); }

 private:
  std::filesystem::path path_ =
      std::filesystem::path(::testing::TempDir()) /
      fmt::format("times_{}.csv", ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(TimesCsv, HoldsTimesInAnyColumn) {
  const auto times =
      read_times_csv(file("name, time\n# noon\na, 2024-06-21T12:00Z\nb, 2024-06-21 14:30:00+02:00\n"));
  ASSERT_EQ(times.size(), 2U);
  EXPECT_EQ(format_time(times[1]), "2024-06-21T12:30:00Z");
}

TEST_F(TimesCsv, SaysWhichLineIsWrong) {
  const std::string message = refusal([&] { read_times_csv(file("time\n2024-06-21T12:00Z\nnoon\n")); });
  EXPECT_NE(message.find("csv:3: time 'noon': is no such time"), std::string::npos) << message;
  EXPECT_NE(refusal([&] { read_times_csv(file("when\n2024-06-21T12:00Z\n")); }).find("no column 'time'"),
            std::string::npos);
  EXPECT_NE(refusal([&] { read_times_csv(file("time\n")); }).find("no rows: must hold one time or more"),
            std::string::npos);
}

}  // namespace
}  // namespace skylut
