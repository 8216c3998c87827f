// The Code tab: what just happened, the planner's pseudo-code with the current line lit, and its page.
#include "ui/tabs/code.hpp"

#include <algorithm>
#include <utility>

#include <imgui_internal.h>

#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/conditions.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// The second row of a long line: no number, the same ground.
void continuation(const Look& look, const PseudoLine& line, bool current, ImU32 colour) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, look.px(20));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::Dummy(size);
  ImGui::PopStyleVar();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (current) {
    list.AddRectFilled(origin, {origin.x + size.x, origin.y + size.y}, look.theme.selected);
    list.AddRectFilled(origin, {origin.x + look.px(3), origin.y + size.y}, look.theme.accent);
  }
  draw_text(list, look.fonts.mono,
            {origin.x + look.px(38), origin.y + (size.y - look.fonts.mono->FontSize) * 0.5f}, colour,
            line.text);
}

void pseudo_line(Frame& frame, const PseudoLine& line, bool current) {
  const Look& look = frame.look;
  if (line.number == 0) {
    continuation(look, line, current, current ? look.theme.text : look.theme.dim);
    return;
  }
  const std::string condition = when_line(line.number);
  const bool set = find_breakpoint(frame.session, condition).has_value();
  if (code_line(look, {line.number, line.text, current, set}))
    frame.commands.push_back(toggle_breakpoint(frame.session, condition));
  if (ImGui::GetIO().MousePos.x < ImGui::GetItemRectMin().x + look.px(34))
    hint(look, {set ? "Remove the breakpoint" : "Set a breakpoint", "",
                set ? "The playhead no longer stops on this line."
                    : "The playhead stops whenever the planner comes to this line."});
}

void what_happened(Frame& frame) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const std::size_t cursor = run.timeline().cursor();
  section_title(look, cursor == 0 ? "Nothing has happened yet"
                                  : "Event " + grouped(cursor) + " of " + grouped(run.timeline().size()));
  if (cursor == 0)
    paragraph(look.fonts.ui, look.theme.dim,
              "Press " + action(ActionId::line_forward).keys + " to take the first line.");
  else
    paragraph(look.fonts.mono, look.theme.text, last_event_text(run));
}

void draw_section(const Look& look, const PageSection& section) {
  section_title(look, section.title);
  for (const std::string& each : section.paragraphs) marked_paragraph(look, look.theme.dim, each);
  section_rule(look);
}

/// Of the block's lines, which no other block's have: " (lines 101 to 119)".
std::string numbers_of(const PseudoBlock& block) {
  int first = 0, last = 0;
  for (const PseudoLine& line : block.lines) {
    if (line.number == 0) continue;
    if (first == 0) first = line.number;
    last = line.number;
  }
  return first == 0 ? "" : " (lines " + std::to_string(first) + " to " + std::to_string(last) + ")";
}

/// All of the code, behind what there is to say of its numbers; `scrolled` as in draw_pseudo_code().
void draw_code(Frame& frame, const PlannerPage& page, int& scrolled) {
  if (const PageSection* about = page.section("Pseudo-code"))
    for (const std::string& each : about->paragraphs)
      marked_paragraph(frame.look, frame.look.theme.dim, each);
  for (const PseudoBlock& block : page.code) {
    const std::string numbers = numbers_of(block);
    const bool fits =
        text_width(frame.look.fonts.section, block.title + numbers) <= ImGui::GetContentRegionAvail().x;
    section_title(frame.look, fits ? block.title + numbers : block.title);
    if (!fits) section_title(frame.look, numbers);
    draw_pseudo_code(frame, block, 0, &scrolled);
    section_rule(frame.look);
  }
}

/// Where the page goes on beyond its edge the lines there fade, in place of being cut in two.
void fade_edges(const Look& look) {
  const ImRect seen = ImGui::GetCurrentWindow()->InnerClipRect;
  const float high = look.px(24);
  const ImU32 ground = look.theme.panel, none = with_alpha(ground, 0);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::GetScrollY() > 0)
    list.AddRectFilledMultiColor(seen.Min, {seen.Max.x, seen.Min.y + high}, ground, ground, none, none);
  if (ImGui::GetScrollY() < ImGui::GetScrollMaxY())
    list.AddRectFilledMultiColor({seen.Min.x, seen.Max.y - high}, seen.Max, none, none, ground, ground);
}

class CodeTab final : public SideTab {
 public:
  void draw(Frame& frame) override;
  void show_page() { to_top_ = true; }

 private:
  int scrolled_ = 0;     // the line that the page was scrolled to
  bool to_top_ = false;  // the page is to be shown from its beginning
  std::string shown_;    // whose page it was
};

}  // namespace

void draw_pseudo_code(Frame& frame, const PseudoBlock& block, int around, int* scrolled) {
  const int current = current_line(frame.run());
  std::size_t first = 0, last = block.lines.size();
  if (around > 0) {
    const auto at = std::find_if(block.lines.begin(), block.lines.end(),
                                 [&](const PseudoLine& l) { return l.number == current; });
    const auto middle = static_cast<std::size_t>(at - block.lines.begin());
    const auto reach = static_cast<std::size_t>(around);
    last = std::min(std::max(middle + reach + 1, 2 * reach + 1), block.lines.size());
    first = last > 2 * reach + 1 ? last - 2 * reach - 1 : 0;
  }
  int number = 0;
  ImGui::PushID(block.title.c_str());
  for (std::size_t i = first; i < last; ++i) {
    const PseudoLine& line = block.lines[i];
    if (line.number != 0) number = line.number;
    const bool lit = number == current && number != 0;
    pseudo_line(frame, line, lit);
    if (scrolled != nullptr && lit && line.number != 0 && *scrolled != current) {
      const ImRect seen = ImGui::GetCurrentWindow()->InnerClipRect;
      if (ImGui::GetItemRectMin().y < seen.Min.y || ImGui::GetItemRectMax().y > seen.Max.y)
        ImGui::SetScrollHereY(0.4f);
      *scrolled = current;
    }
  }
  ImGui::PopID();
}

void CodeTab::draw(Frame& frame) {
  const Look& look = frame.look;
  const std::string shown = page_name(frame.run());
  if (std::exchange(shown_, shown) != shown) to_top_ = true;
  const Result<PlannerPage>& page = page_of(frame.panels, frame.run());
  if (!page) {
    empty_state(look, icon::book, "This planner's page is missing", page.error());
    return;
  }
  what_happened(frame);
  ImGui::Dummy({0, look.px.xs});
  // The page scrolls under what happened, which stays in sight.
  // Its scroll bar stands in the padding, so that it takes no room from the code.
  ImGui::BeginChild("page", {ImGui::GetContentRegionAvail().x + look.px(12), 0});
  if (std::exchange(to_top_, false)) {
    ImGui::SetScrollY(0);
    scrolled_ = current_line(frame.run());
  }
  // What is behind the code before the code: who understands the idea can read it.
  const PageSection* idea = page->section("Idea");
  if (idea != nullptr) draw_section(look, *idea);
  draw_code(frame, *page, scrolled_);
  for (const PageSection& section : page->sections)
    if (&section != idea && section.title != "Pseudo-code") draw_section(look, section);
  fade_edges(look);
  ImGui::EndChild();
}

void show_page(ViewState& view, PanelState& panels) {
  show_tab(view, panels, "code");
  panels.tabs.get<CodeTab>().show_page();
}

TabKind code_tab() {
  return {.name = "Code",
          .label = "Code",
          .icon = icon::code,
          .chord = fn(5),
          .teach =
              "The planner's idea, its pseudo-code with the line that runs, its limits and its source. A "
              "click beside a "
              "line sets a breakpoint.",
          .make = make_part<SideTab, CodeTab>};
}

}  // namespace replan::ui
