// All keys on one page, from the table of actions; what the mouse does; and what the canvas' marks mean.
#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

#include "ui/canvas/legend.hpp"
#include "ui/keys.hpp"
#include "ui/shell/actions.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/menus.hpp"

namespace replan::ui {

std::string words_on_keys_page(const std::string& label, const StepWords& step) {
  const StepWords& usual = kExpansionWords;
  for (const auto& [words, own] : {std::pair{usual.next, step.next},
                                   {usual.previous, step.previous},
                                   {usual.next_ten, step.next_ten},
                                   {usual.previous_ten, step.previous_ten}})
    if (label == words) return std::string(own);
  return label;
}

namespace {

struct Line {
  std::string keys, words;
};
struct Section {
  const char* title;
  std::vector<Line> lines;
};

/// In an order of its own: first what is used most.
constexpr std::array kMenus = {Menu::run,  Menu::debug, Menu::view,   Menu::move, Menu::slice,
                               Menu::tabs, Menu::panes, Menu::pin,    Menu::size, Menu::file,
                               Menu::edit, Menu::world, Menu::record, Menu::help, Menu::overlays};

/// `fingers`: whether it is they that press.
std::vector<Section> sections(const StepWords& step, bool fingers) {
  std::vector<Section> all;
  if (fingers)
    all.push_back({"With fingers",
                   {{"Tap", "Press; on the world use the tool"},
                    {"Drag", "Draw, erase, or move what lies there"},
                    {"Two fingers", "Move and zoom the world"},
                    {"Long press", "Menu of the cell"},
                    {"Drag in a panel", "Scroll it"}}});
  for (const Menu menu : kMenus) {
    Section& section = all.emplace_back(Section{menu_kind(menu).name, {}});
    for (const Action& each : actions())
      if (each.menu == menu && !each.keys.empty())
        section.lines.push_back({each.keys, words_on_keys_page(each.label, step)});
    if (section.lines.empty()) all.pop_back();
  }
  all.push_back({"On the canvas",
                 {{"Wheel", "Zoom to the cursor; nearer in 3D"},
                  {"Shift+Wheel", "Move the slice of layers"},
                  {"Drag in 3D", "Turn the world; a click pins"},
                  {"Right drag in 3D", "Move it; the middle button too"},
                  {"Middle drag", "Pan; Space and drag too"},
                  {"Hover", "Show a cell's values"},
                  {"Click", "Use the tool; Select pins"},
                  {"Right click", "Menu of the cell"},
                  {"Right drag", "Erase, with a tool that draws"},
                  {"Shift+Right click", "Menu of the cell, with any tool"},
                  {"Drag", "Start, goal and robot move"},
                  {"Click the title", "Make the pane lead, choose its planner"},
                  {"Click the card", "Show the last repair"},
                  {"Click the legend", "Explain an entry"}}});
  all.push_back({"By the keyboard alone",
                 {{"Tab", "To the next control"},
                  {"Shift+Tab", "To the one before"},
                  {"Space", "Press it"},
                  {"← →", "Change the playing speed there"},
                  {"Enter", "End a number; else the dialog's button"},
                  {"Esc", "Return to the canvas"}}});
  return all;
}

/// From one column to the next, at least.
constexpr float kColumn = 264;

float column_gap(const Look& look) {
  return look.px(28);
}
float line_height(const Look& look) {
  return look.px(20);
}
float title_height(const Look& look) {
  return look.px(30);
}

/// The parts of a line of words, one below the other where they do not stand beside its keys.
std::vector<std::string_view> rows_of(const Look& look, const Line& line, float width) {
  const float room = width - text_width(look.fonts.small, line.keys) - look.px(18);
  std::vector<std::string_view> rows;
  for (std::string_view rest = line.words; !rest.empty();) {
    const char* cut = look.fonts.ui->CalcWordWrapPositionA(1.0f, rest.data(), rest.data() + rest.size(),
                                                           std::max(room, 1.0f));
    const auto length = std::max<std::size_t>(static_cast<std::size_t>(cut - rest.data()), 1);
    rows.push_back(rest.substr(0, length));
    rest.remove_prefix(std::min(rest.find_first_not_of(' ', length), rest.size()));
  }
  return rows;
}

/// Returns how high it is.
float draw_line(const Look& look, ImVec2 at, const Line& line, float width) {
  const float keys = text_width(look.fonts.small, line.keys) + look.px(14);
  ImGui::SetCursorScreenPos({at.x + width - keys, at.y});
  key_chip(look, line.keys.c_str());
  float y = at.y;
  for (const std::string_view row : rows_of(look, line, width)) {
    draw_text(*ImGui::GetWindowDrawList(), look.fonts.ui, {at.x, y + look.px(1)}, look.theme.text, row);
    y += line_height(look);
  }
  return y - at.y;
}

float section_height(const Look& look, const Section& section, float width) {
  float height = title_height(look);
  for (const Line& line : section.lines)
    height += line_height(look) * static_cast<float>(rows_of(look, line, width).size());
  return height;
}

/// How many columns of that height the sections fill, each whole and in their order.
std::size_t columns_needed(std::span<const float> heights, float height) {
  std::size_t columns = 1;
  float used = 0;
  for (const float each : heights) {
    if (used > 0 && used + each > height) {
      ++columns;
      used = 0;
    }
    used += each;
  }
  return columns;
}

/// The least height at which they fill no more than that many columns: it is that of some run of sections.
float column_height(std::span<const float> heights, std::size_t columns) {
  float least = std::accumulate(heights.begin(), heights.end(), 0.0f);
  for (std::size_t first = 0; first < heights.size(); ++first) {
    float height = 0;
    for (std::size_t last = first; last < heights.size(); ++last) {
      height += heights[last];
      const bool tall_enough = height >= *std::max_element(heights.begin(), heights.end());
      if (tall_enough && height < least && columns_needed(heights, height) <= columns) least = height;
    }
  }
  return least;
}

/// All lines in columns of about equal height, no section torn apart.
void draw_sections(const Look& look, std::size_t columns, const StepWords& step) {
  const std::vector<Section> all = sections(step, look.px.fingers);
  const float gap = column_gap(look), title = title_height(look);
  const float whole = ImGui::GetContentRegionAvail().x;
  const float width = (whole - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  std::vector<float> heights;
  for (const Section& section : all) heights.push_back(section_height(look, section, width));
  const float height = column_height(heights, columns);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImVec2 at = origin;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (at.y > origin.y && at.y + heights[i] > origin.y + height + 1) at = {at.x + width + gap, origin.y};
    draw_text(*ImGui::GetWindowDrawList(), look.fonts.title, at, look.theme.dim, all[i].title);
    float y = at.y + title - look.px.s;
    for (const Line& each : all[i].lines) y += draw_line(look, {at.x, y}, each, width);
    at.y += heights[i];
  }
  ImGui::SetCursorScreenPos(origin);
  ImGui::Dummy({whole, height});
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
  paragraph(
      look.fonts.ui, look.theme.dim,
      "Fields go from blue or violet (least) to yellow (most); the legend on the canvas has their range.");
}

}  // namespace

DialogDecision Dialogs::keys_dialog(const Look& look) {
  heading(look, "Keys and legend");
  const float whole = ImGui::GetContentRegionAvail().x;
  const float tallest = ImGui::GetIO().DisplaySize.y - look.px(32 + 40 + 40 + 52);
  const auto columns =
      static_cast<std::size_t>(std::clamp((whole + column_gap(look)) / look.px(kColumn), 1.0f, 5.0f));
  ImGui::BeginChild("page", {0, std::min(tallest, page_height_)});
  const float top = ImGui::GetCursorPosY();
  draw_sections(look, columns, step_);
  draw_signs(look);
  page_height_ = ImGui::GetCursorPosY() - top;
  ImGui::EndChild();
  align_right(button_width(look, "Close"));
  const bool closed = button(look, "Close", ButtonKind::plain) || escape_pressed() || enter_pressed() ||
                      (!fresh_ && ImGui::IsKeyPressed(key::kF1, false));
  return closed ? DialogDecision{.kind = DialogDecision::Kind::cancel} : DialogDecision{};
}

}  // namespace replan::ui
