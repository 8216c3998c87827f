// The Log tab: what was done and what went wrong, oldest first, and what the platform had to say.
#include <array>

#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {

namespace {

/// One edit with its number; returns whether it was clicked.
bool history_row(const Look& look, int number, std::string_view label, bool made, bool current) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, look.px.row);
  ImGui::PushID(number);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  const bool clicked = ImGui::InvisibleButton("edit", size);
  ImGui::PopStyleVar();
  ImGui::PopID();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(origin.x + size.x, origin.y + size.y);
  if (current || ImGui::IsItemHovered())
    list.AddRectFilled(origin, end, current ? look.theme.selected : look.theme.hover, look.px(4));
  const float y = origin.y + (size.y - look.fonts.ui->FontSize) * 0.5f, indent = look.px(44);
  const std::string count = number == 0 ? "" : std::to_string(number);
  draw_text(list, look.fonts.mono, {origin.x + look.px(32) - text_width(look.fonts.mono, count), y},
            look.theme.faint, count);
  draw_text(list, look.fonts.ui, {origin.x + indent, y},
            current ? look.theme.text
            : made  ? look.theme.dim
                    : look.theme.faint,
            elide(look.fonts.ui, label, size.x - indent - look.px.xs));
  return clicked;
}

/// All edits, the latest at the bottom; those that were taken back are dim. A click goes there.
void draw_history(Frame& frame) {
  const Look& look = frame.look;
  const std::vector<std::string> labels = frame.session.history();
  if (labels.empty()) {
    empty_state(look, icon::history, "No edits yet",
                "Each edit is listed here; a click on one goes back to it.");
    return;
  }
  const std::size_t position = frame.session.history_position();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(labels.size()) + 1, look.px.row);
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const auto at = static_cast<std::size_t>(row);
      if (history_row(look, row, at == 0 ? "as opened" : std::string_view(labels[at - 1]), at <= position,
                      at == position))
        frame.commands.push_back(GoToHistory{at});
    }
}

void draw_lines(Frame& frame) {
  const Look& look = frame.look;
  const auto log = frame.session.log();
  for (const std::string& notice : frame.panels.notices) {
    text(look.fonts.ui, look.theme.warning, icon::warning);
    ImGui::SameLine(0, look.px.s);
    paragraph(look.fonts.ui, look.theme.dim, notice);
  }
  if (!frame.panels.notices.empty()) section_rule(look);
  if (log.empty()) {
    empty_state(look, icon::list, "Nothing yet", "Edits, opened files and errors are listed here.");
    return;
  }
  // Long ago is of little use, and every line is measured for wrapping.
  constexpr std::size_t kShown = 500;
  const std::size_t first = log.size() > kShown ? log.size() - kShown : 0;
  if (first > 0)
    paragraph(look.fonts.small, look.theme.faint, std::to_string(first) + " older lines are not shown");
  for (std::size_t i = first; i < log.size(); ++i)
    paragraph(look.fonts.ui, i + 1 == log.size() ? look.theme.text : look.theme.dim, log[i]);
  if (frame.panels.log_lines != log.size()) {
    ImGui::SetScrollHereY(1.0f);
    frame.panels.log_lines = log.size();
  }
}

}  // namespace

void draw_log_panel(Frame& frame) {
  const Look& look = frame.look;
  static constexpr std::array<const char*, 2> kParts = {"Events", "History"};
  int part = frame.panels.history ? 1 : 0;
  if (segments(look, "part", kParts, part)) frame.panels.history = part == 1;
  ImGui::Dummy({0, look.px.xs});
  if (frame.panels.history)
    draw_history(frame);
  else
    draw_lines(frame);
}

}  // namespace replan::ui
