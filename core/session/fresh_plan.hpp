// What a plan from scratch would have cost where a planner repaired its old one.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/background.hpp"
#include "core/session/run.hpp"

namespace replan {

struct FreshPlan {
  std::int64_t touched = 0;  ///< vertices whose g or rhs was written or that were expanded
  std::int64_t expansions = 0;
  double ms = 0;  ///< wall time, recorded as the run itself
};

/// What a plan from scratch is made of.
struct FreshPlanTask {
  /// The plan of the run's planner at the cursor, on the map that the robot knows there.
  explicit FreshPlanTask(const Run& run);

  PlannerChoice choice;
  Box box;
  SharedBytes known;  ///< nonzero = obstacle
  double radius = 0;  ///< of the robot
  NodeId start = kNoNode, goal = kNoNode;
};

/// Plans it and counts. The planner must be in the registry; a stop is heard between slices, what was counted
/// until then is returned.
FreshPlan plan_from_scratch(const FreshPlanTask& task, const StopToken& stop);

/// The same a slice at a time. Setting the planner up takes the first two, each as long as the map is large.
class FreshPlanSearch {
 public:
  explicit FreshPlanSearch(FreshPlanTask task);
  ~FreshPlanSearch();
  FreshPlanSearch(const FreshPlanSearch&) = delete;
  FreshPlanSearch& operator=(const FreshPlanSearch&) = delete;

  /// One slice. True while there is more to plan.
  bool advance();
  /// What was counted so far.
  [[nodiscard]] FreshPlan counted() const;

 private:
  class TouchCount;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Such figures for the replans of runs, worked out one at a time beside the caller or in step, and kept.
class FreshPlans {
 public:
  explicit FreshPlans(WorkPlace place = WorkPlace::beside()) : job_(std::move(place)) {}

  /// For the plan that `number` plans of the run came before (0 is the first), with the cursor after its
  /// beginning and before the next one's. Nothing while it is being worked out; ask again. With `wait` it is
  /// worked out at once.
  std::optional<FreshPlan> of(const Run& run, std::size_t number, bool wait);
  /// Whether an answer is on its way: another frame is due for it.
  [[nodiscard]] bool busy();

 private:
  using Key = std::pair<std::uint64_t, std::size_t>;  // log and number of the plan
  struct Job {
    Key key;
    FreshPlanTask task;
  };

  void go_on();

  std::optional<Job> next_;     // of several that are asked for the latest
  std::optional<Key> working_;  // what is being worked out
  std::map<Key, FreshPlan> known_;
  Background<FreshPlan> job_;
};

}  // namespace replan
