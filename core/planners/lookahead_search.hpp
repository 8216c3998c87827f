// What searches with a lookahead have in common: beside g each vertex has rhs, what its neighbours' g promise now, and the
// open list holds those whose two differ. LPA* has its root at the start, D* Lite at the goal.
//
// rhs is updated incrementally (Koenig & Likhachev, "Fast replanning for navigation in unknown terrain", IEEE Trans.
// Robotics 21(3), 2005, "optimised D* Lite"): where one neighbour improved, the minimum is that of two numbers; where one
// got worse, it is taken anew only if that neighbour was the argmin. Costs and parents are those of the plain version.
//
// Self is the planner: a class that derives from it and has it for a friend, with
//  * search_needed() and compute_shortest_path_step(), one iteration, false if there was nothing left to do;
// and, if it calls moves_changed(),
//  * root(), the vertex whose rhs is 0;
//  * update_vertex(u), which takes rhs(u) anew, and offer(u, at, d, sum), a way to u in direction d.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/plan/node_table.hpp"
#include "core/plan/search_record.hpp"

namespace replan {

template <Lattice L, Tracer T, class Vertex, class Self>
class LookaheadSearch : public SearchRecord<L, T, NodeTable<Vertex>> {
 public:
  bool advance(std::int64_t iterations) final {
    for (; iterations > 0; --iterations)
      if (!self().compute_shortest_path_step()) return true;
    return !self().search_needed();
  }

 protected:
  using Record = SearchRecord<L, T, NodeTable<Vertex>>;
  using Record::Record;

  [[nodiscard]] Key top_key() const { return this->open_.empty() ? Key{} : this->open_.top().key; }
  /// min(g(s), rhs(s)).
  [[nodiscard]] Cost least(NodeId s) const { return std::min(this->nodes_[s].g, this->nodes_[s].rhs); }

  /// The moves of u have changed.
  void moves_changed(NodeId u, std::uint32_t before) {
    if (u == self().root()) return;
    const std::uint32_t now = this->lattice_.moves(u), parent = this->nodes_[u].parent;
    if (parent != Record::kNoDirection && ((before & ~now) >> parent & 1u) != 0)
      return self().update_vertex(u);
    for (std::uint32_t rest = now & ~before; rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const Cost sum = L::step_cost(d) + this->nodes_[this->lattice_.neighbour(u, d)].g;
      if (!sum.is_infinite())
        self().offer(u, this->lattice_.coordinates(u), static_cast<std::uint32_t>(d), sum);
    }
  }

  /// As set_g(), but that rhs is the first value of a vertex that is written.
  void set_rhs(NodeId s, Cost value) {
    Vertex& node = this->nodes_.write(s);
    this->tr_.change(EventKind::rhs, s, node.rhs, value);
    node.rhs = value;
  }

 private:
  [[nodiscard]] Self& self() { return static_cast<Self&>(*this); }
};

}  // namespace replan
