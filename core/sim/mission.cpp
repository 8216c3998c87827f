// Algorithm 1 of the DLD* Lite paper from the robot's side: planning, learning, deciding. What it does when it
// goes on or waits is in mission_steps.cpp.
#include "core/sim/mission.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/world/choices.hpp"

namespace replan {
namespace {

class Stopwatch {
 public:
  explicit Stopwatch(double& milliseconds) : total_(milliseconds) {}
  ~Stopwatch() {
    total_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& total_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

const char* mission_state_name(MissionState state) {
  switch (state) {
    case MissionState::planning:
      return "planning";
    case MissionState::driving:
      return "driving";
    case MissionState::arrived:
      return "arrived";
    case MissionState::no_path:
      return "no-path";
    case MissionState::collision:
      return "collision";
    case MissionState::loop:
      return "loop";
    case MissionState::endless:
      return "endless";
    case MissionState::nearest:
      return "nearest";
    case MissionState::stuck:
      return "stuck";
  }
  return "";
}

SharedBytes initial_knowledge(const Scenario& scenario, bool all_mapped) {
  const SharedBytes& cells = scenario.map.blocked;
  const auto on_map = [&] {
    if (scenario.robot.knowledge == Knowledge::nothing) return SharedBytes(cells.size());
    if (all_mapped) return cells;
    return with_unmapped_as(cells, scenario.robot.knowledge == Knowledge::all ? kObstacle : kFree);
  };
  SharedBytes known = on_map();
  // It feels where it stands.
  if (scenario.map.at(scenario.start)) known[scenario.map.index(scenario.start)] = 1;
  return known;
}

SearchState initial_state(const Scenario& scenario, const PlannerChoice& choice, bool all_mapped) {
  return {initial_knowledge(scenario, all_mapped), initial_truth(scenario, all_mapped),
          info_of(choice).values.all_fields()};
}

Mission::Mission(const Scenario& scenario, const PlannerChoice& choice, Recorder* recorder)
    : tr_(recorder),
      robot_setup_(scenario.robot),
      surprises_(scenario.surprises),
      crowd_(scenario),
      box_(scenario.map.box()),
      truth_(initial_truth(scenario).plain()),
      navigator_(make_navigator(choice, box_, initial_knowledge(scenario), scenario.robot.radius, recorder)),
      start_(box_.node(scenario.start)),
      goal_(box_.node(scenario.goal)),
      aim_(goal_) {
  now_.state = MissionState::planning;
  now_.fired.resize(surprises_.size());
  now_.plan = std::make_shared<const Plan>();
  now_.movers = crowd_.initial();
  now_.sightings = std::make_shared<const Sightings>();
}

bool Mission::ended() const {
  return now_.state != MissionState::planning && now_.state != MissionState::driving;
}

bool Mission::settled() const {
  if (ended()) return true;
  return standing() && due_surprise() == surprises_.size() && senses().sense().empty() && !arrives();
}

bool Mission::arrives() const {
  return is_at(goal_) && now_.plan->status == PlanStatus::found && !next_scripted_step(true);
}

bool Mission::advance(std::int64_t iterations) {
  if (ended()) return false;
  if (!begun_) {  // by itself, so that the run can be taken up behind what a planner sets up
    begin();
    return true;
  }
  if (now_.state == MissionState::planning)
    search(iterations);
  else
    decide();
  return !ended();
}

void Mission::begin() {
  begun_ = true;
  tr_.line(101);
  tr_.note(EventKind::plan_begin, start_, 0);
  tr_.change(Scalar::robot, 0, std::uint64_t{start_ + 1u});
  robot_ = start_;
  look_ahead();
  if (seeks_nearest()) tr_.change(Scalar::wanted, 0, std::uint64_t{goal_ + 1u});
  const Stopwatch watch(now_.figures.plan_ms);
  navigator_->begin(point(start_), point(goal_));
}

void Mission::search(std::int64_t iterations) {
  {
    const Stopwatch watch(now_.figures.replans == 0 ? now_.figures.plan_ms : now_.figures.replan_ms);
    if (!navigator_->advance(iterations)) return;
  }
  plan_stands();
}

void Mission::plan_stands() {
  const PlanStatus status = plan_status();
  follow(navigator_->path(), status);
  now_.figures.counters = now_.before_goal + navigator_->counters();
  now_.figures.last_plan = navigator_->counters() - before_plan_;
  now_.figures.peak_bytes = std::max(now_.figures.peak_bytes, navigator_->memory_bytes());
  tr_.note(EventKind::plan_end, robot_, static_cast<std::uint64_t>(status));
  now_.state = MissionState::driving;
  if (may_be_unreachable(status) && seeks_nearest()) make_for_nearest();
}

/// A path that is the same as before, as most are that a change elsewhere gave rise to, is not kept twice.
void Mission::follow(const Path& path, PlanStatus status) {
  const bool same = *now_.plan->path == path;
  auto kept = same ? now_.plan->path : std::make_shared<const Path>(path);
  route_ = lay_out(box_, navigator_->known(), path);
  const double length = route_.along.empty() ? 0 : route_.along.back();
  now_.plan = std::make_shared<const Plan>(Plan{std::move(kept), status, length});
  if (!now_.first_path && !path.empty()) now_.first_path = now_.plan->path;
  now_.next = 0;
  now_.along_plan = 0;
  now_.drive.sub_goal = 0;
  now_.before = now_.at = now_.drive.begun ? now_.at : point(robot_);
  now_.after = point_ahead();
}

Point Mission::point_ahead() const {
  return now_.next < route_.points.size() ? route_.points[now_.next] : now_.at;
}

PlanStatus Mission::plan_status() const {
  const PlanStatus status = navigator_->status();
  return status == PlanStatus::found && aim_ != goal_ ? PlanStatus::found_nearest : status;
}

/// What the robot has to make for on the map as it is now, if that is another cell than before. Whether there
/// is a path to the goal the planner finds out; once it has found none, a flood tells when there is one
/// again.
std::optional<NodeId> Mission::other_aim() {
  if (aim_ == goal_) return std::nullopt;
  const NodeId nearest = navigator_->nearest_reachable(robot_, goal_);
  if (nearest == aim_) return std::nullopt;
  tr_.note(EventKind::aim, nearest, nearest == goal_ ? 1 : 0);
  return nearest;
}

void Mission::make_for_nearest() {
  const NodeId nearest = navigator_->nearest_reachable(robot_, goal_);
  if (nearest == goal_ || nearest == aim_) return;  // there is a way, which samples have missed
  tr_.note(EventKind::aim, nearest);
  learn({}, EventKind::sensed, nearest);
}

// Algorithm 1 of the DLD* Lite paper, lines 5-17, from the robot's side.
void Mission::decide() {
  if (const std::size_t index = due_surprise(); index < surprises_.size()) {
    happen(index);
    return;
  }
  if (const std::vector<CellEdit> seen = senses().sense(); !seen.empty()) {
    learn(seen, EventKind::sensed);
    return;
  }
  tr_.line(105);
  const PlanStatus plan = now_.plan->status;
  if (is_at(goal_) && plan == PlanStatus::found) {
    if (const auto step = next_scripted_step(true)) {
      if (stands()) wait_on_goal(*step);
      return;
    }
    now_.state = MissionState::arrived;
    tr_.note(EventKind::arrival, robot_);
  } else if (now_.plan->path->empty() || (is_at(aim_) && plan == PlanStatus::found_nearest)) {
    if (stands()) wait_for_change();
  } else {
    move();
  }
}

std::size_t Mission::due_surprise() const {
  for (std::size_t i = 0; i < surprises_.size(); ++i) {
    if (now_.fired[i]) continue;
    const Trigger& at = surprises_[i].at;
    if (at.move && now_.clock >= *at.move) return i;
    if (!at.near) continue;
    if (distance(*at.near, box_.position(robot_)) <= at.within) return i;
  }
  return surprises_.size();
}

void Mission::happen(std::size_t index) {
  const Surprise& surprise = surprises_[index];
  now_.fired[index] = true;
  tr_.line(108);
  tr_.note(EventKind::surprise, robot_, index);
  std::vector<CellEdit> told = write_cells(surprise);
  if (surprise.robot) {
    feel(robot_, told);
    tr_.note(EventKind::put_down, box_.node(*surprise.robot));
    put_robot(box_.node(*surprise.robot));
    now_.drive.begun = false;
    now_.drive.begin_to_count_progress();
    feel(robot_, told);
  }
  if (surprise.goal) {
    const NodeId goal = box_.node(*surprise.goal);
    tr_.note(EventKind::new_goal, goal);
    if (seeks_nearest()) tr_.change(Scalar::wanted, std::uint64_t{goal_ + 1u}, std::uint64_t{goal + 1u});
    goal_ = goal;
    now_.waited = 0;
  }
  if (surprise.robot) look_ahead();
  if (surprise.robot || surprise.goal) notice(index);
  if (!told.empty() || surprise.robot || surprise.goal)
    learn(told, EventKind::sensed, surprise.goal ? std::optional(goal_) : std::nullopt);
}

/// As when it sets out.
void Mission::look_ahead() {
  now_.course = first_course(robot_setup_, point(robot_), point(goal_));
}

/// A robot that is taken up or put down learns of a wall that it stands in, if it was spared it until then.
void Mission::feel(NodeId cell, std::vector<CellEdit>& told) const {
  const auto told_already = [cell](const CellEdit& edit) { return edit.node == cell; };
  if (robot_setup_.robot_cell_blocks || (truth_[cell] & kWallBit) == 0 || blocked(cell)) return;
  if (std::none_of(told.begin(), told.end(), told_already)) told.push_back({cell, true});
}

/// Changes the world and returns what of it the robot is told.
std::vector<CellEdit> Mission::write_cells(const Surprise& surprise) {
  const bool is_told = surprise.announced || robot_setup_.knowledge == Knowledge::all;
  std::vector<CellEdit> told;
  for (const CellChange& change : surprise.cells) {
    const NodeId node = box_.node(change.cell);
    const auto value =
        static_cast<std::uint8_t>((truth_[node] & ~kWallBit) | (change.blocked ? kWallBit : 0));
    tr_.change(EventKind::truth, node, truth_[node], std::uint64_t{value});
    truth_[node] = value;
    const bool spared = node == robot_ && change.blocked && !robot_setup_.robot_cell_blocks;
    if (is_told && !spared && blocked(node) != change.blocked) told.push_back({node, change.blocked});
  }
  return told;
}

// Lines 9-17. With `afresh_to` the planner forgets what it has and plans to that cell: the goal has moved, or
// there is no path to it; and so it does where another cell has become the one to make for.
void Mission::learn(const std::vector<CellEdit>& edits, EventKind how, std::optional<NodeId> afresh_to) {
  tr_.line(108);
  for (const CellEdit& edit : edits) {
    tr_.note(how, edit.node, edit.blocked ? 1 : 0);
    tr_.change(EventKind::known, edit.node, std::uint64_t{!edit.blocked}, std::uint64_t{edit.blocked});
  }
  if (how == EventKind::sensed) notice_surprises(edits);
  if (!crowd_.empty())
    now_.sightings = std::make_shared<const Sightings>(noted(*now_.sightings, edits, truth_));
  const Stopwatch watch(now_.figures.replan_ms);
  navigator_->learn(edits);
  if (!afresh_to) afresh_to = other_aim();
  // Another map may ask for a longer way; planning again on the same one, or blindly, is no progress.
  if ((!edits.empty() && !navigator_->blind()) || afresh_to) now_.drive.begin_to_count_progress();
  before_plan_ = navigator_->counters();
  ++now_.figures.replans;
  tr_.line(109);
  tr_.change(Scalar::replans, static_cast<std::uint64_t>(now_.figures.replans - 1),
             static_cast<std::uint64_t>(now_.figures.replans));
  tr_.note(EventKind::plan_begin, robot_, static_cast<std::uint64_t>(now_.figures.replans));
  if (afresh_to) {
    aim_ = *afresh_to;
    now_.before_goal = now_.before_goal + navigator_->counters();
    before_plan_ = {};
    navigator_->begin(point(robot_), point(aim_));
  } else {
    navigator_->update(point(robot_));
  }
  now_.state = MissionState::planning;
}

void Mission::set_surprises(Surprises surprises) {
  surprises_ = std::move(surprises);
  now_.fired.resize(surprises_.size());
  if (ended() && due_surprise() < surprises_.size()) now_.state = MissionState::driving;
}

void Mission::restore(const Checkpoint& checkpoint, const SearchState& state) {
  now_ = checkpoint.now;
  now_.fired.resize(surprises_.size());  // the script may have grown since
  before_plan_ = checkpoint.before_plan;
  for (NodeId node = 0; node < truth_.size(); ++node)
    truth_[node] = static_cast<std::uint8_t>(state.value(EventKind::truth, node));
  navigator_->restore(state, checkpoint.planner);
  robot_ = state.node(Scalar::robot);
  aim_ = state.node(Scalar::goal);
  goal_ = state.wanted_goal();
  route_ = lay_out(box_, navigator_->known(), *now_.plan->path);
  begun_ = true;
}

}  // namespace replan
