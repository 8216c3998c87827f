// The laws that a planner's values must keep, held against its log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/cell.hpp"

namespace replan {

/// A law that does not hold at some position of a log, though no step is half done there.
struct Breach {
  std::size_t position = 0;  ///< of the log: the end of the first step after which it does not hold
  NodeId node = kNoNode;     ///< where
  std::string law;           ///< "rhs(s) is the least c + g + dist of its successors"
  std::string words;         ///< what is and what should be, with numbers
};

/// How far a log was held against the laws, and what came of it.
struct LawReport {
  bool on = false;
  std::size_t checked = 0;      ///< events of the log that were looked at
  std::size_t breaches = 0;     ///< found so far
  std::optional<Breach> first;  ///< the first of them
};

}  // namespace replan
