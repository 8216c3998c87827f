// The Figures tab: what the plan that stands is worth and what it cost, a column per planner.
#include <algorithm>
#include <vector>

#include "core/trace/search_state.hpp"
#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// A figure with its explanation and its text per pane.
struct Row {
  const char* label;
  const char* unit;
  const char* teach;
  std::string (*text)(const PathFigures& path, const replan::Mark& mark, const Run& run);
};

using Figures = const PathFigures&;
std::string count(std::int64_t number) {
  return grouped(number);
}
std::string milliseconds(double time) {
  return fixed(time, time < 10 ? 3 : 1);
}

// clang-format off
const Row kPathRows[] = {
    {"nodes", "", "Corners of the path's polyline, both ends counted.", [](Figures f, const replan::Mark&, const Run&) { return count(f.nodes); }},
    {"length", "cells", "Along the straight segments.", [](Figures f, const replan::Mark&, const Run&) { return fixed(f.length, 3); }},
    {"turns", "", "Inner corners where the heading changes.", [](Figures f, const replan::Mark&, const Run&) { return count(f.turns); }},
    {"turning", "°", "The sum of all changes of heading.", [](Figures f, const replan::Mark&, const Run&) { return fixed(f.turning_angle_deg, 1); }},
    {"least clearance", "cells", "From the path to the nearest obstacle's edge, at the narrowest place.", [](Figures f, const replan::Mark&, const Run&) { return fixed(f.min_clearance, 3); }},
    {"mean clearance", "cells", "The mean over the whole path, sampled every tenth of a cell.", [](Figures f, const replan::Mark&, const Run&) { return fixed(f.mean_clearance, 3); }},
};
const Row kPlanRows[] = {
    {"expansions", "", "Vertices that the latest plan or replan took from the open list and settled or raised.", [](Figures, const replan::Mark& m, const Run&) { return count(m.figures.last_plan.expansions); }},
    {"queue operations", "", "Inserts, removals, changes of key and pops.", [](Figures, const replan::Mark& m, const Run&) { return count(m.figures.last_plan.queue_operations); }},
    {"sight checks", "", "Lines of sight that were looked along.", [](Figures, const replan::Mark& m, const Run&) { return count(m.figures.last_plan.sight_checks); }},
};
const Row kRunRows[] = {
    {"expansions", "", "Of all plans so far together.", [](Figures, const replan::Mark& m, const Run&) { return count(m.figures.counters.expansions); }},
    {"queue operations", "", "Of all plans so far together.", [](Figures, const replan::Mark& m, const Run&) { return count(m.figures.counters.queue_operations); }},
    {"sight checks", "", "Of all plans so far together.", [](Figures, const replan::Mark& m, const Run&) { return count(m.figures.counters.sight_checks); }},
    {"first plan", "ms", "Wall time, while every step is being recorded; planning without a record is several times as fast.", [](Figures, const replan::Mark& m, const Run&) { return milliseconds(m.figures.plan_ms); }},
    {"replans", "ms", "Wall time of all replans together, while every step is being recorded.", [](Figures, const replan::Mark& m, const Run&) { return milliseconds(m.figures.replan_ms); }},
    {"replans", "", "How often the plan was repaired or made anew.", [](Figures, const replan::Mark& m, const Run&) { return count(m.figures.replans); }},
    {"record", "", "Memory of the run's log and its key frames, which is what stepping back costs. Beyond 1 GiB for all panes together the oldest stretches are dropped, and planned once more when you go there.", [](Figures, const replan::Mark&, const Run& r) { return bytes_text(r.timeline().log_bytes() + r.timeline().frame_bytes()); }},
};
const Row kRobotRows[] = {
    {"moves", "", "Cells that the robot has entered.", [](Figures, const replan::Mark& m, const Run&) { return count(m.figures.moves); }},
    {"travelled", "cells", "The way the robot has gone, along its paths.", [](Figures, const replan::Mark& m, const Run&) { return fixed(m.figures.travelled, 3); }},
    {"collisions", "", "Times that a plan led into an obstacle. Only with remote parents as printed.", [](Figures, const replan::Mark& m, const Run&) { return count(m.figures.collisions); }},
};
// clang-format on

/// The robot's map changed after the mark: what is known at the cursor is not what this plan was made for.
bool map_changed_since(const Run& run, const replan::Mark& mark) {
  for (std::size_t i = mark.event; i < run.timeline().cursor(); ++i) {
    const EventKind kind = run.timeline().event(i).kind;
    if (kind == EventKind::known) return true;
    if (kind == EventKind::pop || kind == EventKind::move) return false;
  }
  return false;
}

/// The figures of the plan that stands; computed once for each plan.
const PathFigures& figures_of(PanelState& panels, const Run& run, std::size_t pane,
                              const replan::Mark& mark) {
  if (panels.figures.size() <= pane) panels.figures.resize(pane + 1);
  FigureCache& cache = panels.figures[pane];
  if (cache.route == mark.route || map_changed_since(run, mark)) return cache.figures;
  const SearchState& state = run.timeline().state();
  std::vector<std::uint8_t> known(state.node_count());
  for (NodeId n = 0; n < known.size(); ++n) known[n] = state.known_blocked(n) ? 1 : 0;
  const Grid2 lattice(run.lattice().size(), std::move(known), run.lattice().rules());
  cache = {mark.route, path_figures(lattice, mark.route->path.nodes)};
  return cache.figures;
}

std::vector<Column> columns_for(const Session& session, const std::vector<std::string>& names) {
  std::vector<Column> columns = {{"", 2.6f, Align::left}};
  for (std::size_t i = 0; i < session.runs().size(); ++i) columns.push_back({names[i].c_str(), 1.2f});
  return columns;
}

void rows(Frame& frame, const char* title, std::span<const Row> table, std::span<const Column> columns) {
  const Look& look = frame.look;
  section_title(look, title);
  int id = 0;
  ImGui::PushID(title);
  for (const Row& row : table) {
    const std::string label =
        std::string(row.label) + (row.unit[0] == '\0' ? "" : std::string("  ") + row.unit);
    std::vector<std::string> texts;
    for (std::size_t pane = 0; pane < frame.session.runs().size(); ++pane) {
      const Run& run = *frame.session.runs()[pane];
      const replan::Mark* mark = run.mark_at(run.timeline().cursor());
      texts.push_back(mark == nullptr ? "—"
                                      : row.text(figures_of(frame.panels, run, pane, *mark), *mark, run));
    }
    std::vector<TableCell> cells = {{label, look.theme.dim}};
    for (const std::string& each : texts) cells.push_back({each});
    table_row(look, id++, columns, cells);
    hint(look, {row.label, "", row.teach});
  }
  ImGui::PopID();
}

}  // namespace

void draw_figures_panel(Frame& frame) {
  const Look& look = frame.look;
  const bool any = std::any_of(frame.session.runs().begin(), frame.session.runs().end(), [](const auto& run) {
    return run->mark_at(run->timeline().cursor()) != nullptr;
  });
  if (!any) {
    empty_state(look, icon::bar_chart, "No plan stands here yet",
                "Step or play on until the first plan is found; its figures show here.");
    return;
  }
  std::vector<std::string> names;
  for (const auto& run : frame.session.runs()) names.emplace_back(run->info().name);
  const std::vector<Column> columns = columns_for(frame.session, names);
  table_header(look, columns);
  rows(frame, "The plan that stands", kPathRows, columns);
  section_rule(look);
  rows(frame, "What it cost", kPlanRows, columns);
  section_rule(look);
  rows(frame, "The run so far", kRunRows, columns);
  section_rule(look);
  rows(frame, "The robot", kRobotRows, columns);
}

}  // namespace replan::ui
