#include "core/scene/first_path.hpp"

#include <algorithm>

#include "core/plan/tree_values.hpp"

namespace replan {
namespace {

/// A plan may give up an older path before it has its first one: that is one gain at most.
constexpr std::size_t kGainsToFirstPath = 2;

}  // namespace

void FirstPath::follow(const Run& run, const RunDigest& digest) {
  shown_ = false;
  const std::size_t cursor = run.timeline().cursor(), plans = digest.plans_before(cursor);
  if (!run.info().sampling || plans == 0) return;
  const PlanSpan& plan = digest.plans()[plans - 1];
  const bool same = log_id_ == run.log_id() && begin_ == plan.begin;
  if (!same || event_ == SIZE_MAX) read(run, plan);
  const std::uint64_t best = run.timeline().state().scalar(Scalar::best);
  shown_ = event_ < cursor && best != 0 && Cost{static_cast<std::int64_t>(best)} < cost_;
}

void FirstPath::read(const Run& run, const PlanSpan& plan) {
  const Timeline& log = run.timeline();
  log_id_ = run.log_id();
  begin_ = plan.begin;
  event_ = SIZE_MAX;
  gains_.follow(run.log_view(), log_id_, plan.begin, std::min(plan.end, log.size()), kGainsToFirstPath);
  const auto gains = gains_.gains();
  const auto first =
      std::find_if(gains.begin(), gains.end(), [](const PathGain& gain) { return !gain.cost.is_infinite(); });
  if (first == gains.end()) return;
  event_ = first->event;
  cost_ = first->cost;
  const SearchState state = log.state_at(first->event + 1);
  points_ = way_in_tree(state, goal_vertex(state), run.lattice().solid());
}

}  // namespace replan
