// Tooltips out of the glossary.
#pragma once

#include <string_view>

#include "core/plan/glossary.hpp"
#include "ui/widgets.hpp"

namespace replan::ui {

/// The tooltip of a word of the glossary, by its id or as it is written ("U"); empty if there is none.
inline Hint term_hint(std::string_view id) {
  const GlossaryTerm* term = find_term(id);
  return term == nullptr ? Hint{} : Hint{term->title.data(), "", term->text.data()};
}

}  // namespace replan::ui
