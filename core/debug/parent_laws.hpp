// What holds in every best-first search, whatever a vertex is reached by: g is its parent's and the way from there, parents
// lead back to the start, and keys are f.
#pragma once

#include <string>

#include "core/debug/law_book.hpp"

namespace replan {

template <int D>
class ParentLaws : public LawBook<D> {
 public:
  void plan(PlanStatus status, std::span<const Hop>) override {
    if (!values_.on_map(goal_)) return;
    this->hold_status(status, "g", goal_, values_.at(goal_).g);
    if (has_path(status)) follow_parents();
  }

 protected:
  using LawBook<D>::values_;
  enum Bit : std::uint8_t { kParent = 1, kKey = 2, kFirstOwn = 4 };

  /// How its laws are told.
  struct Telling {
    const char* parent_law;
    const char* way_law;
    const char* hop;  ///< what leads from a parent to its child
  };

  ParentLaws(const LogView& view, LawValues<D>& values, const Telling& telling)
      : LawBook<D>(values),
        f_(view.info.key.f(view.settings)),
        start_(values.start()),
        goal_(values.goal()),
        key_law_(view.info.key.law),
        telling_(telling) {}

  /// What it costs to come to s from its parent; infinite if nothing leads there.
  [[nodiscard]] virtual Cost way(NodeId s, NodeId parent) const = 0;

  [[nodiscard]] virtual bool parent_is_right(NodeId s) const {
    const LawVertex& vertex = values_.at(s);
    if (s == start_) return vertex.g == Cost::zero() && vertex.lp == 0;
    if (vertex.g.is_infinite()) return vertex.lp == 0 && !vertex.queued();
    const Cost from_parent = vertex.lp == 0 ? Cost::infinity() : way(s, vertex.lp - 1u);
    if (from_parent.is_infinite()) return false;
    const LawVertex& parent = values_.at(vertex.lp - 1u);
    const Cost sum = parent.g + from_parent;
    return vertex.g == sum || (vertex.g > sum && parent.queued());
  }

  void hold_parent(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    const char* law = s == start_ ? "g(start) is 0" : telling_.parent_law;
    this->hold(s, kParent, law, parent_is_right(s), [&] {
      const std::string is = this->named("g", s) + " is " + cost_text(vertex.g);
      if (vertex.lp == 0) return is + " and it has no parent";
      const NodeId parent = vertex.lp - 1u;
      if (way(s, parent).is_infinite())
        return is + ", but no " + telling_.hop + " leads to it from " + this->named("its parent ", parent);
      return is + ", its parent's, " + this->named("g", parent) + ", is " + cost_text(values_.at(parent).g);
    });
  }

  void hold_key(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    const bool any = vertex.queued() && values_.on_map(goal_);
    const Cost h = any ? values_.known().bound(values_.heuristic(), s, goal_) : Cost::zero();
    const Cost f = any ? f_(vertex.g, h, values_.weight()) : Cost::zero();
    this->hold(s, kKey, key_law_, !any || vertex.k1() == f, [&] {
      return "the key of " + this->cell(s) + " is " + cost_text(vertex.k1()) + ", but it should be " +
             cost_text(f) + ": g is " + cost_text(vertex.g) + " and h is " + cost_text(h);
    });
  }

  virtual void follow_parents() {
    for (NodeId s = goal_; s != start_;) {
      const LawVertex& vertex = values_.at(s);
      const NodeId parent = vertex.lp - 1u;
      if (vertex.lp == 0 || way(s, parent).is_infinite())
        return this->find(
            s, telling_.way_law,
            std::string("no ") + telling_.hop + " leads to " + this->cell(s) + " from its parent");
      if (!g_falls(s, parent, "its parent", telling_.way_law)) return;
      s = parent;
    }
  }
  /// On the way from the goal to the start.
  bool g_falls(NodeId s, NodeId parent, const char* which, const char* law) {
    if (values_.at(parent).g < values_.at(s).g) return true;
    this->find(s, law,
               "from " + this->cell(s) + " to " + which + " " + this->cell(parent) + " g goes from " +
                   cost_text(values_.at(s).g) + " to " + cost_text(values_.at(parent).g));
    return false;
  }

  KeyRule::F f_;
  NodeId start_, goal_;  // as of the last step

 private:
  const char* key_law_;
  Telling telling_;
};

}  // namespace replan
