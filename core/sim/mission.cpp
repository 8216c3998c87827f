// Algorithm 1 of the DLD* Lite paper from the robot's side. One file although it is long: all members of an
// explicitly instantiated template have to be in one place.
#include "core/sim/mission.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/plan/common_parameters.hpp"
#include "core/sim/nearest.hpp"
#include "core/trace/search_state.hpp"

namespace replan {
namespace {

/// A script may name a step that is farther away than time can be counted.
constexpr SimTime kEndOfTime = std::numeric_limits<SimTime>::max();

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

template <class T>
Mission<T>::Mission(const Scenario& scenario, const PlannerChoice& choice, T& tracer)
    : tr_(tracer),
      info_(std::make_shared<const PlannerInfo>(*find_planner(choice.id))),
      settings_(choice.settings),
      sight_rule_(static_cast<SightRule>(static_cast<int>(choice.settings.get(parameters::kSight)))),
      robot_setup_(scenario.robot),
      surprises_(scenario.surprises),
      crowd_(scenario),
      known_({scenario.map.width, scenario.map.height}, initial_knowledge(scenario).plain(),
             move_rules(choice.settings)),
      truth_(initial_truth(scenario).plain()),
      planner_(make_planner(*info_, known_, settings_, tr_)),
      start_(known_.node(scenario.start)),
      goal_(known_.node(scenario.goal)),
      aim_(goal_) {
  now_.state = MissionState::planning;
  now_.fired.resize(surprises_.size());
  now_.plan = std::make_shared<const Plan>();
  now_.movers = crowd_.initial();
  now_.sightings = std::make_shared<const Sightings>();
}

template <class T>
bool Mission<T>::ended() const {
  return now_.state != MissionState::planning && now_.state != MissionState::driving;
}

template <class T>
bool Mission<T>::settled() const {
  return ended() || (standing() && due_surprise() == surprises_.size() && senses().sense().empty());
}

template <class T>
bool Mission<T>::advance(std::int64_t iterations) {
  if (ended()) return false;
  if (!begun_) begin();
  if (now_.state == MissionState::planning)
    search(iterations);
  else
    decide();
  return !ended();
}

template <class T>
void Mission<T>::begin() {
  begun_ = true;
  tr_.line(101);
  tr_.note(EventKind::plan_begin, start_, 0);
  tr_.change(Scalar::robot, 0, std::uint64_t{start_ + 1u});
  robot_ = start_;
  if (seeks_nearest()) tr_.change(Scalar::wanted, 0, std::uint64_t{goal_ + 1u});
  const Stopwatch watch(now_.figures.plan_ms);
  planner_->begin(start_, goal_);
}

template <class T>
void Mission<T>::search(std::int64_t iterations) {
  {
    const Stopwatch watch(now_.figures.replans == 0 ? now_.figures.plan_ms : now_.figures.replan_ms);
    if (!planner_->advance(iterations)) return;
  }
  plan_stands();
}

template <class T>
void Mission<T>::plan_stands() {
  const PlanStatus status = plan_status();
  follow(planner_->path(), status);
  now_.figures.counters = now_.before_goal + planner_->counters();
  now_.figures.last_plan = planner_->counters() - before_plan_;
  now_.figures.peak_bytes = std::max(now_.figures.peak_bytes, planner_->memory_bytes());
  tr_.note(EventKind::plan_end, robot_, static_cast<std::uint64_t>(status));
  now_.state = MissionState::driving;
  const bool unreachable = status == PlanStatus::no_path || status == PlanStatus::goal_blocked;
  if (unreachable && seeks_nearest()) make_for_nearest();
}

/// A path that is the same as before, as most are that a change elsewhere gave rise to, is not kept twice.
template <class T>
void Mission<T>::follow(const Path& path, PlanStatus status) {
  const bool same = *now_.plan->path == path;
  auto kept = same ? now_.plan->path : std::make_shared<const Path>(path);
  route_ = lay_out(known_, path, sight_rule_);
  const double length = route_.along.empty() ? 0 : route_.along.back();
  now_.plan = std::make_shared<const Plan>(Plan{std::move(kept), status, length});
  now_.next = 0;
  now_.along_plan = 0;
  now_.before = now_.at = centre_of(known_.position(robot_));
  now_.after = point_ahead();
}

template <class T>
PlanePoint Mission<T>::point_ahead() const {
  return now_.next < route_.points.size() ? route_.points[now_.next] : now_.at;
}

template <class T>
PlanStatus Mission<T>::plan_status() const {
  const PlanStatus status = planner_->status();
  return status == PlanStatus::found && aim_ != goal_ ? PlanStatus::found_nearest : status;
}

/// What the robot has to make for on the map as it is now, if that is another cell than before. Whether there
/// is a path to the goal the planner finds out; once it has found none, a flood tells when there is one
/// again.
template <class T>
std::optional<NodeId> Mission<T>::other_aim() {
  if (aim_ == goal_) return std::nullopt;
  const NodeId nearest = nearest_reachable(known_, robot_, goal_);
  if (nearest == aim_) return std::nullopt;
  tr_.note(EventKind::aim, nearest, nearest == goal_ ? 1 : 0);
  return nearest;
}

template <class T>
void Mission<T>::make_for_nearest() {
  const NodeId nearest = nearest_reachable(known_, robot_, goal_);
  tr_.note(EventKind::aim, nearest);
  learn({}, EventKind::sensed, nearest);
}

// Algorithm 1 of the DLD* Lite paper, lines 5-17, from the robot's side.
template <class T>
void Mission<T>::decide() {
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
  if (robot_ == goal_ && plan == PlanStatus::found) {
    if (const auto step = next_scripted_step(true)) return wait_on_goal(*step);
    now_.state = MissionState::arrived;
    tr_.note(EventKind::arrival, robot_);
  } else if (now_.plan->nodes().empty() || (robot_ == aim_ && plan == PlanStatus::found_nearest)) {
    wait_for_change();
  } else {
    drive();
  }
}

template <class T>
std::size_t Mission<T>::due_surprise() const {
  for (std::size_t i = 0; i < surprises_.size(); ++i) {
    if (now_.fired[i]) continue;
    const Trigger& at = surprises_[i].at;
    if (at.move && now_.clock >= *at.move) return i;
    if (!at.near) continue;
    if (distance(*at.near, known_.position(robot_)) <= at.within) return i;
  }
  return surprises_.size();
}

template <class T>
void Mission<T>::happen(std::size_t index) {
  const Surprise& surprise = surprises_[index];
  now_.fired[index] = true;
  tr_.line(108);
  tr_.note(EventKind::surprise, robot_, index);
  std::vector<CellEdit> told = write_cells(surprise);
  if (surprise.robot) {
    feel(robot_, told);
    tr_.note(EventKind::put_down, known_.node(*surprise.robot));
    put_robot(known_.node(*surprise.robot));
    feel(robot_, told);
  }
  if (surprise.goal) {
    const NodeId goal = known_.node(*surprise.goal);
    tr_.note(EventKind::new_goal, goal);
    if (seeks_nearest()) tr_.change(Scalar::wanted, std::uint64_t{goal_ + 1u}, std::uint64_t{goal + 1u});
    goal_ = goal;
    now_.waited = 0;
  }
  if (!told.empty() || surprise.robot || surprise.goal)
    learn(told, EventKind::sensed, surprise.goal ? std::optional(goal_) : std::nullopt);
}

/// A robot that is taken up or put down learns of a wall that it stands in, if it was spared it until then.
template <class T>
void Mission<T>::feel(NodeId cell, std::vector<CellEdit>& told) const {
  const auto told_already = [cell](const CellEdit& edit) { return edit.node == cell; };
  if (robot_setup_.robot_cell_blocks || (truth_[cell] & kWallBit) == 0 || known_.blocked(cell)) return;
  if (std::none_of(told.begin(), told.end(), told_already)) told.push_back({cell, true});
}

/// Changes the world and returns what of it the robot is told.
template <class T>
std::vector<CellEdit> Mission<T>::write_cells(const Surprise& surprise) {
  const bool is_told = surprise.announced || robot_setup_.knowledge == Knowledge::all;
  std::vector<CellEdit> told;
  for (const CellChange& change : surprise.cells) {
    const NodeId node = known_.node(change.cell);
    const auto value =
        static_cast<std::uint8_t>((truth_[node] & ~kWallBit) | (change.blocked ? kWallBit : 0));
    tr_.change(EventKind::truth, node, truth_[node], std::uint64_t{value});
    truth_[node] = value;
    const bool spared = node == robot_ && change.blocked && !robot_setup_.robot_cell_blocks;
    if (is_told && !spared && known_.blocked(node) != change.blocked) told.push_back({node, change.blocked});
  }
  return told;
}

// Lines 9-17. With `afresh_to` the planner forgets what it has and plans to that cell: the goal has moved, or
// there is no path to it; and so it does where another cell has become the one to make for.
template <class T>
void Mission<T>::learn(const std::vector<CellEdit>& edits, EventKind how, std::optional<NodeId> afresh_to) {
  tr_.line(108);
  for (const CellEdit& edit : edits) {
    tr_.note(how, edit.node, edit.blocked ? 1 : 0);
    tr_.change(EventKind::known, edit.node, std::uint64_t{!edit.blocked}, std::uint64_t{edit.blocked});
  }
  if (!crowd_.empty())
    now_.sightings = std::make_shared<const Sightings>(noted(*now_.sightings, edits, truth_));
  const Stopwatch watch(now_.figures.replan_ms);
  const auto moves = known_.apply(edits);
  if (!afresh_to) afresh_to = other_aim();
  before_plan_ = planner_->counters();
  ++now_.figures.replans;
  tr_.line(109);
  tr_.change(Scalar::replans, static_cast<std::uint64_t>(now_.figures.replans - 1),
             static_cast<std::uint64_t>(now_.figures.replans));
  tr_.note(EventKind::plan_begin, robot_, static_cast<std::uint64_t>(now_.figures.replans));
  if (afresh_to) {
    aim_ = *afresh_to;
    now_.before_goal = now_.before_goal + planner_->counters();
    before_plan_ = {};
    planner_->begin(robot_, aim_);
  } else {
    planner_->update({.cells = edits, .moves = moves}, robot_);
  }
  now_.state = MissionState::planning;
}

template <class T>
std::optional<std::int64_t> Mission<T>::next_scripted_step(bool only_goals) const {
  std::optional<std::int64_t> next;
  for (std::size_t i = 0; i < surprises_.size(); ++i)
    if (const auto& at = surprises_[i].at.move; at && !now_.fired[i] && (surprises_[i].goal || !only_goals))
      next = std::min(next.value_or(*at), *at);
  return next;
}

template <class T>
void Mission<T>::wait_for_change() {
  if (!crowd_.empty()) return wait_for_movers();
  const auto next = next_scripted_step(false);
  if (next)
    wait_until(*next);
  else
    give_up(stuck());
}

template <class T>
MissionState Mission<T>::stuck() const {
  return now_.plan->status == PlanStatus::found_nearest ? MissionState::nearest : MissionState::no_path;
}

template <class T>
void Mission<T>::wait_for_movers() {
  if (now_.waited >= now_.forgets_after) {
    if (const std::vector<CellEdit> lost = senses().out_of_sight(*now_.sightings); !lost.empty()) {
      now_.forgets_after *= 2;
      learn(lost, EventKind::forgotten);
      return;
    }
  }
  const auto patience = std::llround(robot_setup_.patience * static_cast<double>(kSecond));
  if (now_.waited >= patience) {
    if (!next_scripted_step(false)) return give_up(stuck());
    if (now_.waited - patience >= kMostWaits * step_time(1)) return give_up(MissionState::endless);
  }
  now_.waited += step_time(1);
  wait_until(now_.clock + 1);
}

/// For the goal to move on.
template <class T>
void Mission<T>::wait_on_goal(std::int64_t clock) {
  if (!crowd_.empty()) {
    if (now_.waited >= kMostWaits * step_time(1)) return give_up(MissionState::endless);
    now_.waited += step_time(1);
  }
  wait_until(clock);
}

/// Where nothing moves nothing can change before the next scripted step, so the robot waits until then at
/// once.
template <class T>
void Mission<T>::wait_until(std::int64_t clock) {
  const std::int64_t steps = crowd_.empty() ? clock - now_.clock : 1;
  tr_.note(EventKind::waiting, robot_, static_cast<std::uint64_t>(steps));
  const SimTime step = step_time(1);
  advance_clock(steps, steps < kEndOfTime / step ? steps * step : kEndOfTime, robot_);
}

template <class T>
void Mission<T>::give_up(MissionState state) {
  now_.state = state;
  tr_.note(EventKind::gave_up, robot_, static_cast<std::uint64_t>(state));
}

template <class T>
SimTime Mission<T>::step_time(double way) const {
  const double length = robot_setup_.motion == Motion::smooth ? way : 1;
  return std::llround(static_cast<double>(kSecond) * length / robot_setup_.speed);
}

/// Lets time go by while the robot goes over from the cell `left`.
template <class T>
void Mission<T>::advance_clock(std::int64_t steps, SimTime time, NodeId left) {
  tr_.change(Scalar::moves, static_cast<std::uint64_t>(now_.clock),
             static_cast<std::uint64_t>(now_.clock + steps));
  now_.clock += steps;
  now_.time += std::min(time, kEndOfTime - now_.time);
  if (crowd_.empty()) return;
  const Cell keep_clear[] = {known_.position(robot_), known_.position(left)};
  for (const Crowd::Change& change : crowd_.advance(now_.movers, now_.time, now_.clock, keep_clear)) {
    const NodeId node = known_.node(change.cell);
    const auto value = static_cast<std::uint8_t>(truth_[node] + change.by * kMoverUnit);
    tr_.change(EventKind::truth, node, truth_[node], std::uint64_t{value});
    truth_[node] = value;
  }
}

template <class T>
void Mission<T>::drive() {
  if (now_.next >= route_.cells.size())  // a circle has been driven to its end
    return give_up(MissionState::loop);
  if (!crowd_.empty() && now_.figures.moves > kMovesPerCell * static_cast<std::int64_t>(truth_.size()))
    return give_up(MissionState::endless);
  enter(route_.cells[now_.next]);
}

// Lines 6 and 7.
template <class T>
void Mission<T>::enter(NodeId cell) {
  tr_.line(107);
  if (truth_[cell] != 0) {
    ++now_.figures.collisions;
    now_.state = MissionState::collision;
    tr_.note(EventKind::collision, cell);
    return;
  }
  tr_.note(EventKind::move, cell);
  const NodeId left = robot_;
  put_robot(cell);
  const double way = route_.along[now_.next] - now_.along_plan;
  now_.figures.travelled += way;
  ++now_.figures.moves;
  now_.along_plan = route_.along[now_.next];
  now_.before = now_.at;
  now_.at = now_.after;
  ++now_.next;
  now_.after = point_ahead();
  now_.waited = 0;
  advance_clock(1, step_time(way), left);
}

template <class T>
void Mission<T>::put_robot(NodeId cell) {
  tr_.change(Scalar::robot, std::uint64_t{robot_ + 1u}, std::uint64_t{cell + 1u});
  robot_ = cell;
}

template <class T>
void Mission<T>::set_surprises(Surprises surprises) {
  surprises_ = std::move(surprises);
  now_.fired.resize(surprises_.size());
  if (ended() && due_surprise() < surprises_.size()) now_.state = MissionState::driving;
}

template <class T>
void Mission<T>::restore(const Checkpoint& checkpoint, const SearchState& state) {
  now_ = checkpoint.now;
  now_.fired.resize(surprises_.size());  // the script may have grown since
  before_plan_ = checkpoint.before_plan;
  for (NodeId node = 0; node < truth_.size(); ++node)
    truth_[node] = static_cast<std::uint8_t>(state.value(EventKind::truth, node));
  known_ = Grid2(known_.size(), state.known_map().plain(), known_.rules());
  planner_ = make_planner(*info_, known_, settings_, tr_);
  planner_->restore(state, checkpoint.planner);
  robot_ = state.node(Scalar::robot);
  aim_ = state.node(Scalar::goal);
  goal_ = state.wanted_goal();
  route_ = lay_out(known_, *now_.plan->path, sight_rule_);
  begun_ = true;
}

template class Mission<NoTrace>;
template class Mission<Recorder>;

}  // namespace replan
