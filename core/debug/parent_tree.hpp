// The tree that the parents of a search make at one moment: who hangs on whom, and how many on each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/debug/cell_set.hpp"
#include "core/debug/parents.hpp"

namespace replan {

/// What was read out of a state, so that another thread can go on with it.
struct ParentTable {
  std::uint64_t log_id = 0;
  std::size_t position = 0;     ///< of the log
  std::vector<NodeId> parents;  ///< of each point; kNoNode if there is none
  std::vector<NodeId> cells;    ///< the nodes that vertices of a tree lie in; else none
  [[nodiscard]] NodeId cell(NodeId point) const { return cells.empty() ? point : cells[point]; }
};

/// The table at the cursor of a log, read a slice at a time, and each time of one moment: the state of that moment is kept
/// while the cursor moves on.
class ParentTableReader {
 public:
  /// Begins to read at the cursor.
  void begin(const LogView& view, std::uint64_t log_id);
  /// Whether it was begun and not taken yet.
  [[nodiscard]] bool busy() const { return job_ != nullptr; }
  void cancel() { job_.reset(); }
  /// Goes on until the deadline. The whole table once it is read, else nullptr.
  std::shared_ptr<const ParentTable> read(const Deadline& deadline);

 private:
  struct Job;
  std::shared_ptr<Job> job_;
};

/// Children and subtrees of all points.
class ParentTree {
 public:
  ParentTree() = default;
  /// Half done if it is asked to stop.
  explicit ParentTree(std::shared_ptr<const ParentTable> table, const std::stop_token& stop = {});

  [[nodiscard]] const ParentTable& table() const { return *table_; }
  [[nodiscard]] NodeId parent(NodeId point) const { return table_->parents[point]; }
  /// In the order of their numbers.
  [[nodiscard]] std::span<const NodeId> children(NodeId point) const {
    return {children_.data() + begins_[point], children_.data() + begins_[point + 1]};
  }
  /// How many points hang below it, its children's included and its own left out.
  [[nodiscard]] std::size_t below(NodeId point) const { return below_[point]; }
  /// Whether its parents lead in a circle that it is part of: none of these has a number of points below it. Planners as
  /// printed can make one.
  [[nodiscard]] bool in_circle(NodeId point) const { return circle_[point]; }
  [[nodiscard]] std::size_t point_count() const { return table_ ? table_->parents.size() : 0; }
  /// Points that have a parent or a child.
  [[nodiscard]] std::size_t members() const { return members_; }

 private:
  void link(const std::stop_token& stop);
  void count(const std::stop_token& stop);

  std::shared_ptr<const ParentTable> table_;
  std::vector<std::uint32_t> begins_;  // in children_, one more than there are points
  std::vector<NodeId> children_;
  std::vector<std::uint32_t> below_;
  std::vector<bool> circle_;
  std::size_t members_ = 0;
};

/// The point and its ancestors, from it up to the root.
struct Ancestry {
  std::vector<NodeId> points;
  bool circle = false;  ///< parents lead back to the last of them: there is no root
};
/// At the cursor of the log, or at `state`'s moment: each is looked up, and no more of them than there are points.
Ancestry ancestry(const PlannerInfo& info, const SearchState& state, NodeId point);

/// The cells of all points below one, its own cell left out, in a world of so many nodes. Of a point in a circle those are
/// all of the circle and what hangs on it. Some of them if it is asked to stop.
CellSet cells_below(const ParentTree& tree, NodeId point, std::size_t nodes,
                    const std::stop_token& stop = {});

}  // namespace replan
