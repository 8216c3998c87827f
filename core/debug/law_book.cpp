#include "core/debug/law_book.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace replan {

std::vector<Finding> LawBook::take() {
  std::stable_sort(found_.begin(), found_.end(),
                   [](const Finding& a, const Finding& b) { return a.node < b.node; });
  return std::exchange(found_, {});
}

int LawBook::direction(NodeId from, NodeId to) const {
  const Grid2& known = values_.known();
  for (std::uint32_t rest = known.moves(from); rest != 0; rest &= rest - 1)
    if (const int d = std::countr_zero(rest); known.neighbour(from, d) == to) return d;
  return -1;
}

bool LawBook::ends_free() const {
  const auto is_free = [this](NodeId node) { return values_.on_map(node) && !values_.known().blocked(node); };
  return is_free(values_.start()) && is_free(values_.goal());
}

void LawBook::follow(NodeId& held, NodeId now) {
  if (held == now) return;
  for (const NodeId node : {held, now})
    if (values_.on_map(node)) values_.touch(node, LawVertex::all);
  held = now;
}

void LawBook::hold_status(PlanStatus status, const char* value, NodeId node, Cost promised) {
  if (has_path(status) == (ends_free() && !promised.is_infinite())) return;
  find(node, "a plan is found exactly if its cost is finite and its ends are free",
       std::string("the planner says '") + status_name(status) + "', but " + named(value, node) + " is " +
           cost_text(promised));
}

std::unique_ptr<LawBook> make_law_book(const LogView& view, LawValues& values) {
  return view.info.values == SearchValues::lookahead ? make_lookahead_laws(view, values)
                                                     : make_best_first_laws(values);
}

}  // namespace replan
