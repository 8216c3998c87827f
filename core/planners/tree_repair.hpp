// How a tree of places is kept when the map or the start changes: what is blocked is cut off, and the rest hangs on the new
// start.
//
// Line numbers are those of assets/planners/rrt-star.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/planners/path_tree.hpp"

namespace replan {

template <int D, Tracer T>
class TreeRepair {
 public:
  /// `step`: how far from the new start vertices count as near, in units.
  TreeRepair(PathTree<D, T>& tree, const FreeSpace<D>& space, T& tracer, std::int64_t step)
      : tree_(tree), space_(space), tr_(tracer), step_(step) {}

  /// Lines 14 and 15. The cells are those that have changed.
  void cut_what_is_blocked(std::span<const CellEdit> cells) {
    // Of a robot with a size these are the cells that have turned for its centre: what it may touch are others.
    const bool told_all = !space_.known().has_size();
    const auto blocked = [](const CellEdit& edit) { return edit.blocked; };
    if (told_all && std::none_of(cells.begin(), cells.end(), blocked)) return;
    tr_.line(14);
    const Reach changed = told_all ? reach_of(cells) : Reach{};
    for (std::uint32_t v = 0; v < tree_.size(); ++v) {
      if (tree_.cut_off(v)) continue;
      const Place& from = tree_.parent(v) == kNone ? tree_.place(v) : tree_.place(tree_.parent(v));
      if (changed.meets(from, tree_.place(v)) && space_.hit(from, tree_.place(v))) tree_.cut(v);
    }
    tree_.lose_ends_that_are_cut_off();
  }

  /// Lines 16-18: the start is the root, and near vertices hang on it that are nearer by it. False if nothing sees it.
  bool hang_on_start() {
    const Place start = tree_.start_place();
    tr_.line(16);
    if (tree_.root() == kNone) return false;
    if (tree_.place(tree_.root()) != start) {
      const std::vector<std::uint32_t> way = tree_.way();
      const std::uint32_t link = vertex_seen_from(start, way);
      if (link == kNone) return false;
      tree_.turn_to(link);
      if (tree_.place(link) != start) hang_on_new_root(start, way);
    }
    tree_.take_change();
    return true;
  }

 private:
  static constexpr std::uint32_t kNone = PathTree<D, T>::kNone;
  static constexpr auto kFar = std::numeric_limits<std::int64_t>::max();

  /// The places that a change of the map may have blocked, a box around them: at first all.
  struct Reach {
    Place low{-kFar, -kFar, -kFar}, high{kFar, kFar, kFar};
    [[nodiscard]] bool meets(const Place& a, const Place& b) const {
      for (std::size_t i = 0; i < D; ++i)
        if (std::max(a[i], b[i]) < low[i] || std::min(a[i], b[i]) > high[i]) return false;
      return true;
    }
  };
  [[nodiscard]] Reach reach_of(std::span<const CellEdit> cells) const {
    Reach reach{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    constexpr std::int64_t margin = 2 * kPlaceUnits;
    for (const CellEdit& edit : cells) {
      const Place at = place_in(space_.known().position(edit.node));
      for (std::size_t i = 0; i < 3; ++i) {
        reach.low[i] = std::min(reach.low[i], at[i] - margin);
        reach.high[i] = std::max(reach.high[i], at[i] + margin);
      }
    }
    return reach;
  }

  // Lines 17 and 18.
  void hang_on_new_root(const Place& start, const std::vector<std::uint32_t>& way) {
    const std::uint32_t added = tree_.grow(start, tree_.root());
    tree_.turn_to(added);
    for (const std::uint32_t v : near_start(start, way))
      if (v != added) tree_.hang_if_shorter(v, added, 18);
  }
  /// The vertices within a step, and those of the path: its ways may be longer than a step.
  [[nodiscard]] std::vector<std::uint32_t> near_start(const Place& start,
                                                      const std::vector<std::uint32_t>& way) const {
    std::vector<std::uint32_t> near = tree_.within(start, step_);
    for (const std::uint32_t v : way)
      if (squared_between(tree_.place(v), start) > step_ * step_) near.push_back(v);
    return near;
  }
  /// The nearest vertex, or of those near the start the nearest that the way is free to.
  std::uint32_t vertex_seen_from(const Place& start, const std::vector<std::uint32_t>& way) {
    std::vector<std::uint32_t> near(1, tree_.nearest(start));
    if (near[0] == kNone) return kNone;
    const auto found = near_start(start, way);
    near.insert(near.end(), found.begin(), found.end());
    std::stable_sort(near.begin(), near.end(), [&](std::uint32_t a, std::uint32_t b) {
      return squared_between(tree_.place(a), start) < squared_between(tree_.place(b), start);
    });
    for (const std::uint32_t v : near)
      if (!tree_.hit_from(v, start)) return v;
    return kNone;
  }

  PathTree<D, T>& tree_;
  const FreeSpace<D>& space_;
  T& tr_;
  const std::int64_t step_;
};

}  // namespace replan
