// Asking the oracle: what should the plan that stands at some position of a log cost?
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/stop.hpp"
#include "core/debug/log_view.hpp"
#include "core/debug/oracle.hpp"
#include "core/field/clearance.hpp"

namespace replan {

/// A plan, and the map that it was made on. Owns all that the answer takes, so that it can be worked out
/// elsewhere.
struct PlanQuestion {
  std::size_t plan = 0;      ///< how many came before it
  std::size_t position = 0;  ///< past its plan_end
  Box box;
  MoveRules rules;
  SharedBytes known;                        ///< nonzero = obstacle
  std::optional<ClearanceRules> clearance;  ///< of planners that pay for coming near obstacles
  NodeId start = kNoNode, goal = kNoNode;
  Cost claimed;  ///< infinite if the planner found no path
  bool exact = true;
  bool straight = false;  ///< its cost is that of straight ways, which may be shorter than all lattice paths
  bool blind = false;     ///< and it may lead through anything
  bool sampling = false;  ///< it may find none where there is a path, and a longer one
};

/// Whether a planner with these settings claims that no plan costs less. The D* Lite family does, penalties
/// counted in: lines of sight shorten what it drives, not what it plans by. A* with an estimate that is too
/// long does not.
bool claims_cheapest(const PlannerInfo& info, const Settings& settings);

/// About the plan that stands past the event `position - 1`, a plan_end.
PlanQuestion ask_about(const LogView& view, std::size_t plan, std::size_t position);

/// What the plan should cost, by Dijkstra's algorithm from the start: no heuristic, nothing kept from earlier
/// plans, penalties from the map. Infinite if there is no path. A stop is heard; the answer is then of no
/// use.
Cost right_cost(const PlanQuestion& question, const StopToken& stop = {});

/// The same a slice at a time. Setting it up is the first slice, as long as the map is large.
class RightCostSearch {
 public:
  explicit RightCostSearch(PlanQuestion question);
  ~RightCostSearch();
  RightCostSearch(const RightCostSearch&) = delete;
  RightCostSearch& operator=(const RightCostSearch&) = delete;

  /// One slice. The answer, once it is there; not to be called again then.
  std::optional<Cost> advance();

 private:
  struct Search;
  template <int D>
  class Dijkstra;

  PlanQuestion question_;
  std::unique_ptr<Search> search_;
};

/// What is wrong with the claim, if anything. A plan that is not meant to be the cheapest may cost more, one on
/// straight ways less, and no more; a blind one costs less where there is no path, too.
std::optional<Disagreement> judge(const PlanQuestion& question, Cost right);

/// "plan 2 costs 43.799, but a path of 42.385 exists"
std::string disagreement_text(const Disagreement& disagreement);

}  // namespace replan
