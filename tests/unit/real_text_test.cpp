// Numbers as text: by C alone as by the standard library, and back to the same bits, whatever the system's language.
#include "core/base/real_text.hpp"

#include <bit>
#include <charconv>
#include <clocale>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/random.hpp"

namespace replan::real_text_test {
namespace {

std::vector<double> many_numbers() {
  std::vector<double> all = {0.0,
                             -0.0,
                             0.1,
                             0.5,
                             1.0,
                             1.5,
                             100,
                             1e5,
                             123456,
                             1e15,
                             1e16,
                             1e17,
                             1e20,
                             1e21,
                             1e22,
                             1e23,
                             0.001,
                             0.0001,
                             0.00001,
                             1e-7,
                             5e-324,
                             2.2250738585072014e-308,
                             1.7976931348623157e308,
                             9007199254740993.0,
                             9.5e-5,
                             123456789012345680000.0,
                             0.3,
                             2.0 / 3,
                             1.4142135623730951};
  for (int power = -1074; power < 1024; ++power) all.push_back(std::ldexp(1.0, power));
  for (int power = -323; power < 309; ++power)
    all.push_back(std::strtod(("1e" + std::to_string(power)).c_str(), nullptr));
  Random random(7);
  for (int i = 0; i < 20'000; ++i) {
    const double any = std::bit_cast<double>(random.next());
    if (std::isfinite(any)) all.push_back(any);
    all.push_back(static_cast<double>(random.below(1'000'000)) / 1000);
    all.push_back(static_cast<double>(random.below(1'000'000'000)));
  }
  for (std::size_t i = 0, count = all.size(); i < count; ++i) all.push_back(-all[i]);
  return all;
}

TEST(RealText, IsWhatTheStandardLibraryWrites) {
  for (const double number : many_numbers()) {
    char text[400];
    const std::string right(text, std::to_chars(text, text + sizeof text, number).ptr);
    ASSERT_EQ(plain::real_text(number), right);
    ASSERT_EQ(real_text(number), right);
    for (const auto& read : {plain::take_real, take_real}) {
      std::string_view rest = right;
      const auto back = read(rest);
      ASSERT_TRUE(back) << right;
      ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(number)) << right;
      ASSERT_TRUE(rest.empty()) << right;
    }
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& write : {plain::real_text, real_text}) {
    EXPECT_EQ(write(infinity), "inf");
    EXPECT_EQ(write(-infinity), "-inf");
    EXPECT_EQ(write(std::nan("")), "nan");
  }
}

TEST(RealText, ReadsWhatTheStandardLibraryReads) {
  for (const std::string_view text :
       {"1",        "1.5",      "1.",
        ".5",       "-.5e1",    "1e5",
        "1e+5",     "1E-5",     "1e",
        "1e+",      "1ex",      "1.5.5",
        "1,5",      "+1",       " 1",
        "",         "-",        ".",
        "-.",       "e5",       "0x10",
        "inf",      "-inf",     "infinity",
        "INF",      "Infinite", "nan",
        "NaN",      "1e400",    "-1e400",
        "1e-400",   "0e-400",   "0.0e400",
        "4.9e-324", "2.4e-324", "123456789012345678901234567890",
        "007",      "1 2",      "12abc",
        "-0",       "1e0005",   "0.1000000000000000055511151231257827021181583404541015625"}) {
    double right = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), right);
    const bool is_number = failed == std::errc{};
    for (const auto& read : {plain::take_real, take_real}) {
      std::string_view rest = text;
      const auto number = read(rest);
      ASSERT_EQ(number.has_value(), is_number) << text;
      if (!number) {
        EXPECT_EQ(rest, text);
        continue;
      }
      EXPECT_EQ(rest.data(), end) << text;
      EXPECT_TRUE(std::isnan(right) ? std::isnan(*number) : *number == right) << text;
    }
  }
  EXPECT_EQ(real_from("2.5"), 2.5);
  EXPECT_FALSE(real_from("2.5 "));
  EXPECT_FALSE(real_from(""));
}

TEST(RealText, IsTheSameInLanguagesWithADecimalComma) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const char* set = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"})
    if (set == nullptr) set = std::setlocale(LC_ALL, name);
  std::string_view text = "2.5";
  EXPECT_EQ(plain::real_text(0.25), "0.25");
  EXPECT_EQ(plain::real_text(1e-300), "1e-300");
  EXPECT_EQ(plain::take_real(text), 2.5);
  EXPECT_TRUE(text.empty());
  std::setlocale(LC_ALL, before.c_str());
  if (set == nullptr) GTEST_SKIP() << "no language with a decimal comma is installed: this was the usual one";
}

}  // namespace
}  // namespace replan::real_text_test
