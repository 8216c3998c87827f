// A run of a session as the source of a trace.
#pragma once

#include "core/export/trace_file.hpp"
#include "core/session/run.hpp"

namespace replan {

/// What a trace of the run is made of. The run must outlive the trace and must not be cut back meanwhile: as
/// long as its log_id() stays the same.
TraceRun trace_run(const Run& run);

}  // namespace replan
