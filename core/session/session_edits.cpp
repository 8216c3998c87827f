// The session's edits: what changes the document, and how it is taken back and saved.
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/words.hpp"
#include "core/plan/stage.hpp"
#include "core/session/session.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

/// Adds changes to others, both row by row; of a cell that both change the later one counts.
void add_cells(std::vector<CellChange>& cells, const std::vector<CellChange>& later) {
  std::vector<CellChange> all;
  const auto before = [](const CellChange& a, const CellChange& b) { return in_node_order(a.cell, b.cell); };
  std::set_union(later.begin(), later.end(), cells.begin(), cells.end(), std::back_inserter(all), before);
  cells = std::move(all);
}

}  // namespace

void Session::commit(std::string label, std::uint64_t stroke, Scenario changed, std::size_t scripted) {
  DocumentChange change = change_between(*scenario_, changed);
  commit(std::move(label), stroke, std::move(changed), std::move(change), scripted);
}

void Session::commit(std::string label, std::uint64_t stroke, Scenario changed, DocumentChange change,
                     std::size_t scripted) {
  if (history_.add(label, stroke, std::move(change), scripted, positions())) say(std::move(label));
  replace(std::make_shared<const Scenario>(std::move(changed)));
}

Result<void> Session::run_command(const DropSurprise& command) {
  if (command.cells.size() > kMostSurprised)
    return Error{"a surprise at once changes at most " + counted(kMostSurprised, "cell") +
                 ": draw a smaller one, or paint the map instead"};
  return edit_cells(command.cells, false, command.stroke);
}

/// The last edit has grown: it is told by another text, in the log too.
void Session::relabel(const std::string& label) {
  if (!log_.empty() && log_.back() == history_.undo_text()) log_.back() = label;
  history_.relabel(label);
}

/// What the script is still going to write into the rows of `cells` before an edit that is added to it
/// happens at the robot's step at a decision.
std::map<NodeId, bool> Session::cells_to_come(const Decision& decision,
                                              const std::vector<CellChange>& cells) const {
  const auto row = [](const CellChange& change) { return std::pair(change.cell.z, change.cell.y); };
  const auto [top, bottom] = std::minmax_element(
      cells.begin(), cells.end(), [&](const CellChange& a, const CellChange& b) { return row(a) < row(b); });
  std::map<NodeId, bool> coming;
  for (std::size_t i = 0; i < scenario_->surprises.size() && !cells.empty(); ++i) {
    const Surprise& surprise = scenario_->surprises[i];
    const bool happened = i < decision.fired.size() && decision.fired[i];
    if (happened || !surprise.at.move || *surprise.at.move > decision.clock || surprise.cells.empty())
      continue;
    // Row by row, so that most surprises of a large world are passed over by their first and last cell.
    if (row(surprise.cells.back()) < row(*top) || row(surprise.cells.front()) > row(*bottom)) continue;
    for (const CellChange& change : surprise.cells)
      coming[run().lattice().node(change.cell)] = change.blocked;
  }
  return coming;
}

/// The cells of which the world is another one at a decision than at the cursor: those that surprises between the
/// two have changed, an odd number of times. Only these events are read; going there could mean millions.
std::set<NodeId> Session::turned_between(std::size_t decision) const {
  const Timeline& log = run().timeline();
  const auto [from, to] = std::minmax({decision, log.cursor()});
  std::set<NodeId> turned;
  const auto milestones = run().milestones();
  auto milestone = std::lower_bound(milestones.begin(), milestones.end(), from,
                                    [](const Milestone& m, std::size_t event) { return m.event < event; });
  // One whose cells are being written at `from` stands before it.
  if (milestone != milestones.begin()) --milestone;
  for (; milestone != milestones.end() && milestone->event < to; ++milestone) {
    if (milestone->kind != EventKind::surprise) continue;
    for (std::size_t i = milestone->event + 1; i < to && log.event(i).kind == EventKind::truth; ++i) {
      const Event event = log.event(i);
      if (i < from || (event.delta & kWallBit) == 0) continue;
      if (!turned.insert(event.node).second) turned.erase(event.node);
    }
  }
  return turned;
}

/// Of `cells` those that differ from the world where the edit will happen, row by row. `decision` is where;
/// nullptr is in the map.
std::vector<CellChange> Session::real_changes(const std::vector<CellChange>& cells,
                                              const Decision* decision) const {
  std::map<NodeId, bool> to_come;
  std::set<NodeId> turned;
  if (decision != nullptr) {
    to_come = cells_to_come(*decision, cells);
    turned = turned_between(decision->event);
  }
  const SearchState& state = run().timeline().state();
  const auto blocked_then = [&](Cell cell) {
    if (decision == nullptr) return scenario_->map.at(cell);
    const NodeId node = run().lattice().node(cell);
    const auto coming = to_come.find(node);
    return coming == to_come.end() ? state.wall(node) != turned.contains(node) : coming->second;
  };
  std::vector<CellChange> real;
  for (const CellChange& change : cells)
    if (blocked_then(change.cell) != change.blocked) real.push_back(change);
  const auto before = [](const CellChange& a, const CellChange& b) { return in_node_order(a.cell, b.cell); };
  if (!std::is_sorted(real.begin(), real.end(), before)) std::sort(real.begin(), real.end(), before);
  return real;
}

/// What of the stroke under way has happened at the robot's step at a decision already: what is added to it is part of
/// the same surprise. nullptr if nothing has.
const Surprise* Session::surprise_of_stroke(std::uint64_t stroke, const Decision& decision,
                                            bool announced) const {
  const Surprises& all = scenario_->surprises;
  if (!history_.goes_on(stroke) || all.size() <= scripted()) return nullptr;
  const Surprise& last = all.back();
  const bool only_cells = !last.goal && !last.robot;
  return only_cells && last.announced == announced && last.at.move == decision.clock ? &last : nullptr;
}

/// A change of the running mission happens at a step of the robots. Where one has come to its end before, its world stays
/// as it was.
void Session::note_early_ends(std::int64_t clock) {
  for (const auto& each : runs_) {
    if (!each->over() || each->decisions().back().clock >= clock) continue;
    notice_ = {"The robot of " + std::string(each->info().name) + " had ended its drive at step " +
                   std::to_string(each->decisions().back().clock) + ", before this change at step " +
                   std::to_string(clock) + ": its pane shows the world as it was then.",
               false};
    say(notice_.words);
  }
}

Result<void> Session::edit_cells(const std::vector<CellChange>& cells, bool announced, std::uint64_t stroke,
                                 std::string label) {
  if (const auto good = check_inside(cells, scenario_->map); !good) return good;
  const Decision* decision = run().decision_for_edit();
  const std::vector<CellChange> real = real_changes(cells, decision);
  if (real.empty()) return {};
  Scenario changed = *scenario_;
  const bool goes_on = history_.goes_on(stroke);
  stroke_cells_ = real.size() + (goes_on ? stroke_cells_ : 0);
  if (label.empty())
    label = (announced ? real.front().blocked ? "paint " : "erase " : "surprise of ") +
            counted(stroke_cells_, "cell");
  if (goes_on) relabel(label);
  if (decision == nullptr) {
    for (const CellChange& change : real) changed.map.set(change.cell, change.blocked);
  } else {
    Surprise edit;
    edit.at.move = decision->clock;
    edit.announced = announced;
    if (const Surprise* begun = surprise_of_stroke(stroke, *decision, announced)) {
      edit.cells = begun->cells;
      changed.surprises.pop_back();
    }
    add_cells(edit.cells, real);
    changed.surprises.push_back(std::move(edit));
    note_early_ends(decision->clock);
  }
  commit(std::move(label), stroke, std::move(changed));
  return {};
}

PlannerChoice Session::choice_of(const PlannerInfo& info, const PlannerChoice& before) {
  PlannerChoice choice{std::string(info.id), {}, {}};
  const std::vector<Parameter>& parameters = find_choice(before.id)->parameters;
  for (const auto& [key, value] : before.settings.values()) {
    const Parameter *old = find_parameter(parameters, key), *next = find_parameter(info.parameters, key);
    if (old == nullptr || next == nullptr) continue;
    // By its word: of a choice the same number may be another one there.
    if (const auto same = parse_value(*next, format_value(*old, value)); same)
      choice.settings.set(key, *same);
  }
  return choice;
}

Result<void> Session::run_command(const ChoosePlanner& command) {
  const auto info = require_choice(command.id);
  if (!info) return Error{info.error()};
  if (command.pane >= scenario_->planners.size()) return Error{"there is no such pane"};
  PlannerChoice choice = choice_of(**info, scenario_->planners[command.pane]);
  choice.stages = scenario_->planners[command.pane].stages;
  if (const auto fit = fits(info_of(choice), box(), scenario_->robot.radius); !fit) return fit;
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
  const Parameter* parameter = find_parameter(find_choice(choice.id)->parameters, command.key);
  if (parameter == nullptr) return Error{"this planner has no setting '" + command.key + "'"};
  const auto in_force = [&] { return settings_of(choice, scenario_->robot).get(*parameter); };
  if (in_force() == command.value) return {};
  const Result<double> value = parse_value(*parameter, format_value(*parameter, command.value));
  if (!value) return Error{value.error()};
  choice.settings.reset(command.key);
  if (in_force() != *value) choice.settings.set(command.key, *value);
  if (const auto fit = fits(info_of(choice), box(), scenario_->robot.radius); !fit) return fit;
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

Result<void> Session::run_command(const SetStages& command) {
  if (command.pane >= scenario_->planners.size()) return Error{"there is no such pane"};
  for (const StageChoice& stage : command.stages)
    if (const auto known = require_stage(stage.id); !known) return Error{known.error()};
  if (command.stages == scenario_->planners[command.pane].stages) return {};
  Scenario changed = *scenario_;
  changed.planners[command.pane].stages = command.stages;
  commit("change what paths go through", 0, std::move(changed));
  return {};
}

Result<void> Session::run_command(const SetRobot& command) {
  if (command.robot == scenario_->robot) return {};
  if (const auto known = require_robot(command.robot.kind, box()); !known) return Error{known.error()};
  for (const PlannerChoice& choice : scenario_->planners)
    if (const auto fit = fits(info_of(choice), box(), command.robot.radius); !fit) return fit;
  Scenario changed = *scenario_;
  changed.robot = command.robot;
  commit("change the robot", 0, std::move(changed));
  return {};
}

Scenario Session::to_save() const {
  Scenario scenario = tidied(*scenario_, scripted());
  scenario.debug = debug();
  return scenario;
}

bool Session::only_cells_edited() const {
  return kept_ && only_cells_differ(*kept_, tidied(*scenario_, scripted()));
}

// A world that is generated or pasted brings a name of its own, or none.
bool Session::other_world() const {
  return kept_ && kept_->name != scenario_->name;
}

void Session::saved(const std::string& file) {
  file_ = file;
  kept_ = std::make_shared<const Scenario>(tidied(*scenario_, scripted()));
  history_.saved();
  say("saved " + file);
  ++revision_;
}

}  // namespace replan
