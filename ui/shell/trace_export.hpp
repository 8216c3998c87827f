// A trace that the window writes: some of it in each frame, since the log is the drawing thread's.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/export/trace_file.hpp"
#include "core/session/session.hpp"

namespace replan::ui {

/// How it went, as a sentence.
struct ExportOutcome {
  std::string words;
  bool bad = false;
};

class TraceExport {
 public:
  /// Begins to write the leading run's log as it stands; with `map`, what the robot knows at its beginning
  /// goes to map_name(path). One that was being written is given up, and leaves nothing behind.
  Result<void> begin(const Session& session, const std::string& path, bool map);
  void cancel() { file_.reset(); }
  [[nodiscard]] bool busy() const { return file_ != nullptr; }
  /// From 0 to 1.
  [[nodiscard]] double share() const;

  /// Writes for a few milliseconds; once a frame. The outcome when it is done, failed, or cannot go on since
  /// the run was changed.
  std::optional<ExportOutcome> go_on(const Session& session);

  /// "x.trace.yaml" -> "x.trace.map": a name of its own, so that no map that was opened is written over.
  static std::string map_name(const std::string& path);

 private:
  ExportOutcome complete();

  std::unique_ptr<TraceFile> file_;
  std::shared_ptr<const Scenario> scenario_;  // what the file refers to
  std::uint64_t log_ = 0;                     // of the run
  std::string path_;
  bool map_ = false;
};

}  // namespace replan::ui
