#include "core/session/session.hpp"

#include <algorithm>
#include <cmath>

namespace replan {
namespace {

/// The scenario without the cells of its map.
std::shared_ptr<const Scenario> rest_of(const Scenario& scenario) {
  auto rest = std::make_shared<Scenario>();
  rest->map.width = scenario.map.width;
  rest->map.height = scenario.map.height;
  rest->map.resolution = scenario.map.resolution;
  rest->name = scenario.name;
  rest->caption = scenario.caption;
  rest->map_file = scenario.map_file;
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

/// How many surprises two scenarios begin with in common, or nothing if a run cannot be carried over at all.
std::optional<std::size_t> common_surprises(const Scenario& a, const Scenario& b) {
  const bool same_run = a.map == b.map && a.start == b.start && a.goal == b.goal &&
                        a.planners == b.planners && a.robot == b.robot && a.seed == b.seed;
  if (!same_run) return std::nullopt;
  const auto parted =
      std::mismatch(a.surprises.begin(), a.surprises.end(), b.surprises.begin(), b.surprises.end());
  return static_cast<std::size_t>(parted.first - a.surprises.begin());
}

std::string count_text(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

const char* command_text(const Command& command) {
  static constexpr const char* kTexts[] = {
      "",
#define REPLAN_COMMAND(NAME, TEXT) TEXT,
#include "core/session/commands.def"
#undef REPLAN_COMMAND
  };
  return kTexts[command.index()];
}

Session::Session(Scenario scenario, std::string file)
    : scenario_(std::make_shared<const Scenario>(std::move(scenario))), file_(std::move(file)) {
  restart_runs();
}

std::string Session::undo_text() const {
  return undo_.empty() ? "" : undo_.back().label;
}
std::string Session::redo_text() const {
  return redo_.empty() ? "" : redo_.back().label;
}

Result<void> Session::apply(const Command& command) {
  Result<void> done = std::visit([this](const auto& each) { return run_command(each); }, command);
  if (!done) say(done.error());
  ++revision_;
  return done;
}

void Session::restart_runs() {
  runs_.clear();
  for (std::size_t i = 0; i < scenario_->planners.size(); ++i) {
    runs_.push_back(std::make_unique<Run>(scenario_, i));
    runs_.back()->go(Target::plan());
  }
  follow_ = true;
}

void Session::rebase_runs(const std::shared_ptr<const Scenario>& scenario, std::size_t common) {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (!runs_[i]->rebase(scenario, common)) runs_[i] = std::make_unique<Run>(scenario, i);
    runs_[i]->go(Target::plan());
  }
  follow_ = true;
}

void Session::replace(std::shared_ptr<const Scenario> scenario) {
  const auto common = common_surprises(*scenario_, *scenario);
  scenario_ = std::move(scenario);
  if (common)
    rebase_runs(scenario_, *common);
  else
    restart_runs();
}

void Session::commit(std::string label, std::uint64_t stroke, Scenario changed) {
  Edit edit;
  if (changed.map.width == scenario_->map.width && changed.map.height == scenario_->map.height)
    differences(scenario_->map, changed.map, edit.before, edit.after);
  edit.label = std::move(label);
  edit.stroke = stroke;
  edit.rest_before = rest_of(*scenario_);
  edit.rest_after = rest_of(changed);
  redo_.clear();
  ++edits_done_;
  if (stroke != 0 && !undo_.empty() && undo_.back().stroke == stroke) {
    Edit& whole = undo_.back();
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
  --edits_done_;
  say("undo: " + edit.label);
  replace(patched(edit.before, *edit.rest_before));
  redo_.push_back(std::move(edit));
  return {};
}

Result<void> Session::run_command(const Redo&) {
  if (redo_.empty()) return Error{"there is nothing to redo"};
  Edit edit = std::move(redo_.back());
  redo_.pop_back();
  ++edits_done_;
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

Result<void> Session::edit_cells(const std::vector<CellChange>& cells, bool announced, std::uint64_t stroke) {
  for (const CellChange& change : cells)
    if (!scenario_->map.contains(change.cell))
      return Error{"cell (" + std::to_string(change.cell.x) + ", " + std::to_string(change.cell.y) +
                   ") lies outside the world"};
  Run& run = *runs_.front();
  const std::size_t cursor = run.timeline().cursor();
  const Mark* mark = run.mark_at(cursor);
  // In the middle of a repair the edit waits for its end; a first plan starts afresh.
  if (mark != nullptr && cursor > mark->event && cursor == run.timeline().size()) {
    run.finish(Target::plan());
    seek(run.timeline().size());
    mark = run.mark_at(run.timeline().cursor());
  }
  std::vector<CellChange> real;
  for (const CellChange& change : cells) {
    const bool now = mark == nullptr ? scenario_->map.at(change.cell)
                                     : run.timeline().state().truly_blocked(run.lattice().node(change.cell));
    if (now != change.blocked) real.push_back(change);
  }
  if (real.empty()) return {};
  std::sort(real.begin(), real.end(), [](const CellChange& a, const CellChange& b) {
    return std::pair(a.cell.y, a.cell.x) < std::pair(b.cell.y, b.cell.x);
  });
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

Result<void> Session::run_command(const ReplaceScenario& command) {
  scenario_ = std::make_shared<const Scenario>(command.scenario);
  file_ = command.file;
  undo_.clear();
  redo_.clear();
  edits_done_ = saved_at_ = 0;
  playback_.direction = 0;
  restart_runs();
  say(file_.empty() ? "new world" : "opened " + file_);
  return {};
}

Result<void> Session::run_command(const Restart&) {
  Scenario changed = to_save();
  if (changed == *scenario_)
    restart_runs();
  else
    commit("plan from scratch", 0, std::move(changed));
  return {};
}

Result<void> Session::run_command(const Play& command) {
  playback_.direction = command.direction;
  owed_ = 0;
  if (command.direction != 0) follow_ = false;
  return {};
}

Result<void> Session::run_command(const SetSpeed& command) {
  playback_.expansions_per_second = std::clamp(command.expansions_per_second, 0.1, kFullSpeed);
  return {};
}

Result<void> Session::run_command(const Step& command) {
  playback_.direction = 0;
  follow_ = false;
  Run& run = *runs_.front();
  for (int i = 0; i < std::abs(command.count); ++i) {
    const std::size_t cursor = run.timeline().cursor();
    if (command.count > 0 && cursor == run.timeline().size() && !run.busy()) {
      const Mark* mark = run.mark_at(cursor);
      run.finish(command.unit == StepUnit::replan ? Target::end()
                                                  : Target::clock_at(mark == nullptr ? 0 : mark->clock + 1));
    }
    seek(command.count > 0 ? next_stop(run, cursor, command.unit) : previous_stop(run, cursor, command.unit));
  }
  return {};
}

Result<void> Session::run_command(const Seek& command) {
  follow_ = command.position >= run().timeline().size();
  seek(command.position);
  return {};
}

Result<void> Session::run_command(const RunToEnd&) {
  playback_.direction = 0;
  for (const auto& run : runs_) run->go(Target::end());
  follow_ = true;
  return {};
}

Result<void> Session::run_command(const Cancel&) {
  for (const auto& run : runs_) run->cancel();
  return {};
}

// The other panes go along in lockstep: to the same step of the robot, and as many expansions into its plan.
void Session::seek(std::size_t position) {
  Run& first = *runs_.front();
  first.timeline().seek(std::min(position, first.timeline().size()));
  if (runs_.size() == 1) return;
  const Run::Progress progress = first.progress(first.timeline().cursor());
  for (std::size_t i = 1; i < runs_.size(); ++i) {
    Run& run = *runs_[i];
    const bool behind = run.marks().empty() || run.marks().back().clock <= progress.clock;
    if (behind && !run.busy()) run.go(Target::clock_at(progress.clock + 1));
    run.timeline().seek(run.position_of(progress));
  }
}

bool Session::update(double seconds) {
  bool changed = false;
  for (const auto& run : runs_) {
    if (run->pump()) changed = true;
    if (follow_ && run->timeline().cursor() != run->timeline().size()) {
      run->timeline().seek(run->timeline().size());
      changed = true;
    }
  }
  if (play(seconds)) changed = true;
  if (changed) ++revision_;
  return changed;
}

bool Session::play(double seconds) {
  if (playback_.direction == 0) return false;
  Run& run = *runs_.front();
  const double speed = playback_.expansions_per_second;
  owed_ = std::min(owed_ + seconds, 0.1);  // after a stall, go on instead of leaping
  std::size_t cursor = run.timeline().cursor();
  const std::size_t begin = cursor;
  int steps = 200000;  // of one frame, at full speed
  while (owed_ > 0 && steps-- > 0) {
    const bool at_end = playback_.direction > 0 ? cursor >= run.timeline().size() : cursor == 0;
    if (at_end) break;
    const std::size_t next = playback_.direction > 0 ? next_stop(run, cursor, StepUnit::expansion)
                                                     : previous_stop(run, cursor, StepUnit::expansion);
    const std::size_t shown = std::min(cursor, next);
    const bool moves = run.timeline().event(shown).kind == EventKind::move;
    if (speed < kFullSpeed || moves) owed_ -= 1 / (moves ? std::min(speed, kMovesPerSecond) : speed);
    cursor = next;
  }
  seek(cursor);
  const Mark* last = run.marks().empty() ? nullptr : &run.marks().back();
  const bool can_go_on = last != nullptr && last->state == MissionState::driving;
  if (playback_.direction > 0 && can_go_on && run.timeline().size() - cursor < 64 && !run.busy())
    for (const auto& each : runs_) each->go(Target::clock_at(last->clock + 4));
  const bool finished =
      playback_.direction > 0 ? cursor >= run.timeline().size() && !can_go_on && !run.busy() : cursor == 0;
  if (finished) playback_.direction = 0;
  return cursor != begin || finished;
}

void Session::settle() {
  for (const auto& run : runs_) run->finish(Target::plan());
  update(0);
}

Scenario Session::to_save() const {
  Scenario folded = *scenario_;
  std::erase_if(folded.surprises, [&](const Surprise& surprise) {
    const bool before_start = surprise.announced && surprise.at.move == 0;
    if (before_start)
      for (const CellChange& change : surprise.cells) folded.map.set(change.cell, change.blocked);
    return before_start;
  });
  return folded;
}

void Session::saved(const std::string& file) {
  file_ = file;
  saved_at_ = edits_done_;
  say("saved " + file);
  ++revision_;
}

}  // namespace replan
