#include "core/base/fuzzy.hpp"

#include <algorithm>
#include <string>

namespace replan {
namespace {

// Weights: a word's first letter is worth more than any one gap costs, and letters in a row more than as many
// words' first letters two apart.
constexpr int kLetter = 10, kWordStart = 16, kTextStart = 6, kInARow = 18, kGap = 3, kLargestGap = 12;
constexpr int kImpossible = -1'000'000;

char folded(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool is_word_letter(char letter) {
  const char low = folded(letter);
  // Bytes above 127 belong to letters of other scripts.
  return (low >= 'a' && low <= 'z') || (low >= '0' && low <= '9') || static_cast<unsigned char>(low) > 127;
}

/// What it is worth to match a letter where it stands.
int worth_of(std::string_view text, std::size_t at) {
  const bool starts_word = is_word_letter(text[at]) && (at == 0 || !is_word_letter(text[at - 1]));
  return kLetter + (starts_word ? kWordStart : 0) + (at == 0 ? kTextStart : 0);
}

/// The best scores of a pattern's beginning, by where its last letter is matched, and where the letter before
/// that is.
struct Row {
  std::vector<int> score;
  std::vector<std::size_t> from;
};

Row first_row(char letter, std::string_view text) {
  Row row{std::vector(text.size(), kImpossible), std::vector<std::size_t>(text.size())};
  for (std::size_t t = 0; t < text.size(); ++t)
    if (folded(text[t]) == letter)
      row.score[t] = worth_of(text, t) - std::min(kLargestGap, kGap * static_cast<int>(t));
  return row;
}

Row next_row(const Row& before, char letter, std::string_view text) {
  Row row{std::vector(text.size(), kImpossible), std::vector<std::size_t>(text.size())};
  for (std::size_t t = 1; t < text.size(); ++t) {
    if (folded(text[t]) != letter) continue;
    for (std::size_t f = 0; f < t; ++f) {
      if (before.score[f] == kImpossible) continue;
      const int gap = static_cast<int>(t - f) - 1;
      const int score =
          before.score[f] + worth_of(text, t) + (gap == 0 ? kInARow : -std::min(kLargestGap, kGap * gap));
      if (score > row.score[t]) {
        row.score[t] = score;
        row.from[t] = f;
      }
    }
  }
  return row;
}

}  // namespace

std::optional<FuzzyMatch> fuzzy_match(std::string_view pattern, std::string_view text) {
  std::string letters;
  for (const char each : pattern)
    if (each != ' ') letters += folded(each);
  if (letters.empty()) return FuzzyMatch{};
  if (letters.size() > text.size()) return std::nullopt;
  std::vector<Row> rows = {first_row(letters.front(), text)};
  for (std::size_t i = 1; i < letters.size(); ++i) rows.push_back(next_row(rows.back(), letters[i], text));
  const auto best = std::max_element(rows.back().score.begin(), rows.back().score.end());
  if (*best == kImpossible) return std::nullopt;
  FuzzyMatch match{*best - static_cast<int>(std::min<std::size_t>(text.size(), 60) / 4), {}};
  auto at = static_cast<std::size_t>(best - rows.back().score.begin());
  for (std::size_t i = rows.size(); i-- > 0; at = rows[i].from[at]) match.letters.push_back(at);
  std::reverse(match.letters.begin(), match.letters.end());
  return match;
}

}  // namespace replan
