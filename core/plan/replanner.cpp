#include "core/plan/replanner.hpp"

#include <algorithm>
#include <span>

#include "core/base/words.hpp"
#include "core/plan/registry.hpp"

namespace replan {

/// The grid and its planner, whatever its dimension. Cells are inside.
class Replanner::Grid {
 public:
  explicit Grid(const Box& box) : box_(box) {}
  virtual ~Grid() = default;
  Grid(const Grid&) = delete;
  Grid& operator=(const Grid&) = delete;

  [[nodiscard]] const Box& box() const { return box_; }
  virtual PlanStatus plan(NodeId start, NodeId goal) = 0;
  /// kNoNode: the start stays where it is.
  virtual PlanStatus change(std::span<const CellEdit> edits, NodeId start) = 0;
  [[nodiscard]] virtual PlanStatus status() const = 0;
  [[nodiscard]] virtual std::vector<NodeId> path() = 0;
  [[nodiscard]] virtual Cost cost() const = 0;
  [[nodiscard]] virtual bool blocked(NodeId node) const = 0;

 private:
  Box box_;
};

template <int D>
class Replanner::GridOf final : public Grid {
 public:
  GridOf(const Box& box, std::vector<std::uint8_t> cells, const PlannerInfo& info, const Settings& settings)
      : Grid(box),
        lattice_(box.sides<D>(), std::move(cells), move_rules(settings)),
        planner_(make_planner(info, lattice_, settings, nobody_)) {}

  PlanStatus plan(NodeId start, NodeId goal) override {
    start_ = start;
    planner_->begin(start, goal);
    return finish(*planner_);
  }

  PlanStatus change(std::span<const CellEdit> edits, NodeId start) override {
    const auto moves = lattice_.apply(edits);
    if (!planned()) return status();
    if (start != kNoNode) start_ = start;
    planner_->update({.cells = edits, .moves = moves}, start_);
    return finish(*planner_);
  }

  [[nodiscard]] PlanStatus status() const override {
    return planned() ? planner_->status() : PlanStatus::searching;
  }
  [[nodiscard]] std::vector<NodeId> path() override {
    return planned() ? planner_->path().nodes : std::vector<NodeId>{};
  }
  [[nodiscard]] Cost cost() const override { return planned() ? planner_->cost() : Cost::infinity(); }
  [[nodiscard]] bool blocked(NodeId node) const override { return lattice_.blocked(node); }

 private:
  [[nodiscard]] bool planned() const { return start_ != kNoNode; }

  NoTrace nobody_;
  BoxLattice<D> lattice_;
  std::unique_ptr<Planner<BoxLattice<D>>> planner_;
  NodeId start_ = kNoNode;
};

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
                                  const std::vector<Setting>& settings) {
  if (std::string fault = fault_of(box, cells.size()); !fault.empty()) return Error{std::move(fault)};
  const auto info = require_planner(planner);
  if (!info) return Error{info.error()};
  Settings values;
  for (const auto& [key, text] : settings)
    if (const auto set = set_from_text(values, (*info)->parameters, key, text); !set)
      return Error{set.error()};
  return with_dimensions(box, [&](auto d) {
    return Replanner(std::make_unique<GridOf<d()>>(box, std::move(cells), **info, values));
  });
}

Replanner::Replanner(std::unique_ptr<Grid> grid) : grid_(std::move(grid)) {}
Replanner::~Replanner() = default;
Replanner::Replanner(Replanner&&) noexcept = default;
Replanner& Replanner::operator=(Replanner&&) noexcept = default;

Result<PlanStatus> Replanner::plan(Cell start, Cell goal) {
  for (const Cell cell : {start, goal})
    if (std::string fault = fault_of(grid_->box(), cell); !fault.empty()) return Error{std::move(fault)};
  return grid_->plan(grid_->box().node(start), grid_->box().node(goal));
}

Result<PlanStatus> Replanner::change(const std::vector<Change>& changes, Cell start) {
  if (std::string fault = fault_of(grid_->box(), start); !fault.empty()) return Error{std::move(fault)};
  return change_from(changes, grid_->box().node(start));
}

Result<PlanStatus> Replanner::change(const std::vector<Change>& changes) {
  return change_from(changes, kNoNode);
}

Result<PlanStatus> Replanner::change_from(const std::vector<Change>& changes, NodeId start) {
  const Box& box = grid_->box();
  for (const Change& change : changes)
    if (std::string fault = fault_of(box, change.cell); !fault.empty()) return Error{std::move(fault)};
  return grid_->change(edits_of(box, changes, [this](NodeId node) { return grid_->blocked(node); }), start);
}

PlanStatus Replanner::status() const {
  return grid_->status();
}

std::vector<Cell> Replanner::path() const {
  std::vector<Cell> cells;
  for (const NodeId node : grid_->path()) cells.push_back(grid_->box().position(node));
  return cells;
}

double Replanner::cost() const {
  return grid_->cost().to_double();
}

bool Replanner::blocked(Cell cell) const {
  return !grid_->box().contains(cell) || grid_->blocked(grid_->box().node(cell));
}

}  // namespace replan
