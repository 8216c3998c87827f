// The session's edits: what changes the document, and how it is taken back and saved.
#include <algorithm>
#include <cmath>

#include "core/session/session.hpp"

namespace replan {
namespace {

/// The scenario without the cells of its map.
std::shared_ptr<const Scenario> rest_of(const Scenario& scenario) {
  auto rest = std::make_shared<Scenario>();
  rest->map.width = scenario.map.width;
  rest->map.height = scenario.map.height;
  rest->map.resolution = scenario.map.resolution;
  rest->map.origin = scenario.map.origin;
  rest->name = scenario.name;
  rest->caption = scenario.caption;
  rest->map_file = scenario.map_file;
  rest->map_reading = scenario.map_reading;
  rest->start = scenario.start;
  rest->goal = scenario.goal;
  rest->planners = scenario.planners;
  rest->robot = scenario.robot;
  rest->surprises = scenario.surprises;
  rest->view = scenario.view;
  rest->seed = scenario.seed;
  return rest;
}

/// Cells in which two maps of one size differ, as they are in `a` and as they are in `b`.
void differences(const GridMap& a, const GridMap& b, std::vector<CellChange>& in_a,
                 std::vector<CellChange>& in_b) {
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const Cell cell{x, y};
      if (a.at(cell) == b.at(cell)) continue;
      in_a.push_back({cell, a.at(cell)});
      in_b.push_back({cell, b.at(cell)});
    }
}

std::string count_text(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

void Session::commit(std::string label, std::uint64_t stroke, Scenario changed) {
  Edit edit;
  if (changed.map.width == scenario_->map.width && changed.map.height == scenario_->map.height)
    differences(scenario_->map, changed.map, edit.before, edit.after);
  edit.label = std::move(label);
  edit.stroke = stroke;
  edit.rest_before = rest_of(*scenario_);
  edit.rest_after = rest_of(changed);
  edit.serial = ++serials_;
  redo_.clear();
  if (stroke != 0 && !undo_.empty() && undo_.back().stroke == stroke) {
    Edit& whole = undo_.back();
    whole.serial = edit.serial;
    whole.rest_after = edit.rest_after;
    whole.before.insert(whole.before.begin(), edit.before.rbegin(), edit.before.rend());
    whole.after.insert(whole.after.end(), edit.after.begin(), edit.after.end());
  } else {
    say(edit.label);
    undo_.push_back(std::move(edit));
  }
  replace(std::make_shared<const Scenario>(std::move(changed)));
}

std::shared_ptr<const Scenario> Session::patched(const std::vector<CellChange>& cells,
                                                 const Scenario& rest) const {
  auto scenario = std::make_shared<Scenario>(rest);
  scenario->map = scenario_->map;
  for (const CellChange& change : cells) scenario->map.set(change.cell, change.blocked);
  return scenario;
}

Result<void> Session::run_command(const Undo&) {
  if (undo_.empty()) return Error{"there is nothing to undo"};
  Edit edit = std::move(undo_.back());
  undo_.pop_back();
  say("undo: " + edit.label);
  replace(patched(edit.before, *edit.rest_before));
  redo_.push_back(std::move(edit));
  return {};
}

Result<void> Session::run_command(const Redo&) {
  if (redo_.empty()) return Error{"there is nothing to redo"};
  Edit edit = std::move(redo_.back());
  redo_.pop_back();
  say("redo: " + edit.label);
  replace(patched(edit.after, *edit.rest_after));
  undo_.push_back(std::move(edit));
  return {};
}

Result<void> Session::run_command(const PaintCells& command) {
  return edit_cells(command.cells, true, command.stroke);
}

Result<void> Session::run_command(const DropSurprise& command) {
  return edit_cells(command.cells, false, command.stroke);
}

/// Of `cells` those that differ from the world where the edit will happen, row by row.
std::vector<CellChange> Session::real_changes(const std::vector<CellChange>& cells, const Mark* mark) {
  Run& run = *runs_.front();
  const std::size_t cursor = run.timeline().cursor();
  if (mark != nullptr) run.timeline().seek(run.mark_for_new_surprise(mark->clock)->event);
  std::vector<CellChange> real;
  for (const CellChange& change : cells) {
    const bool now = mark == nullptr ? scenario_->map.at(change.cell)
                                     : run.timeline().state().truly_blocked(run.lattice().node(change.cell));
    if (now != change.blocked) real.push_back(change);
  }
  run.timeline().seek(cursor);
  std::sort(real.begin(), real.end(), [](const CellChange& a, const CellChange& b) {
    return std::pair(a.cell.y, a.cell.x) < std::pair(b.cell.y, b.cell.x);
  });
  return real;
}

Result<void> Session::edit_cells(const std::vector<CellChange>& cells, bool announced, std::uint64_t stroke) {
  for (const CellChange& change : cells)
    if (!scenario_->map.contains(change.cell))
      return Error{"cell (" + std::to_string(change.cell.x) + ", " + std::to_string(change.cell.y) +
                   ") lies outside the world"};
  Run& run = *runs_.front();
  // In the middle of a repair the edit waits for its end; a first plan starts afresh.
  if (!run.marks().empty()) {
    run.finish(Target::plan());
    update(0);
  }
  const Mark* mark = run.mark_at(run.timeline().cursor());
  const std::vector<CellChange> real = real_changes(cells, mark);
  if (real.empty()) return {};
  Scenario changed = *scenario_;
  const std::string label = (announced ? real.front().blocked ? "paint " : "erase " : "surprise of ") +
                            count_text(real.size(), "cell");
  if (mark == nullptr)
    for (const CellChange& change : real) changed.map.set(change.cell, change.blocked);
  else
    changed.surprises.push_back(
        {.at = {.move = mark->clock, .near = {}, .within = 0}, .cells = real, .announced = announced});
  commit(label, stroke, std::move(changed));
  return {};
}

Result<void> Session::run_command(const SetStart& command) {
  if (!scenario_->map.contains(command.cell)) return Error{"the start must lie on the map"};
  if (command.cell == scenario_->start) return {};
  Scenario changed = to_save();
  changed.start = command.cell;
  commit("move the start", command.stroke, std::move(changed));
  return {};
}

Result<void> Session::run_command(const SetGoal& command) {
  if (!scenario_->map.contains(command.cell)) return Error{"the goal must lie on the map"};
  if (command.cell == scenario_->goal) return {};
  Scenario changed = to_save();
  changed.goal = command.cell;
  commit("move the goal", command.stroke, std::move(changed));
  return {};
}

Result<void> Session::run_command(const ChoosePlanner& command) {
  const auto info = require_planner(command.id);
  if (!info) return Error{info.error()};
  if (command.pane >= scenario_->planners.size()) return Error{"there is no such pane"};
  PlannerChoice choice{command.id, {}};
  // Settings that the new planner declares too are kept.
  for (const auto& [key, value] : scenario_->planners[command.pane].settings.values())
    if (const Parameter* parameter = find_parameter((*info)->parameters, key);
        parameter != nullptr && parse_value(*parameter, format_value(*parameter, value)).ok())
      choice.settings.set(key, value);
  if (choice == scenario_->planners[command.pane]) return {};
  Scenario changed = *scenario_;
  changed.planners[command.pane] = std::move(choice);
  commit("choose " + std::string((*info)->name), 0, std::move(changed));
  return {};
}

Result<void> Session::run_command(const SetParameter& command) {
  if (command.pane >= scenario_->planners.size()) return Error{"there is no such pane"};
  Scenario changed = *scenario_;
  PlannerChoice& choice = changed.planners[command.pane];
  const Parameter* parameter = find_parameter(find_planner(choice.id)->parameters, command.key);
  if (parameter == nullptr) return Error{"this planner has no setting '" + command.key + "'"};
  if (choice.settings.get(*parameter) == command.value) return {};
  const Result<double> value = parse_value(*parameter, format_value(*parameter, command.value));
  if (!value) return Error{value.error()};
  choice.settings.set(command.key, *value);
  if (*value == parameter->initial) choice.settings.reset(command.key);
  commit("set " + std::string(parameter->label) + " to " + format_value(*parameter, *value), 0,
         std::move(changed));
  return {};
}

Result<void> Session::run_command(const ResetParameters& command) {
  if (command.pane >= scenario_->planners.size()) return Error{"there is no such pane"};
  Scenario changed = *scenario_;
  changed.planners[command.pane].settings = {};
  commit("reset the settings", 0, std::move(changed));
  return {};
}

Result<void> Session::run_command(const SetRobot& command) {
  if (command.robot == scenario_->robot) return {};
  Scenario changed = *scenario_;
  changed.robot = command.robot;
  commit("change the robot", 0, std::move(changed));
  return {};
}

Scenario Session::to_save() const {
  Scenario folded = *scenario_;
  if (folded.robot.knowledge == Knowledge::nothing) return folded;
  std::size_t kept = 0;
  bool first_of_all = true;  // nothing that may happen before the robot moves has been passed over
  for (std::size_t i = 0; i < folded.surprises.size(); ++i) {
    Surprise& surprise = folded.surprises[i];
    const bool before_start = surprise.at.near || surprise.at.move == 0;
    if (first_of_all && before_start && surprise.announced && i >= scripted_ && surprise.at.move) {
      for (const CellChange& change : surprise.cells) folded.map.set(change.cell, change.blocked);
      continue;
    }
    const Cell at = surprise.at.near.value_or(folded.start);
    const bool due = std::hypot(at.x - folded.start.x, at.y - folded.start.y) <= surprise.at.within;
    if (before_start && due) first_of_all = false;
    if (kept != i) folded.surprises[kept] = std::move(surprise);
    ++kept;
  }
  folded.surprises.resize(kept);
  return folded;
}

void Session::saved(const std::string& file) {
  file_ = file;
  saved_at_ = document_state();
  say("saved " + file);
  ++revision_;
}

}  // namespace replan
