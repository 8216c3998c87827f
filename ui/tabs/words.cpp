#include "ui/tabs/words.hpp"

#include "core/plan/glossary.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// One word and its explanation, on a ground of its own if it was asked for.
void draw_term(const Look& look, const GlossaryTerm& term, bool lit) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  list.ChannelsSplit(2);
  list.ChannelsSetCurrent(1);
  text(look.fonts.title, lit ? look.theme.accent : look.theme.text, term.title);
  paragraph(look.fonts.ui, look.theme.dim, term.text);
  list.ChannelsSetCurrent(0);
  const ImVec2 end(begin.x + width + look.px.s, ImGui::GetItemRectMax().y + look.px.xs);
  if (lit)
    list.AddRectFilled({begin.x - look.px.s, begin.y - look.px.xs}, end, look.theme.selected, look.px.radius);
  list.ChannelsMerge();
  ImGui::Dummy({0, look.px.xs});
}

}  // namespace

void WordsTab::show_word(std::string_view id) {
  typed_.clear();
  lit_ = id;
  reveal_ = true;
}

void WordsTab::draw(Frame& frame) {
  const Look& look = frame.look;
  search_box(look, "##word", "Search the words", "", typed_, ImGui::GetContentRegionAvail().x);
  ImGui::Dummy({0, look.px.xs});
  const std::vector<const GlossaryTerm*> found = search_glossary(typed_);
  if (found.empty()) {
    empty_state(look, icon::book, "No such word", "Fewer letters find more.");
    return;
  }
  // The words scroll under the field, which stays in sight.
  ImGui::BeginChild("words", {0, 0});
  for (const GlossaryTerm* term : found) {
    const bool lit = term->id == lit_;
    if (lit && reveal_) ImGui::SetScrollHereY(0.1f);
    draw_term(look, *term, lit);
  }
  if (reveal_) frame.panels.animated = true;  // it scrolls in the next frame
  reveal_ = false;
  ImGui::EndChild();
}

void show_word(ViewState& view, PanelState& panels, std::string_view id) {
  show_glossary(view, panels);
  panels.tabs.get<WordsTab>().show_word(id);
}

void show_glossary(ViewState& view, PanelState& panels) {
  show_tab(view, panels, "words");
}

TabKind words_tab() {
  return {.name = "Words",
          .label = "Words",
          .icon = icon::book,
          .chord = fn(9),
          .teach =
              "The glossary: what g, rhs, km and the other words of the window mean. It stays open while you "
              "work.",
          .make = make_part<SideTab, WordsTab>,
          .per_pane = false};
}

}  // namespace replan::ui
