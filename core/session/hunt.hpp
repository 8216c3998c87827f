// What a hunt looks for, and how far it has come.
#pragma once

#include <cstdint>
#include <optional>

#include "core/session/commands.hpp"
#include "core/session/stop_search.hpp"

namespace replan {

/// A search along the leading run that its cursor waits for. It ends where something is found, at the end of
/// the run or of the log, or when the cursor, the run or what is looked for changes.
struct HuntTask {
  enum class Prey : std::uint8_t { breakpoint, change, arrival } prey = Prey::breakpoint;
  int direction = 1;
  GoToChange change{};                 // for Prey::change
  std::uint64_t log_id = 0;            // of the run that is searched
  std::size_t from = 0;                // where the cursor stands
  std::size_t looked = 0;              // events up to (or from) here were looked at
  std::size_t end = 0;                 // backwards: no farther than this; forwards: the log's size at first
  std::optional<StopSearch> search{};  // for Prey::breakpoint
};

}  // namespace replan
