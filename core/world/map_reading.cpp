#include "core/world/map_reading.hpp"

#include <algorithm>

#include "core/base/words.hpp"

namespace replan {

std::vector<std::string> MapFindings::notes_for_planning() const {
  std::vector<std::string> told = notes;
  if (unknown == nullptr || unknown_as != kObstacle) return told;
  const auto count = std::count(unknown->begin(), unknown->end(), true);
  told.push_back(
      counted(count, "unknown cell") + " of the map " + (count == 1 ? "counts" : "count") +
      " as blocked; --unknown free or --unknown unmapped makes it otherwise, as does the Open dialog");
  return told;
}

}  // namespace replan
