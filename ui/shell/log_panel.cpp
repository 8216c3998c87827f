// The Log tab: what was done and what went wrong, oldest first, and what the platform had to say.
#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {

void draw_log_panel(Frame& frame) {
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

}  // namespace replan::ui
