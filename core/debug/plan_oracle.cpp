#include "core/debug/plan_oracle.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <queue>
#include <string>
#include <utility>

#include "core/debug/event_words.hpp"
#include "core/debug/law_values.hpp"
#include "core/plan/common_parameters.hpp"
#include "core/plan/planner.hpp"

namespace replan {
namespace {

template <int D>
Cost cost_by_dijkstra(const PlanQuestion& question, const std::stop_token& stop) {
  const BoxLattice<D> map(question.box.sides<D>(), question.known.plain(), question.rules);
  if (map.blocked(question.start) || map.blocked(question.goal)) return Cost::infinity();
  std::optional<ClearanceField<D>> field;
  if (question.clearance) field.emplace(map, *question.clearance);
  std::vector<Cost> costs(map.node_count(), Cost::infinity());
  using Entry = std::pair<std::int64_t, NodeId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  costs[question.start] = Cost::zero();
  open.push({0, question.start});
  while (!open.empty() && !stop.stop_requested()) {
    const auto [cost, u] = open.top();
    open.pop();
    if (u == question.goal) return {cost};
    if (cost > costs[u].raw) continue;
    for (std::uint32_t rest = map.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const NodeId s = map.neighbour(u, d);
      const Cost sum = Cost{cost} + BoxLattice<D>::step_cost(d) + (field ? field->penalty(s) : Cost::zero());
      if (!(sum < costs[s])) continue;
      costs[s] = sum;
      open.push({sum.raw, s});
    }
  }
  return Cost::infinity();
}

}  // namespace

bool claims_cheapest(const PlannerInfo& info, const Settings& settings) {
  return info.values.least_cost || info.optimal(settings);
}

PlanQuestion ask_about(const LogView& view, std::size_t plan, std::size_t position) {
  const SearchState state = view.log.state_at(position);
  PlanQuestion question;
  question.plan = plan;
  question.position = position;
  question.box = view.lattice;
  question.rules = view.rules();
  question.known = state.known_map();
  if (view.info.clearance) question.clearance = view.info.clearance(view.settings);
  question.start = state.node(Scalar::start);
  question.goal = state.node(Scalar::goal);
  const auto status = static_cast<PlanStatus>(view.log.event(position - 1).delta);
  question.claimed = has_path(status) ? claimed_cost(view.info.values, state) : Cost::infinity();
  question.exact = claims_cheapest(view.info, view.settings);
  question.straight = view.info.any_angle && !view.info.values.least_cost;
  question.blind = view.info.blind;
  question.sampling = view.info.can_miss();
  return question;
}

Cost right_cost(const PlanQuestion& question, const std::stop_token& stop) {
  return with_dimensions(question.box, [&](auto d) { return cost_by_dijkstra<d()>(question, stop); });
}

std::optional<Disagreement> judge(const PlanQuestion& question, Cost right) {
  const Cost claimed = question.claimed;
  const bool agrees = question.exact      ? claimed == right
                      : question.sampling ? claimed.is_infinite() || !right.is_infinite()
                      : question.blind    ? claimed <= right
                      : question.straight ? claimed.is_infinite() == right.is_infinite() && claimed <= right
                                          : claimed.is_infinite() == right.is_infinite() && claimed >= right;
  if (agrees) return std::nullopt;
  return Disagreement{question.plan, question.position, question.claimed, right};
}

std::string disagreement_text(const Disagreement& disagreement) {
  const std::string plan = "plan " + std::to_string(disagreement.plan);
  if (disagreement.claimed.is_infinite())
    return plan + " finds no path, but one of " + cost_text(disagreement.right) + " exists";
  const std::string claims = plan + " claims a cost of " + cost_text(disagreement.claimed);
  if (disagreement.right.is_infinite()) return claims + ", but there is no path";
  return claims + ", but the cheapest path costs " + cost_text(disagreement.right);
}

}  // namespace replan
