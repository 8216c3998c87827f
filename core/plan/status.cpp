#include "core/plan/planner.hpp"

namespace replan {

const char* status_name(PlanStatus status) {
  switch (status) {
    case PlanStatus::searching:
      return "searching";
    case PlanStatus::found:
      return "found";
    case PlanStatus::no_path:
      return "no-path";
    case PlanStatus::start_blocked:
      return "start-blocked";
    case PlanStatus::goal_blocked:
      return "goal-blocked";
    case PlanStatus::found_nearest:
      return "found-nearest";
    case PlanStatus::none_found:
      return "none-found";
  }
  return "unknown";
}

const char* status_sentence(PlanStatus status, bool has_size) {
  switch (status) {
    case PlanStatus::searching:
      return "The search is not finished.";
    case PlanStatus::found:
      return "A path is found.";
    case PlanStatus::no_path:
      return "No path leads to the goal.";
    case PlanStatus::start_blocked:
      return has_size ? "The start is inside an obstacle, or so near to one that the robot's radius does not "
                        "fit there "
                        "and no way leads out: move it, clear cells, or make the radius smaller."
                      : "The start is inside an obstacle: move it, or clear its cell.";
    case PlanStatus::goal_blocked:
      return has_size ? "The goal is inside an obstacle, or nearer to one than the robot's radius: move it, "
                        "clear cells, "
                        "or make the radius smaller."
                      : "The goal is inside an obstacle: move it, or clear its cell.";
    case PlanStatus::found_nearest:
      return "The goal cannot be reached: the path leads to the reachable cell nearest to it.";
    case PlanStatus::none_found:
      return "No path was found, which does not mean that there is none: more samples or generations may "
             "find one, or another seed.";
  }
  return "";
}

}  // namespace replan
