#include "ui/shell/trace_export.hpp"

#include <algorithm>
#include <chrono>

#include "core/base/file.hpp"
#include "core/session/trace_export.hpp"
#include "core/sim/mission.hpp"
#include "core/world/map_file.hpp"

namespace replan::ui {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kFrameTime = std::chrono::milliseconds(4);
/// Events between two looks at the clock.
constexpr std::size_t kSlice = 2000;

}  // namespace

std::string TraceExport::map_name(const std::string& path) {
  return path.substr(0, path.size() - file_extension(path).size()) + ".map";
}

Result<void> TraceExport::begin(const Session& session, const std::string& path, bool map) {
  cancel();
  auto file = TraceFile::create(path, trace_run(session.run()));
  if (!file) return Error{file.error()};
  file_ = std::move(file.value());
  scenario_ = session.snapshot();
  log_ = session.run().log_id();
  path_ = path;
  map_ = map;
  return {};
}

double TraceExport::share() const {
  return busy() ? static_cast<double>(file_->done()) /
                      static_cast<double>(std::max<std::size_t>(1, file_->total()))
                : 0;
}

std::optional<ExportOutcome> TraceExport::go_on(const Session& session) {
  if (!busy()) return std::nullopt;
  // The run may be gone: it is looked at only if one with that log is still there.
  const auto runs = session.runs();
  if (std::none_of(runs.begin(), runs.end(), [this](const auto& run) { return run->log_id() == log_; })) {
    cancel();
    return ExportOutcome{"The export was stopped, because its run has changed. Export it again", true};
  }
  const auto end = Clock::now() + kFrameTime;
  do {
    const Result<bool> done = file_->advance(kSlice);
    if (!done) {
      cancel();
      return ExportOutcome{done.error(), true};
    }
    if (*done) return complete();
  } while (Clock::now() < end);
  return std::nullopt;
}

ExportOutcome TraceExport::complete() {
  cancel();
  if (!map_) return {"Exported the trace to " + file_name(path_)};
  GridMap known = scenario_->map;
  known.blocked = initial_knowledge(*scenario_);
  const std::string map = map_name(path_);
  if (const Result<void> written = write_map(known, map); !written)
    return {"Exported the trace, but not its map: " + written.error(), true};
  return {"Exported the trace to " + file_name(path_) + ", its map to " + file_name(map)};
}

}  // namespace replan::ui
