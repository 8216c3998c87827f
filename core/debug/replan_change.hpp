// The cells that made a robot plan again: what of the world was another than its map said.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/shared_array.hpp"
#include "core/debug/log_view.hpp"

namespace replan {

/// What stood in a cell, or stands there no longer.
enum class ChangeKind : std::uint8_t {
  wall,       ///< an obstacle of the map as it was drawn, which the robot had not known of
  surprise,   ///< an obstacle that appeared
  moving,     ///< something that moves
  free,       ///< nothing any more
  forgotten,  ///< nothing that the robot still counts on: what moved there is out of its sight
};

struct ChangedCell {
  NodeId node = kNoNode;
  ChangeKind kind{};
};

/// Those that the robot saw or was told of just before the plan that begins with the event `begin`, in the order in which
/// the log has them, but no more than the last `most`. `drawn` is the map as it was drawn: nonzero = obstacle.
std::vector<ChangedCell> changes_before(const LogView& view, std::size_t begin, const SharedBytes& drawn,
                                        std::size_t most);

}  // namespace replan
