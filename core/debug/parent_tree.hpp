// The tree that the parents of a search make at one moment: who hangs on whom, and how many on each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
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
  explicit ParentTree(std::shared_ptr<const ParentTable> table);

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
  friend class ParentTreeBuilder;

  std::shared_ptr<const ParentTable> table_;
  std::vector<std::uint32_t> begins_;  // in children_, one more than there are points
  std::vector<NodeId> children_;
  std::vector<std::uint32_t> below_;
  std::vector<bool> circle_;
  std::size_t members_ = 0;
};

/// Makes such a tree a slice at a time.
class ParentTreeBuilder {
 public:
  explicit ParentTreeBuilder(std::shared_ptr<const ParentTable> table);

  /// One slice. False once the tree is whole.
  bool advance();
  [[nodiscard]] ParentTree take() { return std::move(tree_); }

 private:
  /// One after the other, each over all points.
  enum class Phase : std::uint8_t { count_children, sum_up, link, find_leaves, climb, find_circles, whole };
  [[nodiscard]] std::size_t length() const;
  void go_over(std::size_t begin, std::size_t end);
  void visit(std::size_t number);
  void find_leaf(std::size_t point);
  void climb(std::size_t number);

  ParentTree tree_;
  Phase phase_ = Phase::count_children;
  std::size_t at_ = 0;
  std::vector<std::uint32_t> waits_;  // how many children are not counted yet
  std::vector<NodeId> ready_;         // points all of whose children are
};

/// The point and its ancestors, from it up to the root.
struct Ancestry {
  std::vector<NodeId> points;
  bool circle = false;  ///< parents lead back to the last of them: there is no root
};
/// At the cursor of the log, or at `state`'s moment: each is looked up, and no more of them than there are points.
Ancestry ancestry(const PlannerInfo& info, const SearchState& state, NodeId point);

/// The cells of all points below one, its own cell left out, in a world of so many nodes. Of a point in a circle those are
/// all of the circle and what hangs on it.
CellSet cells_below(const ParentTree& tree, NodeId point, std::size_t nodes);

/// The same a slice at a time.
class CellsBelow {
 public:
  CellsBelow(std::shared_ptr<const ParentTree> tree, NodeId point, std::size_t nodes);

  /// One slice. False once all are there.
  bool advance();
  [[nodiscard]] CellSet take() { return std::move(cells_); }

 private:
  std::shared_ptr<const ParentTree> tree_;
  NodeId point_;
  CellSet cells_;
  std::vector<NodeId> rest_;  // whose children are to be looked at
};

}  // namespace replan
