// Finds what was typed in a text, with letters left out: "dld" in "DLD* Lite", "exw" in "Example worlds…".
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace replan {

struct FuzzyMatch {
  int score = 0;                     ///< the higher the better, between texts too
  std::vector<std::size_t> letters;  ///< which bytes of the text were matched, in order
};

/// The best way to read `pattern` as letters of `text` in their order; nothing if there is none. Case does
/// not matter, nor do spaces in the pattern. What counts: letters at the beginnings of words, letters beside
/// each other, few letters left out, short texts. Every text matches an empty pattern, with score 0.
std::optional<FuzzyMatch> fuzzy_match(std::string_view pattern, std::string_view text);

}  // namespace replan
