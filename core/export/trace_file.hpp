// A run's log as a file for other programs. Written some events at a time, so that a window goes on drawing
// and a log of any length takes no more memory than a short one; the file has its name once it is whole.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/pending_file.hpp"
#include "core/debug/log_view.hpp"
#include "core/plan/path.hpp"
#include "core/world/map_frame.hpp"

namespace replan {

enum class TraceFormat : std::uint8_t {
  json_lines,    ///< .jsonl: every event with its values (core/export/json_lines.hpp)
  posthoc_yaml,  ///< .trace.yaml, .trace.yml: for the Posthoc visualiser (core/export/posthoc.hpp)
  posthoc_json,  ///< .trace.json: the same, larger and with null for infinity
};

/// The format that a file's name asks for. The error names the endings that there are.
Result<TraceFormat> trace_format(std::string_view path);
/// As trace_format(), for a run in `world`: Posthoc draws planes alone.
Result<TraceFormat> trace_format(std::string_view path, const Box& world);
/// The ending of `path` that tells its format: ".trace.yaml". Empty if it has none of them.
std::string_view trace_ending(std::string_view path);

/// What is written. All of it outlives the writing, and the log only grows meanwhile: events that come later
/// are left out.
struct TraceRun {
  LogView view;
  std::string scenario;  ///< its name
  Cell start, goal;      ///< before the run
  /// The path that the plan came to whose plan_end is the event of that index; empty without one.
  std::function<Path(std::size_t)> path_at;
  /// Of the map, where it is metric.
  std::optional<MapFrame> frame = {};
};

/// Turns events into the text of one format. Each function appends to `out`.
class TraceEncoder {
 public:
  virtual ~TraceEncoder() = default;
  /// What stands before the events, in so many parts: a large map in more than one.
  [[nodiscard]] virtual std::size_t head_parts() const = 0;
  virtual void head(std::string& out, std::size_t part) = 0;
  /// `state` is that before the event.
  virtual void event(std::string& out, std::size_t index, const Event& event, const SearchState& state) = 0;
  /// What stands after the events.
  virtual void tail(std::string& out, const SearchState& state) = 0;
};

/// One file being written.
class TraceFile {
 public:
  /// Writes nothing yet; fails where there cannot be such a file.
  static Result<std::unique_ptr<TraceFile>> create(const std::string& path, TraceRun run);

  /// Writes about as many events. True once all are written and the file stands under its name.
  Result<bool> advance(std::size_t events);
  /// How far it is, of total().
  [[nodiscard]] std::size_t done() const { return part_ + position_; }
  [[nodiscard]] std::size_t total() const { return encoder_->head_parts() + size_; }

 private:
  TraceFile(PendingFile file, TraceRun run, TraceFormat format);

  PendingFile file_;
  TraceRun run_;
  std::unique_ptr<TraceEncoder> encoder_;
  SearchState state_;  // at position_
  std::size_t size_;   // of the log, when it began
  std::size_t part_ = 0, position_ = 0;
  std::string buffer_;
};

/// As TraceFile, at one go.
Result<void> write_trace(const std::string& path, TraceRun run);

}  // namespace replan
