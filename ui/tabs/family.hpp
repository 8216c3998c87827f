// The tree of parents about one cell: its way to the root, its children, and how many hang on each.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/base/background.hpp"
#include "core/debug/parent_tree.hpp"
#include "ui/shell/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// A line of the indented tree: a point, or a number of points that are folded away.
struct FamilyRow {
  enum class Kind : std::uint8_t { ancestor, self, relative, siblings, more };
  Kind kind{};
  NodeId point = kNoNode;  ///< Kind::siblings and more: the parent of those
  std::size_t depth = 0;   ///< from the root
  std::size_t level = 0;   ///< by how much it is indented
  std::size_t count = 0;   ///< of those that are folded away, or of its children
  bool open = false;       ///< they are listed below it
};

class FamilyView {
 public:
  void draw(Frame& frame);

  [[nodiscard]] const std::vector<FamilyRow>& rows() const { return rows_; }
  /// As worked out last; nullptr before that.
  [[nodiscard]] const std::shared_ptr<const ParentTree>& tree() const { return tree_; }
  /// The point that it is about.
  [[nodiscard]] NodeId point() const { return point_; }

 private:
  using Tree = std::shared_ptr<const ParentTree>;
  using Cells = std::shared_ptr<const CellSet>;
  /// What the rows were made of.
  struct RowsKey {
    Tree tree;
    NodeId point = kNoNode;
    std::uint64_t log_id = 0;
    std::size_t position = 0, unfolding = 0;
    friend bool operator==(const RowsKey&, const RowsKey&) = default;
  };

  void follow(Frame& frame);
  void follow_below(Frame& frame);
  [[nodiscard]] NodeId point_of_cell(Frame& frame, Cell cell);
  void make_rows(const Frame& frame);
  void list_children(NodeId parent, std::size_t depth, std::size_t level, NodeId without);
  void show_on_canvas(Frame& frame);
  void draw_heading(Frame& frame);
  void draw_steps(Frame& frame);
  void draw_rows(Frame& frame);
  void draw_row(Frame& frame, std::size_t number, std::span<const Column> columns);
  void go_to(Frame& frame, NodeId point);

  ParentTableReader reader_;
  std::uint64_t log_id_ = 0;  // that all of it is of
  std::size_t begun_ = 0;     // the moment that was begun last
  std::unique_ptr<Background<Tree>> job_;
  std::unique_ptr<Background<Cells>> below_job_;
  Tree tree_;
  Cells below_;
  Tree below_tree_;  // that it is of
  NodeId below_point_ = kNoNode;
  NodeId point_ = kNoNode;
  std::optional<std::pair<Cell, NodeId>> chosen_;  // of several vertices of a tree in a cell
  Ancestry up_;                                    // of the point at the cursor
  std::vector<FamilyRow> rows_;
  RowsKey rows_key_;
  std::set<NodeId> unfolded_;  // whose children, or the siblings of whose child on the way, are listed
  std::size_t unfolding_ = 0;  // grows with each change of that
  RowScroll scroll_;
  bool reveal_ = false;  // the point's own row is to be in sight
  std::shared_ptr<const ShownFamily> shown_;
};

}  // namespace replan::ui
