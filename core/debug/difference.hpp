// Where two planners' runs of one world part ways.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/cell.hpp"

namespace replan {

/// What is compared.
enum class Compare : std::uint8_t {
  events,      ///< every event of the kinds that both planners write
  expansions,  ///< which vertex is taken, and the g that it gets
  costs,       ///< what each plan costs
  moves,       ///< where the robot goes
};

/// The first place where they differ.
struct Difference {
  Compare what = Compare::expansions;
  std::array<std::size_t, 2> panes{};
  std::array<std::size_t, 2>
      positions{};  ///< past the two events that differ; the end of a log that has no more
  std::array<NodeId, 2> nodes{
      kNoNode, kNoNode};  ///< where they differ, of expansions and moves; kNoNode where it is no vertex
  std::string words;      ///< "expansion 214: D* Lite takes (31, 18), DLD* Lite takes (32, 19)"
};

}  // namespace replan
