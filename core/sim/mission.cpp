#include "core/sim/mission.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/plan/common_parameters.hpp"
#include "core/trace/search_state.hpp"

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

Counters operator-(const Counters& a, const Counters& b) {
  return {a.expansions - b.expansions, a.queue_operations - b.queue_operations,
          a.sight_checks - b.sight_checks};
}

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
  }
  return "";
}

std::vector<std::uint8_t> initial_knowledge(const Scenario& scenario) {
  std::vector<std::uint8_t> known(scenario.map.blocked.size());
  if (scenario.robot.knowledge == Knowledge::nothing) return known;
  const bool all = scenario.robot.knowledge == Knowledge::all;
  std::transform(scenario.map.blocked.begin(), scenario.map.blocked.end(), known.begin(),
                 [all](std::uint8_t cell) { return cell == kObstacle || (all && cell == kUnmapped); });
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
      known_({scenario.map.width, scenario.map.height}, initial_knowledge(scenario),
             move_rules(choice.settings)),
      truth_(scenario.map.blocked),
      planner_(make_planner(*info_, known_, settings_, tr_)),
      start_(known_.node(scenario.start)),
      goal_(known_.node(scenario.goal)) {
  now_.state = MissionState::planning;
  now_.fired.resize(surprises_.size());
  now_.route = std::make_shared<const Route>();
}

template <class T>
bool Mission<T>::ended() const {
  return now_.state == MissionState::arrived || now_.state == MissionState::no_path ||
         now_.state == MissionState::collision || now_.state == MissionState::loop;
}

template <class T>
bool Mission<T>::settled() const {
  return ended() || (standing() && due_surprise() == surprises_.size() && sense().empty());
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
  const PlanStatus status = planner_->status();
  now_.route = std::make_shared<const Route>(lay_out(known_, planner_->path(), status, sight_rule_));
  now_.next = 0;
  now_.figures.counters = planner_->counters();
  now_.figures.last_plan = now_.figures.counters - before_plan_;
  tr_.note(EventKind::plan_end, robot_, static_cast<std::uint64_t>(status));
  now_.state = MissionState::driving;
}

// Algorithm 1 of the DLD* Lite paper, lines 5-17, from the robot's side.
template <class T>
void Mission<T>::decide() {
  if (const std::size_t index = due_surprise(); index < surprises_.size()) {
    happen(index);
    return;
  }
  if (std::vector<CellEdit> seen = sense(); !seen.empty()) {
    learn(std::move(seen));
    return;
  }
  tr_.line(105);
  if (robot_ == goal_ && now_.route->status == PlanStatus::found) {
    now_.state = MissionState::arrived;
    tr_.note(EventKind::arrival, robot_);
  } else if (now_.route->path.nodes.empty()) {
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
    const Cell robot = known_.position(robot_);
    if (std::hypot(at.near->x - robot.x, at.near->y - robot.y) <= at.within) return i;
  }
  return surprises_.size();
}

template <class T>
void Mission<T>::happen(std::size_t index) {
  const Surprise& surprise = surprises_[index];
  now_.fired[index] = true;
  tr_.line(108);
  tr_.note(EventKind::surprise, robot_, index);
  std::vector<CellEdit> told;
  for (const CellChange& change : surprise.cells) {
    const NodeId node = known_.node(change.cell);
    const std::uint8_t value = change.blocked ? 1 : 0;
    tr_.change(EventKind::truth, node, truth_[node], std::uint64_t{value});
    truth_[node] = value;
    const bool is_told = surprise.announced || robot_setup_.knowledge == Knowledge::all;
    if (is_told && known_.blocked(node) != change.blocked) told.push_back({node, change.blocked});
  }
  if (!told.empty()) learn(std::move(told));
}

template <class T>
std::vector<CellEdit> Mission<T>::sense() const {
  std::vector<CellEdit> seen;
  const Cell at = known_.position(robot_);
  const int reach = std::max(1, static_cast<int>(robot_setup_.sensor_radius));
  const double squared = robot_setup_.sensor_radius * robot_setup_.sensor_radius;
  for (int y = std::max(0, at.y - reach); y <= std::min(known_.height() - 1, at.y + reach); ++y)
    for (int x = std::max(0, at.x - reach); x <= std::min(known_.width() - 1, at.x + reach); ++x) {
      const NodeId node = known_.node(Cell{x, y});
      const int dx = x - at.x, dy = y - at.y;
      const bool felt = std::abs(dx) <= 1 && std::abs(dy) <= 1;
      if (!felt && dx * dx + dy * dy > squared) continue;
      const bool blocked = truth_[node] != 0;
      if (blocked == known_.blocked(node)) continue;
      if (!felt && robot_setup_.sensor_blocked &&
          !walk_supercover(known_, robot_, node, [&](NodeId n, int) { return n == node || truth_[n] == 0; }))
        continue;
      seen.push_back({node, blocked});
    }
  return seen;
}

// Lines 9-17.
template <class T>
void Mission<T>::learn(std::vector<CellEdit> edits) {
  tr_.line(108);
  for (const CellEdit& edit : edits) {
    tr_.note(EventKind::sensed, edit.node, edit.blocked ? 1 : 0);
    tr_.change(EventKind::known, edit.node, std::uint64_t{!edit.blocked}, std::uint64_t{edit.blocked});
  }
  before_plan_ = planner_->counters();
  ++now_.figures.replans;
  tr_.line(109);
  tr_.change(Scalar::replans, static_cast<std::uint64_t>(now_.figures.replans - 1),
             static_cast<std::uint64_t>(now_.figures.replans));
  tr_.note(EventKind::plan_begin, robot_, static_cast<std::uint64_t>(now_.figures.replans));
  const Stopwatch watch(now_.figures.replan_ms);
  const auto moves = known_.apply(edits);
  planner_->update({.cells = edits, .moves = moves}, robot_);
  now_.state = MissionState::planning;
}

// Nothing can change before the next scripted step, so the robot waits until then at once.
template <class T>
void Mission<T>::wait_for_change() {
  std::int64_t next = -1;
  for (std::size_t i = 0; i < surprises_.size(); ++i)
    if (const auto& at = surprises_[i].at.move; at && !now_.fired[i] && (next < 0 || *at < next)) next = *at;
  if (next < 0) {
    give_up(MissionState::no_path);
    return;
  }
  tr_.note(EventKind::waiting, robot_, static_cast<std::uint64_t>(next - now_.clock));
  advance_clock(next - now_.clock);
}

template <class T>
void Mission<T>::give_up(MissionState state) {
  now_.state = state;
  tr_.note(EventKind::gave_up, robot_, static_cast<std::uint64_t>(state));
}

template <class T>
void Mission<T>::advance_clock(std::int64_t steps) {
  tr_.change(Scalar::moves, static_cast<std::uint64_t>(now_.clock),
             static_cast<std::uint64_t>(now_.clock + steps));
  now_.clock += steps;
}

template <class T>
void Mission<T>::drive() {
  if (now_.next >= now_.route->cells.size()) {  // a circle has been driven to its end
    give_up(MissionState::loop);
    return;
  }
  enter(now_.route->cells[now_.next]);
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
  tr_.change(Scalar::robot, std::uint64_t{robot_ + 1u}, std::uint64_t{cell + 1u});
  const double before = now_.next == 0 ? 0 : now_.route->along[now_.next - 1];
  now_.figures.travelled += now_.route->along[now_.next] - before;
  ++now_.figures.moves;
  ++now_.next;
  robot_ = cell;
  advance_clock(1);
}

template <class T>
void Mission<T>::set_surprises(std::vector<Surprise> surprises) {
  surprises_ = std::move(surprises);
  now_.fired.resize(surprises_.size());
  if (ended() && due_surprise() < surprises_.size()) now_.state = MissionState::driving;
}

template <class T>
void Mission<T>::restore(const Mark& mark, const SearchState& state) {
  now_ = mark;
  std::vector<std::uint8_t> known(truth_.size());
  for (NodeId node = 0; node < truth_.size(); ++node) {
    known[node] = state.known_blocked(node) ? 1 : 0;
    truth_[node] = state.truly_blocked(node) ? 1 : 0;
  }
  known_ = Grid2(known_.size(), std::move(known), known_.rules());
  planner_ = make_planner(*info_, known_, settings_, tr_);
  planner_->restore(state, mark.figures.counters);
  robot_ = state.node(Scalar::robot);
  begun_ = true;
}

template class Mission<NoTrace>;
template class Mission<Recorder>;

}  // namespace replan
