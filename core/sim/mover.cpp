#include "core/sim/mover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/world/brush.hpp"

namespace replan {
namespace {

/// From `from` to `to` without `from`, each cell next to the one before.
void append_line(Cell from, Cell to, std::vector<Cell>& cells) {
  const std::vector<Cell> line = line_cells(from, to);
  cells.insert(cells.end(), line.begin() + 1, line.end());
}

}  // namespace

std::vector<Cell> cells_of_way(const std::vector<Cell>& corners) {
  std::vector<Cell> cells;
  if (!corners.empty()) cells.push_back(corners.front());
  for (std::size_t i = 1; i < corners.size(); ++i) append_line(corners[i - 1], corners[i], cells);
  return cells;
}

Mover::Mover(const MovingObstacle& setup)
    : cells_(cells_of_way(setup.way)),
      width_(setup.width),
      height_(setup.height),
      depth_(setup.depth),
      at_end_(setup.at_end),
      pace_(std::max<SimTime>(1, std::llround(static_cast<double>(kSecond) / setup.speed))),
      from_(setup.from) {
  if (at_end_ == WayEnd::loop && cells_.size() > 1) {
    append_line(setup.way.back(), setup.way.front(), cells_);
    if (cells_.size() > 1) cells_.pop_back();  // the beginning comes round by itself
  }
}

Cell Mover::at(std::int64_t steps) const {
  const auto count = static_cast<std::int64_t>(cells_.size());
  std::int64_t index = steps;
  if (at_end_ == WayEnd::loop) {
    index = steps % count;
  } else if (at_end_ == WayEnd::stop || count == 1) {
    index = std::min(steps, count - 1);
  } else {
    const std::int64_t place = steps % round();
    index = place < count ? place : round() - place;
  }
  return cells_[static_cast<std::size_t>(index)];
}

bool Mover::goes_on(std::int64_t steps) const {
  const auto count = static_cast<std::int64_t>(cells_.size());
  return count > 1 && (at_end_ != WayEnd::stop || steps + 1 < count);
}

/// The steps after which the way begins anew.
std::int64_t Mover::round() const {
  const auto count = static_cast<std::int64_t>(cells_.size());
  return at_end_ == WayEnd::back ? std::max<std::int64_t>(1, 2 * (count - 1)) : count;
}

std::int64_t Mover::steps_left(std::int64_t steps) const {
  if (!goes_on(steps)) return 0;
  return at_end_ == WayEnd::stop ? static_cast<std::int64_t>(cells_.size()) - 1 - steps
                                 : std::numeric_limits<std::int64_t>::max();
}

/// How many cells lie between the box and the cell, and the cell itself; 0 if the box covers it.
int Mover::gap(Cell corner, Cell cell) const {
  return std::max({0, corner.x - cell.x, cell.x - (corner.x + width_ - 1), corner.y - cell.y,
                   cell.y - (corner.y + height_ - 1), corner.z - cell.z, cell.z - (corner.z + depth_ - 1)});
}

std::int64_t Mover::open_steps(std::int64_t steps, std::int64_t most,
                               std::span<const Cell> keep_clear) const {
  // What nothing bars for a whole round is never barred.
  for (std::int64_t done = 0; !keep_clear.empty() && done < std::min(most, round());) {
    const Cell here = at(steps + done), next = at(steps + done + 1);
    int nearest = std::numeric_limits<int>::max();
    for (const Cell cell : keep_clear) {
      if (covers(next, cell) && !covers(here, cell)) return done;
      nearest = std::min(nearest, gap(here, cell));
    }
    done += std::max(1, nearest - 1);  // a step brings it nearer by at most one cell
  }
  return most;
}

Crowd::Crowd(const Scenario& scenario) : world_(scenario.map.box()) {
  for (const MovingObstacle& setup : scenario.movers) movers_.emplace_back(setup);
}

std::vector<MoverState> Crowd::initial() const {
  std::vector<MoverState> states(movers_.size());
  for (std::size_t i = 0; i < states.size(); ++i)
    if (movers_[i].from() == 0) states[i] = {.steps = 0, .due = movers_[i].pace()};
  return states;
}

std::vector<Crowd::Change> Crowd::advance(std::vector<MoverState>& states, SimTime time, std::int64_t clock,
                                          std::span<const Cell> keep_clear) const {
  std::vector<Change> changes;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i].steps < 0 && clock >= movers_[i].from()) appear(i, states, time, keep_clear, changes);
  std::vector<std::size_t> due;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i].steps >= 0 && states[i].due <= time && movers_[i].goes_on(states[i].steps))
      due.push_back(i);
  std::stable_sort(due.begin(), due.end(),
                   [&states](std::size_t a, std::size_t b) { return states[a].due < states[b].due; });
  for (const std::size_t index : due) move(index, states, time, keep_clear, changes);
  return changes;
}

void Crowd::appear(std::size_t index, std::vector<MoverState>& states, SimTime time,
                   std::span<const Cell> keep_clear, std::vector<Change>& changes) const {
  const Mover& mover = movers_[index];
  const Cell at = mover.at(0);
  if (std::any_of(keep_clear.begin(), keep_clear.end(), [&](Cell c) { return mover.covers(at, c); })) return;
  states[index] = {.steps = 0, .due = time + mover.pace()};
  mover.each_cell(at, world_, [&](Cell cell) { changes.push_back({cell, 1}); });
}

// All steps up to `time` at once. What bars its way now bars it until then, since the robot stands still.
void Crowd::move(std::size_t index, std::vector<MoverState>& states, SimTime time,
                 std::span<const Cell> keep_clear, std::vector<Change>& changes) const {
  const Mover& mover = movers_[index];
  MoverState& state = states[index];
  const std::int64_t tries = (time - state.due) / mover.pace() + 1;
  const std::int64_t wanted = std::min(tries, mover.steps_left(state.steps));
  const std::int64_t taken = mover.open_steps(state.steps, wanted, keep_clear);
  const Cell from = mover.at(state.steps), to = mover.at(state.steps + taken);
  state.steps += taken;
  state.due += (taken < wanted ? tries : wanted) * mover.pace();
  mover.each_cell(from, world_, [&](Cell cell) {
    if (!mover.covers(to, cell)) changes.push_back({cell, -1});
  });
  mover.each_cell(to, world_, [&](Cell cell) {
    if (!mover.covers(from, cell)) changes.push_back({cell, 1});
  });
}

SharedBytes initial_truth(const Scenario& scenario, bool all_mapped) {
  static_assert(kFree == 0 && kObstacle == kWallBit);
  SharedBytes truth = all_mapped ? scenario.map.blocked : with_unmapped_as(scenario.map.blocked, kWallBit);
  for (const MovingObstacle& setup : scenario.movers) {
    if (setup.from > 0) continue;
    const Mover mover(setup);
    mover.each_cell(mover.at(0), scenario.map.box(), [&](Cell cell) {
      std::uint8_t& at = truth.edit(scenario.map.index(cell));
      at = static_cast<std::uint8_t>(at + kMoverUnit);
    });
  }
  return truth;
}

}  // namespace replan
