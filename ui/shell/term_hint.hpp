// Tooltips out of the glossary.
#pragma once

#include <string_view>

#include "core/plan/glossary.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// The tooltip of a word of the glossary, by its id or as it is written ("U"); empty if there is none.
inline Hint term_hint(std::string_view id) {
  const GlossaryTerm* term = find_term(id);
  return term == nullptr ? Hint{} : Hint{term->title.data(), "", term->text.data()};
}

/// The head of a table whose columns are called by words of the glossary, each with its tooltip.
inline void table_head(const Look& look, std::span<const Column> columns) {
  if (const int at = table_header(look, columns); at >= 0)
    hint(look, term_hint(columns[static_cast<std::size_t>(at)].name));
}

}  // namespace replan::ui
