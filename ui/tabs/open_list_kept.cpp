// Part of the Open list tab, for planners that keep a tree or a population instead: what there is of it, and what the last
// replan kept and lost.
#include <algorithm>
#include <array>
#include <string>

#include "core/plan/population_values.hpp"
#include "core/plan/tree_values.hpp"
#include "ui/canvas/kept_words.hpp"
#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"
#include "ui/tabs/open_list.hpp"

namespace replan::ui {
namespace {

/// What a planner without an open list goes on with.
std::string kept_instead(const Run& run) {
  const SearchState& state = run.timeline().state();
  if (run.info().values.grows()) {
    if (vertex_count(state) == 0) return "It grows a tree of samples, which begins with the first step.";
    return "It has a tree of " + count_text(std::int64_t{vertex_count(state)}, "vertex", "vertices") +
           ". The Cell tab tells of the one nearest to a cell, and of the sample in hand.";
  }
  if (path_count(state) == 0) return "It breeds a population of paths, which begins with the first step.";
  return "It has a population of " + count_text(std::int64_t{path_count(state)} - 1, "path", "paths") +
         ". The Cell tab tells of those that turn at a cell, and of the child in hand.";
}

/// Where a row of the list leads: to the vertex, or to where the path sets out.
Cell cell_of_lost(const Lost& lost) {
  return cell_of(lost.way.back());
}

}  // namespace

bool lists_nothing(Frame& frame) {
  const Run& run = frame.run();
  if (!run.info().values.grows() && !run.info().values.breeds()) return false;
  empty_state(frame.look, icon::list, "This planner keeps no open list", kept_instead(run).c_str());
  return true;
}

KeptInReplan* kept_by_last_replan(Frame& frame) {
  const Run& run = frame.run();
  const auto span = last_replan(run);
  if (!span || (!run.info().values.grows() && !run.info().values.breeds())) return nullptr;
  frame.panels.kept.follow(run.log_view(), run.log_id(), span->begin, span->end);
  return &frame.panels.kept;
}

void draw_lost(Frame& frame, const KeptInReplan& kept, RowScroll& scroll) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const std::size_t cursor = run.timeline().cursor();
  const bool paths = run.info().values.breeds();
  const LengthUnit lengths = shown_lengths(frame.view, run.scenario().map);
  paragraph(look.fonts.ui, look.theme.text, kept_sentence(run.info().values, kept.counts_before(cursor)));
  const std::span<const Lost> lost = kept.lost_before(cursor);
  if (lost.empty()) return;
  ImGui::Dummy({0, look.px.xs});
  const float third = ImGui::GetContentRegionAvail().x / 3;
  const std::array<Column, 3> columns =
      paths
          ? std::array{Column{"path lost", third, Align::left}, Column{"cells", third}, Column{"cost", third}}
          : std::array{Column{"cut off", third, Align::left}, Column{"hung on", third},
                       Column{"its way was", third}};
  table_head(look, columns);
  const RowsInSight sight = begin_rows(look, "lost", lost.size(), 0, scroll);
  for (std::size_t row = sight.first; row < sight.last; ++row) {
    const Lost& each = lost[row];
    const std::string name = paths ? grouped(row + 1) : grouped(std::int64_t{each.number}),
                      second = paths                     ? grouped(each.way.size())
                               : each.hung_on == kNoNode ? "nothing: a root"
                                                         : grouped(std::int64_t{each.hung_on}),
                      cost = lengths.text(each.cost, 2);
    const std::vector<TableCell> cells = {{name}, {second}, {cost}};
    const bool clicked = table_row(look, static_cast<int>(row), columns, cells, false);
    if (each.way.empty()) continue;
    if (clicked) show_cell(frame, cell_of_lost(each));
    point_at(frame, cell_of_lost(each));
  }
  end_rows();
}

}  // namespace replan::ui
