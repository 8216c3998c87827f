#include "core/session/trace_export.hpp"

namespace replan {

TraceRun trace_run(const Run& run) {
  const auto path_at = [&run](std::size_t plan_end) -> Path {
    // The plan's decision stands right behind its plan_end.
    const Decision* decision = run.decision_at(plan_end + 1);
    if (decision == nullptr || decision->event != plan_end + 1) return {};
    return *decision->plan->path;
  };
  const Scenario& scenario = run.scenario();
  return {run.log_view(), scenario.name, scenario.start, scenario.goal, path_at, metric_frame(scenario.map)};
}

}  // namespace replan
