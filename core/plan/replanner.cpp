#include "core/plan/replanner.hpp"

#include <algorithm>

#include "core/base/words.hpp"
#include "core/plan/navigator.hpp"
#include "core/plan/registry.hpp"

namespace replan {

namespace {

std::string box_text(const Box& box) {
  const std::string plane = std::to_string(box.width()) + " x " + std::to_string(box.height());
  return box.solid() ? plane + " x " + std::to_string(box.depth()) : plane;
}

/// What is wrong with a grid, as a sentence; empty if nothing is.
std::string fault_of(const Box& box, std::size_t cells) {
  if (box.width() < 1 || box.height() < 1 || box.depth() < 1)
    return "a grid of " + box_text(box) + " cells cannot be planned on: give each side at least 1";
  const std::int64_t most = box.solid() ? kMaxVoxels : kMaxCells;
  if (box.width() > most / box.height() / box.depth())
    return "a grid of " + box_text(box) + " cells is too large: " + std::to_string(most) + " are the most";
  if (cells != box.node_count())
    return "a grid of " + box_text(box) + " cells takes " + std::to_string(box.node_count()) +
           " values, and " + std::to_string(cells) + " were given";
  return "";
}

/// What is wrong with a cell of a grid, as a sentence; empty if nothing is.
std::string fault_of(const Box& box, Cell cell) {
  if (box.contains(cell)) return "";
  return cell_text(cell, box.solid() || cell.z != 0) + " lies outside the grid of " + box_text(box) +
         " cells";
}

/// Each cell once, with its last value, and only those that are not so already.
template <class Blocked>
std::vector<CellEdit> edits_of(const Box& box, const std::vector<Replanner::Change>& changes,
                               Blocked&& blocked) {
  std::vector<CellEdit> edits;
  for (const Replanner::Change& change : changes) edits.push_back({box.node(change.cell), change.blocked});
  std::stable_sort(edits.begin(), edits.end(),
                   [](const CellEdit& a, const CellEdit& b) { return a.node < b.node; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const bool last = i + 1 == edits.size() || edits[i + 1].node != edits[i].node;
    if (last && blocked(edits[i].node) != edits[i].blocked) edits[kept++] = edits[i];
  }
  edits.resize(kept);
  return edits;
}

}  // namespace

Result<Replanner> Replanner::make(Box box, std::vector<std::uint8_t> cells, std::string_view planner,
                                  const std::vector<Setting>& settings, double radius) {
  if (std::string fault = fault_of(box, cells.size()); !fault.empty()) return Error{std::move(fault)};
  const auto info = require_planner(planner);
  if (!info) return Error{info.error()};
  if (const auto fit = fits(**info, box, radius); !fit) return Error{fit.error()};
  Settings values;
  for (const auto& [key, text] : settings)
    if (const auto set = set_from_text(values, (*info)->parameters, key, text); !set)
      return Error{set.error()};
  if (!(radius >= 0 && radius <= MoveRules::kMostRadius))
    return Error{"a robot cannot have such a radius: give a number of cells from 0 to " +
                 std::to_string(static_cast<int>(MoveRules::kMostRadius))};
  const PlannerChoice choice{std::string((*info)->id), std::move(values)};
  return Replanner(make_navigator(choice, box, SharedBytes(std::move(cells)), radius));
}

Replanner::Replanner(std::unique_ptr<Navigator> navigator) : navigator_(std::move(navigator)) {}
Replanner::~Replanner() = default;
Replanner::Replanner(Replanner&&) noexcept = default;
Replanner& Replanner::operator=(Replanner&&) noexcept = default;

Result<PlanStatus> Replanner::plan(Cell start, Cell goal) {
  for (const Cell cell : {start, goal})
    if (std::string fault = fault_of(navigator_->box(), cell); !fault.empty()) return Error{std::move(fault)};
  start_ = start;
  navigator_->begin(centre_of(start), centre_of(goal));
  return finish(*navigator_);
}

Result<PlanStatus> Replanner::change(const std::vector<Change>& changes, Cell start) {
  const Box box = navigator_->box();
  if (std::string fault = fault_of(box, start); !fault.empty()) return Error{std::move(fault)};
  for (const Change& change : changes)
    if (std::string fault = fault_of(box, change.cell); !fault.empty()) return Error{std::move(fault)};
  navigator_->learn(edits_of(box, changes, [this](NodeId node) { return navigator_->known()[node] != 0; }));
  if (!start_) return status();
  start_ = start;
  navigator_->update(centre_of(start));
  return finish(*navigator_);
}

Result<PlanStatus> Replanner::change(const std::vector<Change>& changes) {
  return change(changes, start_.value_or(Cell{}));
}

PlanStatus Replanner::status() const {
  return start_ ? navigator_->status() : PlanStatus::searching;
}

std::vector<Cell> Replanner::path() const {
  std::vector<Cell> cells;
  for (const Point& point : points()) {
    Cell cell = cell_of(point);
    for (const Cell left_or_above : {Cell{cell.x - 1, cell.y, cell.z}, Cell{cell.x, cell.y - 1, cell.z}})
      if (blocked(cell) && !blocked(left_or_above)) cell = left_or_above;
    if (cells.empty() || cell != cells.back()) cells.push_back(cell);
  }
  return cells;
}

std::vector<Point> Replanner::points() const {
  std::vector<Point> points;
  if (!start_) return points;
  const Path path = navigator_->path();
  for (std::size_t i = 0; i < path.size(); ++i) points.push_back(path.point(i));
  return points;
}

double Replanner::cost() const {
  return (start_ ? navigator_->cost() : Cost::infinity()).to_double();
}

bool Replanner::blocked(Cell cell) const {
  const Box box = navigator_->box();
  return !box.contains(cell) || navigator_->known()[box.node(cell)] != 0;
}

}  // namespace replan
