#include "ui/tabs/log.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// One edit with its number; returns whether it was clicked.
bool edit_row(const Look& look, int number, std::string_view label, bool made, bool current) {
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
  draw_line(look, list, look.fonts.ui, {origin.x + indent, y},
            current ? look.theme.text
            : made  ? look.theme.dim
                    : look.theme.faint,
            label, size.x - indent - look.px.xs);
  return clicked;
}

/// All edits, the latest at the bottom; those that were taken back are dim. A click goes there.
void draw_edits(Frame& frame) {
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
      if (edit_row(look, row, at == 0 ? "as opened" : std::string_view(labels[at - 1]), at <= position,
                   at == position))
        frame.commands.push_back(GoToHistory{at});
    }
}

/// As a heading: without a full stop.
std::string story_words(const Run& run, const Milestone& milestone) {
  const Event event{.delta = milestone.payload, .node = milestone.node, .kind = milestone.kind};
  std::string words = as_sentence(event_text(run.lattice(), run.info().values, event, 0));
  if (words.ends_with('.')) words.pop_back();
  return words;
}

/// As wide as the longest numbers of the run; the rest is for words.
std::array<Column, 3> story_columns(const Look& look, const Run& run) {
  const auto width = [&](std::size_t most, const char* name) {
    return std::max(text_width(look.fonts.mono, grouped(most)), text_width(look.fonts.mono, name)) +
           look.px(16);
  };
  const std::int64_t clock = run.decisions().empty() ? 0 : run.decisions().back().clock;
  const float event = width(run.timeline().size(), "event"),
              step = width(static_cast<std::size_t>(clock), "step");
  const float words = std::max(look.px(80), ImGui::GetContentRegionAvail().x - event - step);
  return {{{"event", event}, {"step", step}, {"what happened", words, Align::left}}};
}

/// One happening; a click goes to behind it. What lies after the playhead stands back.
void story_row(Frame& frame, std::size_t row, const Milestone& milestone, std::span<const Column> columns) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const bool ahead = milestone.event >= run.timeline().cursor(),
             here = milestone.event + 1 == run.timeline().cursor();
  const Decision* decision = run.decision_at(milestone.event);
  const std::string event = grouped(milestone.event + 1),
                    step = grouped(decision == nullptr ? std::int64_t{0} : decision->clock),
                    words = story_words(run, milestone);
  const std::array<TableCell, 3> cells = {{{event, ahead ? look.theme.faint : look.theme.accent},
                                           {step, ahead ? look.theme.faint : look.theme.dim},
                                           {words, ahead ? look.theme.faint : look.theme.text}}};
  if (table_row(look, static_cast<int>(row), columns, cells, here))
    frame.commands.push_back(Seek{milestone.event + 1});
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  hint(look, {words.c_str(), "", "Click to go there."});
}

}  // namespace

void RunStory::follow(const Run& run) {
  if (log_id_ != run.log_id()) *this = RunStory();
  log_id_ = run.log_id();
  for (; read_ < run.milestones().size(); ++read_)
    if (const EventKind kind = run.milestones()[read_].kind;
        kind != EventKind::move && kind != EventKind::turn)
      milestones_.push_back(read_);
}

void LogTab::draw_lines(Frame& frame) {
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
    paragraph(
        look.fonts.small, look.theme.faint,
        count_text(static_cast<std::int64_t>(first), "older line is", "older lines are") + " not shown.");
  for (std::size_t i = first; i < log.size(); ++i)
    paragraph(look.fonts.ui, i + 1 == log.size() ? look.theme.text : look.theme.dim, log[i]);
  if (lines_ != log.size()) {
    ImGui::SetScrollHereY(1.0f);
    lines_ = log.size();
  }
}

/// The leading run's plans, surprises and what became of the robot; its moves are too many to list.
void LogTab::draw_story(Frame& frame) {
  const Look& look = frame.look;
  story_.follow(frame.run());
  if (story_.milestones().empty()) {
    empty_state(look, icon::list, "Nothing has happened yet",
                "Plans, surprises and what happens to the robot will be listed here.");
    return;
  }
  const std::array<Column, 3> columns = story_columns(look, frame.run());
  table_header(look, columns);
  const auto [first, last] = begin_rows(look, "story", story_.milestones().size(), 0, story_rows_);
  for (std::size_t row = first; row < last; ++row)
    story_row(frame, row, frame.run().milestones()[story_.milestones()[row]], columns);
  end_rows();
}

void LogTab::draw(Frame& frame) {
  const Look& look = frame.look;
  static constexpr std::array<const char*, 3> kParts = {"Run", "Session", "Edits"};
  int part = static_cast<int>(part_);
  if (segments(look, "part", kParts, part)) part_ = static_cast<Part>(part);
  ImGui::Dummy({0, look.px.xs});
  switch (part_) {
    case Part::run:
      return draw_story(frame);
    case Part::session:
      return draw_lines(frame);
    case Part::edits:
      return draw_edits(frame);
  }
}

void show_edits(ViewState& view, PanelState& panels) {
  show_tab(view, panels, "log");
  panels.tabs.get<LogTab>().show_edits();
}

TabKind log_tab() {
  return {.name = "Log",
          .label = "Log",
          .icon = icon::history,
          .chord = fn(8),
          .teach = "What has happened in the run so far: plans, surprises, replans, arrival.",
          .make = make_part<SideTab, LogTab>,
          .per_pane = false};
}

}  // namespace replan::ui
