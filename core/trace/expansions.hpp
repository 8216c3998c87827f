// The expansions of a log: its `visit` events.
#pragma once

#include <cstdint>
#include <optional>

#include "core/trace/event.hpp"

namespace replan {

constexpr bool is_expansion(const Event& event) {
  return event.kind == EventKind::visit;
}

/// Whether what follows an event of this kind is the search's own work, and not its setting up; nothing if
/// that stays as it was.
constexpr std::optional<bool> expands_from(EventKind kind) {
  if (kind == EventKind::pop) return true;
  if (kind == EventKind::plan_begin) return false;
  return std::nullopt;
}

/// Goes over a log event by event, from where it or a plan begins, and counts its expansions.
class ExpansionCounter {
 public:
  /// Takes the next event; whether it is an expansion.
  bool take(const Event& event) {
    if (const auto expands = expands_from(event.kind)) expands_ = *expands;
    count_ += is_expansion(event) ? 1 : 0;
    return is_expansion(event);
  }
  [[nodiscard]] std::int64_t count() const { return count_; }
  /// Whether the present plan has taken its first vertex: what is written since is the search's own work.
  [[nodiscard]] bool expands() const { return expands_; }

 private:
  bool expands_ = false;
  std::int64_t count_ = 0;
};

}  // namespace replan
