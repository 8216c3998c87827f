#include "core/debug/law_book.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace replan {

template <int D>
std::vector<Finding> LawBook<D>::take() {
  std::stable_sort(found_.begin(), found_.end(),
                   [](const Finding& a, const Finding& b) { return a.node < b.node; });
  return std::exchange(found_, {});
}

template <int D>
int LawBook<D>::direction(NodeId from, NodeId to) const {
  const BoxLattice<D>& known = values_.known();
  for (std::uint32_t rest = known.moves(from); rest != 0; rest &= rest - 1)
    if (const int d = std::countr_zero(rest); known.neighbour(from, d) == to) return d;
  return -1;
}

template <int D>
bool LawBook<D>::ends_free() const {
  const auto is_free = [this](NodeId node) { return values_.on_map(node) && !values_.known().blocked(node); };
  return is_free(values_.start()) && is_free(values_.goal());
}

template <int D>
void LawBook<D>::follow(NodeId& held, NodeId now) {
  if (held == now) return;
  for (const NodeId node : {held, now})
    if (values_.on_map(node)) values_.touch(node, LawVertex::all);
  held = now;
}

template <int D>
void LawBook<D>::hold_status(PlanStatus status, const char* value, NodeId node, Cost promised) {
  if (has_path(status) == (ends_free() && !promised.is_infinite())) return;
  find(node, "a plan is found exactly if its cost is finite and its ends are free",
       std::string("the planner says '") + status_name(status) + "', but " + named(value, node) + " is " +
           cost_text(promised));
}

template <int D>
std::unique_ptr<LawBook<D>> make_law_book(const LogView& view, LawValues<D>& values) {
  return view.info.values == SearchValues::lookahead ? make_lookahead_laws<D>(view, values)
                                                     : make_best_first_laws<D>(view, values);
}

template class LawBook<2>;
template class LawBook<3>;
template std::unique_ptr<LawBook<2>> make_law_book(const LogView&, LawValues<2>&);
template std::unique_ptr<LawBook<3>> make_law_book(const LogView&, LawValues<3>&);

}  // namespace replan
