// The expansions of a log: its `visit` events.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/trace/timeline.hpp"

namespace replan {

/// Whether what follows an event of this kind is the search's own work, and not its setting up; nothing if
/// that stays as it was.
constexpr std::optional<bool> expands_from(EventKind kind) {
  if (kind == EventKind::pop) return true;
  if (kind == EventKind::plan_begin) return false;
  return std::nullopt;
}

/// Goes over a log event by event and counts its expansions.
class ExpansionCounter {
 public:
  /// Begins where a log or a plan begins.
  ExpansionCounter() = default;
  /// Begins at a position of the log, with none counted yet.
  ExpansionCounter(const Timeline& log, std::size_t position);

  /// Takes the next event; whether it is an expansion.
  bool take(const Event& event) {
    if (const auto expands = expands_from(event.kind)) expands_ = *expands;
    const bool expansion = event.kind == EventKind::visit;
    count_ += expansion ? 1 : 0;
    return expansion;
  }
  [[nodiscard]] std::int64_t count() const { return count_; }
  /// Whether the present plan has taken its first vertex: what is written since is the search's own work.
  [[nodiscard]] bool expands() const { return expands_; }

 private:
  bool expands_ = false;
  std::int64_t count_ = 0;
};

}  // namespace replan
