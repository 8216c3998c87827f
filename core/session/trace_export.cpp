#include "core/session/trace_export.hpp"

namespace replan {

TraceRun trace_run(const Run& run) {
  const auto path_at = [&run](std::size_t plan_end) -> Path {
    // The plan's decision stands right behind its plan_end.
    const Decision* decision = run.decision_at(plan_end + 1);
    if (decision == nullptr || decision->event != plan_end + 1) return {};
    return *decision->plan->path;
  };
  return {run.log_view(), run.scenario().name, run.scenario().start, run.scenario().goal, path_at};
}

}  // namespace replan
