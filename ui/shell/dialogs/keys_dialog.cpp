// All keys on one page, from the table of actions; what the mouse does; and what the canvas' marks mean.
#include <algorithm>
#include <array>
#include <vector>

#include "ui/canvas_chips.hpp"
#include "ui/keys.hpp"
#include "ui/shell/actions.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"

namespace replan::ui {
namespace {

struct Line {
  std::string keys, words;
};
struct Section {
  const char* title;
  std::vector<Line> lines;
};

constexpr std::array<std::pair<Menu, const char*>, 9> kMenus = {{{Menu::planner, "Play and step"},
                                                                 {Menu::debug, "Debug"},
                                                                 {Menu::view, "View"},
                                                                 {Menu::overlays, "Overlays"},
                                                                 {Menu::edit, "Edit and tools"},
                                                                 {Menu::world, "World"},
                                                                 {Menu::file, "File"},
                                                                 {Menu::record, "Record"},
                                                                 {Menu::help, "Help"}}};

std::vector<Section> sections() {
  std::vector<Section> all;
  for (const auto& [menu, title] : kMenus) {
    Section& section = all.emplace_back(Section{title, {}});
    for (const Action& each : actions())
      if (each.menu == menu && !each.keys.empty()) section.lines.push_back({each.keys, each.label});
    if (section.lines.empty()) all.pop_back();
  }
  all.push_back({"On the canvas",
                 {{"Wheel", "Zoom to the cursor"},
                  {"Middle drag", "Pan; Space and drag too"},
                  {"Hover", "Show a cell's values"},
                  {"Click", "Use the tool; Select pins"},
                  {"Right drag", "Erase"},
                  {"Shift+Right", "Menu of the cell"},
                  {"Drag", "Start, goal and robot move"},
                  {"Title", "Lead; choose the planner"}}});
  return all;
}

float line_height(const Look& look) {
  return look.px(22);
}
float title_height(const Look& look) {
  return look.px(30);
}

void draw_line(const Look& look, ImVec2 at, const Line& line, float width) {
  const float keys = text_width(look.fonts.small, line.keys) + look.px(14);
  ImGui::SetCursorScreenPos({at.x + width - keys, at.y});
  key_chip(look, line.keys.c_str());
  draw_text(*ImGui::GetWindowDrawList(), look.fonts.ui, {at.x, at.y + look.px(1)}, look.theme.text,
            elide(look.fonts.ui, line.words, width - keys - look.px.xs));
}

/// All lines in columns of about equal height. A section that does not fit goes on in the next column.
void draw_sections(const Look& look, std::size_t columns) {
  const std::vector<Section> all = sections();
  const float gap = look.px(28), line = line_height(look), title = title_height(look);
  const float whole = ImGui::GetContentRegionAvail().x;
  const float width = (whole - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  float total = 0;
  for (const Section& section : all) total += title + line * static_cast<float>(section.lines.size());
  const float height = total / static_cast<float>(columns) + title;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImVec2 at = origin;
  float foot = origin.y;
  const auto make_room = [&](float needed) {
    if (at.y + needed <= origin.y + height) return;
    at = {at.x + width + gap, origin.y};
  };
  for (const Section& section : all) {
    make_room(title + 2 * line);
    if (at.y > origin.y) at.y += look.px.s;
    draw_text(*ImGui::GetWindowDrawList(), look.fonts.title, at, look.theme.dim, section.title);
    at.y += title - look.px.s;
    for (const Line& each : section.lines) {
      make_room(line);
      draw_line(look, at, each, width);
      at.y += line;
      foot = std::max(foot, at.y);
    }
  }
  ImGui::SetCursorScreenPos(origin);
  ImGui::Dummy({whole, foot - origin.y});
}

/// The marks of the canvas with their names, in rows.
void draw_signs(const Look& look) {
  section_title(look, "Colours and marks on the canvas");
  const std::vector<LegendEntry> signs = all_signs(look);
  const float room = ImGui::GetContentRegionAvail().x;
  const auto width_of = [&](const LegendEntry& each) {
    return look.px(42) + text_width(look.fonts.ui, each.label);
  };
  for (std::size_t first = 0; first < signs.size();) {
    float used = look.px(20);
    std::size_t end = first;
    while (end < signs.size() && used + width_of(signs[end]) <= room) used += width_of(signs[end++]);
    end = std::max(end, first + 1);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size = legend(look, *ImGui::GetWindowDrawList(), at, LegendField{},
                               std::span(signs).subspan(first, end - first), Corner::top_left);
    ImGui::Dummy({room, size.y});
    first = end;
  }
  paragraph(look.fonts.ui, look.theme.dim,
            "Fields go from dark violet (least) to yellow (most); the legend on the canvas has their range.");
}

}  // namespace

Decision Dialogs::keys_dialog(const Look& look) {
  heading(look, "Keys and legend");
  const float whole = ImGui::GetContentRegionAvail().x;
  const float tallest = ImGui::GetIO().DisplaySize.y - look.px(32 + 40 + 40 + 52);
  const std::size_t columns = whole > look.px(1080)  ? 4
                              : whole > look.px(680) ? 3
                              : whole > look.px(440) ? 2
                                                     : 1;
  ImGui::BeginChild("page", {0, std::min(tallest, page_height_)});
  const float top = ImGui::GetCursorPosY();
  draw_sections(look, columns);
  draw_signs(look);
  page_height_ = ImGui::GetCursorPosY() - top;
  ImGui::EndChild();
  align_right(button_width(look, "Close"));
  const bool closed = button(look, "Close", ButtonKind::plain) || escape_pressed() || enter_pressed() ||
                      (!fresh_ && ImGui::IsKeyPressed(key::kF1, false));
  return closed ? Decision{.kind = Decision::Kind::cancel} : Decision{};
}

}  // namespace replan::ui
