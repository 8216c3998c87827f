// The field's words, each explained once. Tooltips, `replan list terms` and the panels all read them here.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace replan {

/// One word. The texts end in a NUL, so that tooltips can take data().
struct GlossaryTerm {
  std::string_view id;     ///< as find_term() takes it: "rhs", "open-list"
  std::string_view title;  ///< as a heading: "rhs", "Open list"
  std::string_view text;   ///< one to three plain sentences for somebody who meets it for the first time
};

/// All words, those that belong together side by side.
std::span<const GlossaryTerm> glossary();

/// The word with that id, or that is also written so ("U", "|U|", "in U": the open list). nullptr if there is
/// none.
const GlossaryTerm* find_term(std::string_view id);

/// The words that what was typed can mean: the one that is written so, then those whose title has it, then those whose
/// explanation has it; whether letters are capitals does not matter. Nothing typed: all words.
std::vector<const GlossaryTerm*> search_glossary(std::string_view typed);

}  // namespace replan
