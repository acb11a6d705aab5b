#include <gtest/gtest.h>

#include <limits>

#include "options/choice_list.hpp"
#include "options/file_kinds.hpp"
#include "options/number_kinds.hpp"

namespace skylut::cli {
namespace {

const Range kAltitude{0.0, 30.0, "km"};

std::string refusal(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

TEST(ChoiceList, HoldsNamesOnceEach) {
  const Kind<std::vector<int>> kind = choice_list(choice<int>({{"rgb", 1}, {"xyz", 2}, {"spectral", 3}}));
  EXPECT_EQ(kind.read("rgb,spectral"), (std::vector{1, 3}));
  EXPECT_EQ(kind.read(" xyz , rgb"), (std::vector{2, 1}));
  EXPECT_EQ(kind.write({3, 1}), "spectral,rgb");
  for (const char* text : {"", "rgb,", "RGB", "rgb xyz", "hsv"}) EXPECT_THROW(kind.read(text), InputError);
  EXPECT_EQ(refusal([&] { kind.read("rgb,spectrall"); }),
            "must be rgb, xyz or spectral, did you mean spectral?");
  EXPECT_EQ(refusal([&] { kind.read("rgb,rgb"); }), "must have rgb once, not twice");
}

TEST(Number, IsReadAsPeopleTypeIt) {
  const Kind<double> kind = number({-1e6, 1e6, ""});
  EXPECT_EQ(kind.read("5"), 5.0);
  EXPECT_EQ(kind.read("+5"), 5.0);
  EXPECT_EQ(kind.read("1e3"), 1000.0);
  EXPECT_EQ(kind.read(" 2.5 "), 2.5);
  EXPECT_EQ(kind.read("-.5"), -0.5);
}

TEST(Number, RefusesWhatIsNone) {
  for (const char* text : {"", " ", "nan", "inf", "-inf", "6km", "1,5", "0x10", "+-5", "++5", "1e999", "--5"})
    EXPECT_EQ(refusal([&] { number(kAltitude).read(text); }), "must be a number within 0 to 30 km") << text;
}

TEST(Number, TakesOneSign) {
  EXPECT_NE(refusal([] { number({-10.0, 10.0, ""}).read("+-5"); }), "read");
}

TEST(Number, BothLimitsBelongToTheRange) {
  EXPECT_EQ(number(kAltitude).read("0"), 0.0);
  EXPECT_EQ(number(kAltitude).read("30"), 30.0);
  EXPECT_NE(refusal([&] { number(kAltitude).read("30.000001"); }), "read");
  EXPECT_NE(refusal([&] { number(kAltitude).read("-1e-300"); }), "read");
}

TEST(Number, ReadsBackAsTheSame) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, 123456789.123456789, std::numeric_limits<double>::max()})
    EXPECT_EQ(number({-value, value, ""}).read(written(value)), value);
}

TEST(WholeNumber, TakesNoFractionAndNothingBeyondItsLimits) {
  const auto kind = whole_number({1.0, 1024.0, ""});
  EXPECT_EQ(kind.read("1e3"), 1000);
  EXPECT_EQ(kind.read("+7"), 7);
  for (const char* text : {"0", "1025", "1.5", "-5", "99999999999999999999", "nan", "", "seven"})
    EXPECT_EQ(refusal([&] { kind.read(text); }), "must be a whole number within 1 to 1024") << text;
}

TEST(WholeNumber, LargeOnesAreExact) {
  EXPECT_EQ(whole_number(domain::kSeed).read("9007199254740991"), 9007199254740991);
  EXPECT_EQ(whole_number(domain::kSeed).write(9007199254740991), "9007199254740991");
}

TEST(Numbers, MayHaveBlanks) {
  EXPECT_EQ(numbers(kAltitude).read("0, 6 ,12"), (std::vector<double>{0.0, 6.0, 12.0}));
  EXPECT_EQ(numbers(kAltitude).write({0.0, 6.5, 12.0}), "0,6.5,12");
}

TEST(Numbers, SayWhichIsWrong) {
  EXPECT_EQ(refusal([&] { numbers(kAltitude).read("0,31"); }), "31 must lie within 0 to 30 km");
  EXPECT_EQ(refusal([&] { numbers(kAltitude).read("0,,6"); }), "'' must be a number within 0 to 30 km");
  EXPECT_EQ(refusal([&] { numbers(kAltitude).read("0,6,"); }), "'' must be a number within 0 to 30 km");
  EXPECT_EQ(refusal([&] { numbers(kAltitude).read(""); }), "must be a number within 0 to 30 km");
}

TEST(NumbersOrSteps, RunUpwardsInWholeSteps) {
  const auto kind = numbers_or_steps({0.0, 180.0, "deg"}, 10);
  EXPECT_EQ(kind.read("0:180:90"), (std::vector<double>{0.0, 90.0, 180.0}));
  EXPECT_EQ(kind.read("10,20"), (std::vector<double>{10.0, 20.0}));
  EXPECT_EQ(kind.read("5:5:1"), (std::vector<double>{5.0}));
  for (const char* text : {"0:10:3", "10:0:1", "0:180:0", "0:180:1", "0:190:10", "0:10", "0:nan:1"})
    EXPECT_NE(refusal([&] { kind.read(text); }), "read") << text;
}

TEST(NamedNumbers, AreReadAndWritten) {
  const auto kind = named_numbers();
  EXPECT_EQ(kind.write(kind.read("optical-step=0.01, tolerance=1e-5")), "optical-step=0.01,tolerance=1e-05");
  for (const char* text : {"", "optical-step", "=1", "a=b", "a=1=2", "a=nan"})
    EXPECT_NE(refusal([&] { kind.read(text); }), "read") << text;
}

TEST(Choice, KnowsItsNames) {
  const auto kind = choice<int>({{"draft", 1}, {"default", 2}, {"reference", 3}});
  EXPECT_EQ(kind.read("default"), 2);
  EXPECT_EQ(kind.write(3), "reference");
  EXPECT_EQ(refusal([&] { kind.read("best"); }), "must be draft, default or reference");
  EXPECT_EQ(refusal([&] { kind.read("refrence"); }),
            "must be draft, default or reference, did you mean reference?");
}

TEST(FileNamed, KnowsEndingsInAnyCase) {
  const auto kind = file_named({".csv", ".exr"});
  EXPECT_EQ(kind.read("SKY.EXR"), "SKY.EXR");
  EXPECT_EQ(ending_of("SKY.EXR"), ".exr");
  EXPECT_EQ(refusal([&] { kind.read("sky.png"); }), "must be the name of a .csv or .exr file");
  EXPECT_EQ(refusal([&] { kind.read(""); }), "must be the name of a file");
}

TEST(FileOut, IsRefusedWhereItCannotBeWritten) {
  EXPECT_EQ(refusal([&] { file_out().read("missing-folder/file"); }), "no such folder: missing-folder");
  EXPECT_EQ(refusal([&] { file_out().read("/"); }), "is a directory, must be the name of a file");
  EXPECT_EQ(file_out().read("-"), "-");
}

}  // namespace
}  // namespace skylut::cli
