// What planners keep that grow a tree of places, and write down in its log: where each vertex lies, what it hangs on, and
// what the way to it from the root comes to.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/plan/tree_values.hpp"
#include "core/planners/run_numbers.hpp"
#include "core/space/place_index.hpp"
#include "core/trace/tracer.hpp"

namespace replan {

/// Every write of a value goes through a function that tells the tracer. The cost of a vertex is that of what it hangs on
/// and the length of the straight way from there, at every moment. Numbers of vertices that were cut off are not used
/// again: the log tells what they were.
template <int D, Tracer T>
class GrownTree {
 public:
  static constexpr std::uint32_t kNone = PlaceIndex<D>::kNone;

  GrownTree(const Place& extent, RunNumbers<T>& numbers, T& tracer)
      : numbers_(numbers), tr_(tracer), index_{PlaceIndex<D>(extent), PlaceIndex<D>(extent)} {}

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(places_.size()); }
  /// Those that grew from the start and are not cut off.
  [[nodiscard]] std::size_t alive() const { return index(TreeSide::start).size(); }
  [[nodiscard]] bool full() const { return size() >= kMostVertices; }
  /// By value: growing the tree moves its places.
  [[nodiscard]] Place place(std::uint32_t v) const { return places_[v]; }
  [[nodiscard]] Cost cost(std::uint32_t v) const { return links_[v].cost; }
  /// What it hangs on; kNone for a root, and for what was cut off.
  [[nodiscard]] std::uint32_t parent(std::uint32_t v) const { return links_[v].parent; }
  [[nodiscard]] bool cut_off(std::uint32_t v) const { return links_[v].cost.is_infinite(); }
  /// kNone if nothing grew from that side.
  [[nodiscard]] std::uint32_t nearest(const Place& at, TreeSide side = TreeSide::start) const {
    return index(side).nearest(places_, at);
  }
  /// The vertex there; kNone if there is none.
  [[nodiscard]] std::uint32_t vertex_at(const Place& at, TreeSide side = TreeSide::start) const {
    const std::uint32_t v = nearest(at, side);
    return v != kNone && place(v) == at ? v : kNone;
  }
  /// Those that grew from the start and are no farther than `reach` units away, by their numbers.
  [[nodiscard]] std::vector<std::uint32_t> within(const Place& at, std::int64_t reach) const {
    std::vector<std::uint32_t> near;
    index(TreeSide::start).each_within(places_, at, reach, [&near](std::uint32_t v) { near.push_back(v); });
    std::sort(near.begin(), near.end());
    return near;
  }
  /// What the way there comes to over a vertex.
  [[nodiscard]] Cost cost_over(std::uint32_t v, const Place& at) const {
    return cost(v) + length_between(place(v), at);
  }

  /// Forgets all vertices. The log tells of it by an epoch, which is its owner's to write.
  void clear() {
    numbers_.set_count(Scalar::vertices, 0);
    let_all_go();
  }
  /// A vertex without a parent.
  std::uint32_t plant(const Place& at, TreeSide side = TreeSide::start) {
    const std::uint32_t v = append(at, side);
    set_cost(v, Cost::zero());
    return v;
  }
  /// A vertex that hangs on another one.
  std::uint32_t grow(const Place& at, std::uint32_t parent) {
    const std::uint32_t v = append(at, links_[parent].side);
    hang(v, parent);
    return v;
  }
  /// Hangs a vertex, and what hangs on it, on another one, which must not be among them.
  void hang(std::uint32_t v, std::uint32_t parent) {
    let_go(v);
    set_parent(v, parent);
    join_children(v, parent);
    settle(v);
  }
  /// Cuts off a vertex and all that hangs on it.
  void cut(std::uint32_t v) {
    let_go(v);
    each_below(v, [this](std::uint32_t below) {
      index(links_[below].side).remove(places_, below);
      set_parent(below, kNone);
      set_cost(below, Cost::infinity());
    });
    for (const std::uint32_t below : below_) links_[below].first_child = links_[below].next = kNone;
  }
  /// Makes a vertex the root: what lies on the way to it hangs the other way round.
  void make_root(std::uint32_t v) {
    std::vector<std::uint32_t> way;
    for (std::uint32_t u = v; u != kNone; u = parent(u)) way.push_back(u);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) let_go(way[i]);
    set_parent(v, kNone);
    for (std::size_t i = 1; i < way.size(); ++i) {
      set_parent(way[i], way[i - 1]);
      join_children(way[i], way[i - 1]);
    }
    settle(v);
  }
  /// All that grew from the goal hangs on the vertex `near` from now on, by its vertex `far`.
  void graft(std::uint32_t near, std::uint32_t far) {
    make_root(far);
    each_below(far, [this](std::uint32_t below) {
      index(TreeSide::goal).remove(places_, below);
      set_side(below, TreeSide::start);
      index(TreeSide::start).insert(places_, below);
    });
    hang(far, near);
  }

  [[nodiscard]] std::size_t memory_bytes() const {
    return places_.capacity() * sizeof(Place) + links_.capacity() * sizeof(Link) + index_[0].memory_bytes() +
           index_[1].memory_bytes();
  }

  /// As the log's state shows it.
  void restore(const SearchState& state) {
    let_all_go();
    const auto count = vertex_count(state);
    for (std::uint32_t v = 0; v < count; ++v) {
      places_.push_back(vertex_place(state, v, D == 3));
      links_.push_back(
          {.cost = vertex_cost(state, v), .parent = vertex_parent(state, v), .side = vertex_side(state, v)});
    }
    for (std::uint32_t v = 0; v < count; ++v) {
      if (cut_off(v)) continue;
      index(links_[v].side).insert(places_, v);
      if (parent(v) != kNone) join_children(v, parent(v));
    }
  }

 private:
  struct Link {
    Cost cost = Cost::infinity();
    std::uint32_t parent = kNone;
    std::uint32_t first_child = kNone, next = kNone;  // siblings by their numbers
    TreeSide side = TreeSide::start;
  };

  [[nodiscard]] PlaceIndex<D>& index(TreeSide side) { return index_[static_cast<std::size_t>(side)]; }
  [[nodiscard]] const PlaceIndex<D>& index(TreeSide side) const {
    return index_[static_cast<std::size_t>(side)];
  }
  void let_all_go() {
    places_.clear();
    links_.clear();
    for (PlaceIndex<D>& index : index_) index.clear();
  }
  std::uint32_t append(const Place& at, TreeSide side) {
    const std::uint32_t v = size();
    numbers_.set_count(Scalar::vertices, std::int64_t{v} + 1);
    places_.emplace_back();
    if constexpr (D == 2) places_.back()[2] = kPlaceUnits / 2;
    links_.emplace_back();
    set_place(v, at);
    set_side(v, side);
    index(side).insert(places_, v);
    return v;
  }
  void set_place(std::uint32_t v, const Place& at) {
    for (std::size_t i = 0; i < D; ++i)
      tr_.change(kVertexPlace[i].kind, v, coordinate_bits(places_[v][i]), coordinate_bits(at[i]));
    places_[v] = at;
  }
  void set_parent(std::uint32_t v, std::uint32_t parent) {
    tr_.change(fields::kVertexParent.kind, v, std::uint64_t{links_[v].parent + 1u},
               std::uint64_t{parent + 1u});
    links_[v].parent = parent;
  }
  void set_side(std::uint32_t v, TreeSide side) {
    tr_.change(fields::kVertexSide.kind, v, static_cast<std::uint64_t>(links_[v].side),
               static_cast<std::uint64_t>(side));
    links_[v].side = side;
  }
  void set_cost(std::uint32_t v, Cost cost) {
    tr_.change(fields::kVertexCost.kind, v, links_[v].cost, cost);
    links_[v].cost = cost;
  }

  /// Costs of a vertex and all that hangs on it, from above to below.
  void settle(std::uint32_t v) {
    each_below(v, [this](std::uint32_t below) {
      const std::uint32_t over = parent(below);
      set_cost(below, over == kNone ? Cost::zero() : cost_over(over, place(below)));
    });
  }
  template <class Visit>
  void each_below(std::uint32_t v, Visit&& visit) {
    below_.assign(1, v);
    for (std::size_t i = 0; i < below_.size(); ++i) {
      const std::uint32_t at = below_[i];
      for (std::uint32_t child = links_[at].first_child; child != kNone; child = links_[child].next)
        below_.push_back(child);
      visit(at);
    }
  }
  /// Takes it out of its parent's children.
  void let_go(std::uint32_t v) {
    if (parent(v) == kNone) return;
    std::uint32_t* at = &links_[parent(v)].first_child;
    while (*at != v) at = &links_[*at].next;
    *at = links_[v].next;
  }
  void join_children(std::uint32_t v, std::uint32_t parent) {
    std::uint32_t* at = &links_[parent].first_child;
    while (*at != kNone && *at < v) at = &links_[*at].next;
    links_[v].next = *at;
    *at = v;
  }

  static constexpr std::array<Field, 3> kVertexPlace = {fields::kVertexX, fields::kVertexY, fields::kVertexZ};

  RunNumbers<T>& numbers_;
  T& tr_;
  std::vector<Place> places_;
  std::vector<Link> links_;
  std::array<PlaceIndex<D>, 2> index_;  // by side
  std::vector<std::uint32_t> below_;
};

}  // namespace replan
