// The laws of a planner's values, one book for each kind that laws.def names.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/words.hpp"
#include "core/debug/event_words.hpp"
#include "core/debug/law_values.hpp"
#include "core/plan/planner.hpp"

namespace replan {

/// A law that does not hold somewhere.
struct Finding {
  NodeId node;
  const char* law;
  std::string words;
};

/// A vertex that the planner found in sight of another while it read out its path. Of several from one vertex
/// it goes to the last.
struct Hop {
  NodeId from, to;
};

/// Holds a run's values against the laws, once a step: the vertices that it touched and those that depend on
/// them. A law that does not hold somewhere is found once, until it held there again.
template <int D>
class LawBook {
 public:
  explicit LawBook(LawValues<D>& values) : values_(values) {}
  virtual ~LawBook() = default;
  LawBook(const LawBook&) = delete;
  LawBook& operator=(const LawBook&) = delete;

  /// A step is finished: what it touched is in the values.
  virtual void step() = 0;
  /// A plan stands, and its last step is finished.
  virtual void plan(PlanStatus status, std::span<const Hop> hops) = 0;
  /// All laws at one vertex.
  virtual void look(NodeId node) = 0;

  /// What was found since the last call, by node.
  [[nodiscard]] std::vector<Finding> take();

 protected:
  /// `words` is called if the law is newly broken. `law` is one of few for each bit.
  template <class Words>
  void hold(NodeId node, std::uint8_t bit, const char* law, bool holds, Words&& words) {
    if (holds == ((values_.at(node).broken & bit) == 0)) return;
    values_.write(node).broken ^= bit;
    if (!holds) find(node, law, words());
  }
  void find(NodeId node, const char* law, std::string words) {
    found_.push_back({node, law, std::move(words)});
  }
  /// "rhs(31, 18)"
  [[nodiscard]] std::string named(const char* value, NodeId node) const {
    return value + (values_.on_map(node) ? cell_text(values_.known().position(node), D == 3) : " of no cell");
  }
  [[nodiscard]] std::string cell(NodeId node) const { return named("", node); }
  /// The direction from a node to a neighbour that the known map lets it move to; -1 if there is none.
  [[nodiscard]] int direction(NodeId from, NodeId to) const;
  /// Whether start and goal are on the map and free.
  [[nodiscard]] bool ends_free() const;
  /// Touches the vertices of `held` and `now` if they differ, and remembers the latter.
  void follow(NodeId& held, NodeId now);
  /// A plan is there exactly if the value that promises one is finite and its ends are free.
  void hold_status(PlanStatus status, const char* value, NodeId node, Cost promised);

  LawValues<D>& values_;

 private:
  std::vector<Finding> found_;
};

/// The laws for the view's planner. `values` must outlive them.
template <int D>
std::unique_ptr<LawBook<D>> make_law_book(const LogView& view, LawValues<D>& values);
template <int D>
std::unique_ptr<LawBook<D>> make_lookahead_laws(const LogView& view, LawValues<D>& values);
template <int D>
std::unique_ptr<LawBook<D>> make_interpolated_laws(const LogView& view, LawValues<D>& values);
template <int D>
std::unique_ptr<LawBook<D>> make_best_first_laws(const LogView& view, LawValues<D>& values);
template <int D>
std::unique_ptr<LawBook<D>> make_any_angle_laws(const LogView& view, LawValues<D>& values);
template <int D>
std::unique_ptr<LawBook<D>> make_jump_laws(const LogView& view, LawValues<D>& values);
template <int D>
std::unique_ptr<LawBook<D>> make_back_pointer_laws(const LogView& view, LawValues<D>& values);
template <int D>
std::unique_ptr<LawBook<D>> make_no_laws(const LogView& view, LawValues<D>& values);

}  // namespace replan
