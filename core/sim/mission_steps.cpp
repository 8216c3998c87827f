// What a robot does once it has decided: it takes a step, waits, or gives up; and with each the time that goes by. And which
// surprises it knows of.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/lattice/inflation.hpp"
#include "core/sim/body.hpp"
#include "core/sim/mission.hpp"

namespace replan {
namespace {

/// A script may name a step that is farther away than time can be counted.
constexpr SimTime kEndOfTime = std::numeric_limits<SimTime>::max();

}  // namespace

std::optional<std::int64_t> Mission::next_scripted_step(bool only_goals) const {
  std::optional<std::int64_t> next;
  for (std::size_t i = 0; i < surprises_.size(); ++i)
    if (const auto& at = surprises_[i].at.move; at && !now_.fired[i] && (surprises_[i].goal || !only_goals))
      next = std::min(next.value_or(*at), *at);
  return next;
}

void Mission::wait_for_change() {
  if (!crowd_.empty()) return wait_for_movers();
  const auto next = next_scripted_step(false);
  if (next)
    wait_until(*next);
  else
    give_up(stuck());
}

MissionState Mission::stuck() const {
  return now_.plan->status == PlanStatus::found_nearest ? MissionState::nearest : MissionState::no_path;
}

void Mission::wait_for_movers() {
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
void Mission::wait_on_goal(std::int64_t clock) {
  if (!crowd_.empty()) {
    if (now_.waited >= kMostWaits * step_time(1)) return give_up(MissionState::endless);
    now_.waited += step_time(1);
  }
  wait_until(clock);
}

/// Where nothing moves nothing can change before the next scripted step, so the robot waits until then at
/// once.
void Mission::wait_until(std::int64_t clock) {
  const std::int64_t steps = crowd_.empty() ? clock - now_.clock : 1;
  tr_.note(EventKind::waiting, robot_, static_cast<std::uint64_t>(steps));
  now_.drive.begin_to_count_progress();
  const SimTime step = step_time(1);
  advance_clock(steps, steps < kEndOfTime / step ? steps * step : kEndOfTime, robot_);
}

void Mission::give_up(MissionState state) {
  now_.state = state;
  tr_.note(EventKind::gave_up, robot_, static_cast<std::uint64_t>(state));
}

SimTime Mission::step_time(double way) const {
  const double length = robot_setup_.motion == Motion::smooth ? way : 1;
  return std::llround(static_cast<double>(kSecond) * length / robot_setup_.speed);
}

/// Lets time go by while the robot goes over from the cell `left`.
void Mission::advance_clock(std::int64_t steps, SimTime time, NodeId left, std::span<const Point> along) {
  tr_.change(Scalar::moves, static_cast<std::uint64_t>(now_.clock),
             static_cast<std::uint64_t>(now_.clock + steps));
  now_.clock += steps;
  now_.time += std::min(time, kEndOfTime - now_.time);
  if (crowd_.empty()) return;
  const std::vector<Cell> keep_clear = covered_cells(left, along);
  for (const Crowd::Change& change : crowd_.advance(now_.movers, now_.time, now_.clock, keep_clear)) {
    const NodeId node = box_.node(change.cell);
    const auto value = static_cast<std::uint8_t>(truth_[node] + change.by * kMoverUnit);
    tr_.change(EventKind::truth, node, truth_[node], std::uint64_t{value});
    truth_[node] = value;
  }
}

double Mission::clearance_of(std::span<const Point> way, double farthest) const {
  for (std::size_t i = 1; i < way.size(); ++i)
    farthest = std::sqrt(Body(box_, farthest, way[i - 1], way[i]).nearest(truth_));
  return farthest;
}

bool Mission::goes_on_for_ever() const {
  const std::int64_t turns = now_.figures.kept.value_or(KeptWay{}).stops;
  return !crowd_.empty() &&
         now_.figures.moves + turns > kMovesPerCell * static_cast<std::int64_t>(truth_.size());
}

void Mission::step_along(std::size_t cells, std::optional<SimTime> time) {
  if (now_.next >= route_.cells.size())  // a circle has been driven to its end
    return give_up(MissionState::loop);
  if (goes_on_for_ever()) return give_up(MissionState::endless);
  const std::size_t last = std::min(now_.next + cells, route_.cells.size()) - 1;
  tr_.line(107);
  std::vector<Point> way = {now_.at};
  for (std::size_t i = now_.next; i <= last; ++i) {
    const std::vector<Point> part = route_.way_to(*now_.plan->path, i, way.back()).points;
    if (truth_[route_.cells[i]] != 0 || hits(box_, truth_, robot_setup_.radius, part))
      return collide(route_.cells[i]);
    way.insert(way.end(), part.begin() + 1, part.end());
  }
  enter(last, way, time);
}

void Mission::turn_on_the_spot(const Course& course, SimTime time) {
  if (goes_on_for_ever()) return give_up(MissionState::endless);
  tr_.line(107);
  const double angle = angle_between(now_.course, course);
  tr_.note(EventKind::turn, robot_, static_cast<std::uint64_t>(std::llround(angle * 180 / kPi)));
  KeptWay kept = now_.figures.kept.value_or(KeptWay{});
  ++kept.stops;
  kept.turning += time;
  kept.turned += angle;
  now_.figures.kept = kept;
  now_.course = course;
  now_.before = now_.at;
  advance_clock(1, time, robot_);
}

/// The cells that the robot takes up on its way from the cell `left` to its own, which has the corners of `along`:
/// nothing comes onto them. It may plan from the middle of its cell next, so that its body there is counted too, and
/// exactly, as its map is grown.
std::vector<Cell> Mission::covered_cells(NodeId left, std::span<const Point> along) const {
  std::vector<Cell> cells = {box_.position(robot_), box_.position(left)};
  const auto add = [&](const Point& from, const Point& to) {
    Body(box_, robot_setup_.radius, from, to).each_cell([&](NodeId node, double) {
      cells.push_back(box_.position(node));
    });
  };
  add(now_.before, now_.at);
  for (std::size_t i = 1; i < along.size(); ++i) add(along[i - 1], along[i]);
  Point at = now_.at;
  for (const Point& next : stopping_way()) {
    cells.push_back(cell_of(next));
    add(at, next);
    at = next;
  }
  if (robot_setup_.radius <= 0) return cells;
  const std::int64_t limit = limit_of(robot_setup_.radius);
  const Cell own = cells.front();
  box_.each_cell_around(own, static_cast<int>(std::ceil(robot_setup_.radius)), [&](NodeId node) {
    const Cell cell = box_.position(node);
    if (quarters_of(std::array{cell.x - own.x, cell.y - own.y, cell.z - own.z}) < limit)
      cells.push_back(cell);
  });
  return cells;
}

void Mission::drive_on(std::span<const Point> points, double way, SimTime time) {
  tr_.line(107);
  const NodeId left = robot_;
  Point at = now_.at;
  for (const Point& next : points) {
    if (!box_.contains(cell_of(next))) return collide(robot_);
    const NodeId cell = box_.node(cell_of(next));
    const bool enters = cell != left && truth_[cell] != 0;  // what came onto its own cell it may leave
    if (enters || hits(box_, truth_, robot_setup_.radius, at, next)) return collide(cell);
    at = next;
  }
  const NodeId cell = box_.node(cell_of(at));
  tr_.note(EventKind::move, cell);
  put_robot(cell);
  now_.figures.travelled += way;
  ++now_.figures.moves;
  now_.before = now_.at;
  now_.at = at;
  now_.waited = 0;
  advance_clock(1, time, left);
}

void Mission::collide(NodeId cell) {
  ++now_.figures.collisions;
  now_.state = MissionState::collision;
  tr_.note(EventKind::collision, cell);
}

// Lines 6 and 7: the robot goes on to a cell of its route.
void Mission::enter(std::size_t on_route, std::span<const Point> along, std::optional<SimTime> time) {
  const NodeId cell = route_.cells[on_route], left = robot_;
  tr_.note(EventKind::move, cell);
  put_robot(cell);
  const double way = route_.along[on_route] - now_.along_plan;
  now_.figures.travelled += way;
  ++now_.figures.moves;
  now_.along_plan = route_.along[on_route];
  now_.before = now_.at;
  now_.at = route_.points[on_route];
  if (now_.at != now_.before) now_.course = course_towards(now_.before, now_.at);
  now_.next = on_route + 1;
  now_.after = point_ahead();
  now_.waited = 0;
  advance_clock(1, time.value_or(step_time(way)), left, along);
}

void Mission::put_robot(NodeId cell) {
  tr_.change(Scalar::robot, std::uint64_t{robot_ + 1u}, std::uint64_t{cell + 1u});
  robot_ = cell;
}

void Mission::notice(std::size_t index) {
  if (now_.noticed.size() <= index) now_.noticed.resize(surprises_.size());
  now_.noticed[index] = true;
}

/// It knows of a surprise once one cell comes onto its map as that has left it.
void Mission::notice_surprises(const std::vector<CellEdit>& edits) {
  for (std::size_t i = 0; i < surprises_.size(); ++i) {
    if (!now_.fired[i] || (i < now_.noticed.size() && now_.noticed[i])) continue;
    const std::vector<CellChange>& cells = std::as_const(surprises_)[i].cells;
    const auto is_its_own = [&](const CellEdit& edit) {
      const Cell cell = box_.position(edit.node);
      const auto at = std::lower_bound(
          cells.begin(), cells.end(), cell,
          [](const CellChange& change, Cell sought) { return in_node_order(change.cell, sought); });
      return at != cells.end() && at->cell == cell && at->blocked == edit.blocked;
    };
    if (std::any_of(edits.begin(), edits.end(), is_its_own)) notice(i);
  }
}

}  // namespace replan
