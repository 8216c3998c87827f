// The fuzzy matcher: what matches, in which letters, and what comes before what.
#include "core/base/fuzzy.hpp"

#include <algorithm>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "core/base/random.hpp"

namespace replan::fuzzy_test {
namespace {

/// The texts that match, the best first.
std::vector<std::string> ranked(std::string_view pattern, std::vector<std::string> texts) {
  std::vector<std::pair<int, std::string>> found;
  for (const std::string& text : texts)
    if (const auto match = fuzzy_match(pattern, text)) found.emplace_back(match->score, text);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> order;
  for (const auto& [score, text] : found) order.push_back(text);
  return order;
}

/// The text with its matched letters in brackets.
std::string marked(std::string_view pattern, std::string_view text) {
  const auto match = fuzzy_match(pattern, text);
  if (!match) return "";
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool hit = std::find(match->letters.begin(), match->letters.end(), i) != match->letters.end();
    result += hit ? "[" + std::string(1, text[i]) + "]" : std::string(1, text[i]);
  }
  return result;
}

TEST(Fuzzy, MatchesLettersInTheirOrderWhateverTheirCase) {
  EXPECT_TRUE(fuzzy_match("DLD", "dld* lite"));
  EXPECT_TRUE(fuzzy_match("rplan", "Next replan"));
  EXPECT_FALSE(fuzzy_match("nalper", "Next replan"));
  EXPECT_FALSE(fuzzy_match("replans", "Next replan"));
  EXPECT_TRUE(fuzzy_match("open w", "Open a world…"));
}

TEST(Fuzzy, AnEmptyPatternMatchesEverythingAlike) {
  EXPECT_EQ(fuzzy_match("", "anything")->score, 0);
  EXPECT_EQ(fuzzy_match("  ", "")->score, 0);
  EXPECT_FALSE(fuzzy_match("a", ""));
}

TEST(Fuzzy, TakesTheLettersThatAReaderWould) {
  EXPECT_EQ(marked("re", "Previous replan"), "Previous [r][e]plan");
  EXPECT_EQ(marked("now", "Next open world"), "[N]ext [o]pen [w]orld");
  EXPECT_EQ(marked("step", "Shift to the next step"), "Shift to the next [s][t][e][p]");
}

TEST(Fuzzy, RanksBeginningsOfWordsAndLettersInARowFirst) {
  EXPECT_EQ(
      ranked("rec", {"Cursor else counted", "Direct", "Record the canvas…", "Rows every column"}),
      (std::vector<std::string>{"Record the canvas…", "Direct", "Rows every column", "Cursor else counted"}));
  EXPECT_EQ(ranked("fit", {"Profit", "Find it", "Fit the world", "A fit"}),
            (std::vector<std::string>{"Fit the world", "A fit", "Find it", "Profit"}));
  EXPECT_EQ(ranked("undo", {"Sound on", "Undo", "Undo everything at once"}),
            (std::vector<std::string>{"Undo", "Undo everything at once", "Sound on"}));
  EXPECT_EQ(ranked("dl", {"Planner: Dijkstra", "Planner: DLD* Lite", "Planner: D* Lite", "Paddle"}),
            (std::vector<std::string>{"Planner: DLD* Lite", "Planner: D* Lite", "Paddle"}));
}

/// Whether a pattern's letters are in a text in their order, plainly.
bool is_subsequence(std::string_view pattern, std::string_view text) {
  std::size_t next = 0;
  for (const char each : text) next += next < pattern.size() && pattern[next] == each ? 1 : 0;
  return next == pattern.size();
}

TEST(Fuzzy, FindsExactlyTheSubsequencesAndNamesTheirLetters) {
  Random random(7);
  const auto word = [&random](int longest) {
    std::string text;
    for (int n = random.between(1, longest); n > 0; --n) text += "ab -"[random.below(4)];
    return text;
  };
  int matches = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::string text = word(12);
    std::string pattern = word(5);
    std::erase(pattern, ' ');
    const auto match = fuzzy_match(pattern, text);
    ASSERT_EQ(match.has_value(), is_subsequence(pattern, text)) << pattern << " in " << text;
    if (!match) continue;
    ++matches;
    std::string letters;
    for (const std::size_t at : match->letters) letters += text[at];
    ASSERT_EQ(letters, pattern) << "in " << text;
    ASSERT_TRUE(std::adjacent_find(match->letters.begin(), match->letters.end(), std::greater_equal<>()) ==
                match->letters.end());
  }
  EXPECT_GT(matches, 1000);
}

}  // namespace
}  // namespace replan::fuzzy_test
