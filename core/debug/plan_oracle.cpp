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
struct RightCostSearch::Search {
  virtual ~Search() = default;
  virtual std::optional<Cost> advance() = 0;
};

/// From the start.
template <int D>
class RightCostSearch::Dijkstra final : public Search {
 public:
  explicit Dijkstra(const PlanQuestion& question)
      : map_(question.box.sides<D>(), question.known.plain(), question.rules), goal_(question.goal) {
    if (map_.blocked(question.start) || map_.blocked(goal_)) return;
    if (question.clearance) field_.emplace(map_, *question.clearance);
    costs_.assign(map_.node_count(), Cost::infinity());
    costs_[question.start] = Cost::zero();
    open_.push({0, question.start});
  }

  std::optional<Cost> advance() override {
    constexpr int kSlice = 2048;  // vertices
    for (int i = 0; i < kSlice && !open_.empty(); ++i) {
      const auto [cost, u] = open_.top();
      open_.pop();
      if (u == goal_) return Cost{cost};
      if (cost <= costs_[u].raw) relax(cost, u);
    }
    return open_.empty() ? std::optional(Cost::infinity()) : std::nullopt;
  }

 private:
  using Entry = std::pair<std::int64_t, NodeId>;

  void relax(std::int64_t cost, NodeId u) {
    for (std::uint32_t rest = map_.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const NodeId s = map_.neighbour(u, d);
      const Cost sum =
          Cost{cost} + BoxLattice<D>::step_cost(d) + (field_ ? field_->penalty(s) : Cost::zero());
      if (!(sum < costs_[s])) continue;
      costs_[s] = sum;
      open_.push({sum.raw, s});
    }
  }

  BoxLattice<D> map_;
  NodeId goal_;
  std::optional<ClearanceField<D>> field_;
  std::vector<Cost> costs_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

RightCostSearch::RightCostSearch(PlanQuestion question) : question_(std::move(question)) {}
RightCostSearch::~RightCostSearch() = default;

std::optional<Cost> RightCostSearch::advance() {
  if (search_) return search_->advance();
  with_dimensions(question_.box, [this](auto d) { search_ = std::make_unique<Dijkstra<d()>>(question_); });
  return std::nullopt;
}

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

Cost right_cost(const PlanQuestion& question, const StopToken& stop) {
  RightCostSearch search(question);
  while (!stop.stop_requested())
    if (const auto right = search.advance()) return *right;
  return Cost::infinity();
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
