// Where the panes beside the leading one stand: each mode of lockstep as a pure function of two runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/session/run.hpp"

namespace replan {

/// What panes in lockstep have in common at every moment.
enum class Lockstep : std::uint8_t {
  expansions,  ///< the robot's step, which plan of that step it is, and the expansions into that plan
  moves,       ///< the robot's step: each stands where it goes on from there
  race,        ///< the expansions since the beginning: each goes on to its own end
};

/// How far a position is.
struct Progress {
  std::int64_t clock = -1;      ///< steps of the robot; -1 before the first plan stands
  std::int64_t plan = 0;        ///< decisions at this step before the latest one
  std::int64_t expansions = 0;  ///< since the latest decision
  bool begun = false;           ///< something has happened since the latest decision
  friend bool operator==(const Progress&, const Progress&) = default;
};
Progress progress(const Run& run, std::size_t position);
/// Expansions among the first `position` events.
std::int64_t expansions_until(const Run& run, std::size_t position);
/// Expansions among the events [from, to).
std::int64_t expansions_between(const Run& run, std::size_t from, std::size_t to);

/// Where a pane stands, in a run that may not have come far enough yet.
struct Standing {
  std::size_t position = 0;
  std::optional<Target> lacking = {};  ///< where the run has to go on to before the position is final
};

/// Where `follower` stands while `leader` stands at its cursor. Once the follower has run far enough this
/// depends on nothing but the two logs and that cursor. Where a plan has ended sooner than the leader's the
/// follower stands at its end. Where the leader's run is over, and the cursor at its end, all stand at their
/// ends.
Standing standing_beside(const Run& leader, const Run& follower, Lockstep by);

}  // namespace replan
