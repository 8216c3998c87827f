// A path as a planner gives it, whatever it searches in.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/point.hpp"
#include "core/lattice/box.hpp"
#include "core/lattice/lattice.hpp"

namespace replan {

/// Where a curve was pulled in to its control polygon.
struct PullIn {
  Point at;   ///< on the curve as it would have been: where it came too near
  Cell cell;  ///< the obstacle that it would have hit
  friend bool operator==(const PullIn&, const PullIn&) = default;
};

/// What a path was drawn from that is a curve, sampled.
struct Spline {
  std::vector<Point> control;     ///< the corners of its control polygon, those of pull-ins among them
  std::vector<PullIn> pulled_in;  ///< in the order in which they were found
  friend bool operator==(const Spline&, const Spline&) = default;
};

/// A polyline from the start to the end, both included; empty if there is none. Its points are the centres of
/// lattice nodes where the planner searches among such, and else anywhere. A run keeps every path that it has had,
/// so nodes are held as such and not as points.
class Path {
 public:
  Path() = default;
  /// Over nodes of a lattice that is such a box, each segment a move or a line of sight under that rule.
  Path(const Box& box, std::vector<NodeId> nodes, SightRule sight = SightRule::supercover)
      : box_(box), nodes_(std::move(nodes)), sight_(sight) {}
  /// Over any points.
  explicit Path(std::vector<Point> points) : points_(std::move(points)) {}

  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] std::size_t size() const { return nodes_.empty() ? points_.size() : nodes_.size(); }
  [[nodiscard]] Point point(std::size_t i) const {
    return nodes_.empty() ? points_[i] : centre_of(box_.position(nodes_[i]));
  }
  /// The lattice nodes that the points are the centres of, one each; empty for a path that has none.
  [[nodiscard]] std::span<const NodeId> nodes() const& { return nodes_; }
  [[nodiscard]] std::vector<NodeId> nodes() && { return std::move(nodes_); }
  /// Leaves out the points for which keep(i) is false; asked of each in turn, before any is left out.
  template <class Keep>
  void keep_if(Keep&& keep) {
    std::vector<bool> kept(size());
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = keep(i);
    const auto thin = [&kept](auto& all) {
      std::size_t next = 0;
      for (std::size_t i = 0; i < all.size(); ++i)
        if (kept[i]) all[next++] = all[i];
      all.resize(next);
    };
    thin(nodes_);
    thin(points_);
    spline.reset();  // what is left is no curve
  }
  /// Which cells its segments were laid over: all that they touch, or those of a drawn line.
  [[nodiscard]] SightRule sight() const { return sight_; }

  /// Parents led in a circle before the goal: only with `remote_parents=printed`. The path ends at the
  /// repetition.
  bool loops = false;
  /// Some segment was taken on trust and may cross an obstacle: only with `remote_parents=printed`.
  bool unchecked = false;
  /// Its points are centres and corners of cells, and it may touch obstacles as core/lattice/squares.hpp allows.
  bool touches = false;
  /// Of a path that a stage has made a curve of.
  std::optional<Spline> spline;

  friend bool operator==(const Path&, const Path&) = default;

 private:
  Box box_;
  std::vector<NodeId> nodes_;
  std::vector<Point> points_;
  SightRule sight_ = SightRule::supercover;
};

}  // namespace replan
