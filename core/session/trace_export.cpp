#include "core/session/trace_export.hpp"

namespace replan {

TraceRun trace_run(const Run& run) {
  const auto path_at = [&run](std::size_t plan_end) -> Path {
    // The plan's mark stands right behind its plan_end.
    const Mark* mark = run.mark_at(plan_end + 1);
    if (mark == nullptr || mark->event != plan_end + 1) return {};
    return *mark->plan->path;
  };
  return {run.log_view(), run.scenario().name, run.scenario().start, run.scenario().goal, path_at};
}

}  // namespace replan
