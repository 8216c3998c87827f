// What an edit did to a scenario: as much of it as changed, so that it can be taken back and made again.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/world/scenario.hpp"

namespace replan {

/// The difference between two versions of a scenario. Takes memory for the cells and surprises that differ.
struct DocumentChange {
  /// A cell of the map, by its index, and what stands there (kFree, kObstacle, kUnmapped).
  struct CellValue {
    std::uint32_t cell;
    std::uint8_t before, after;
  };

  std::vector<CellValue> cells;                             ///< of a map of which little changed
  SharedBytes map_before, map_after;                        ///< of one that became another, else empty
  std::size_t common = 0;                                   ///< surprises that both lists begin with
  std::vector<Surprise> surprises_before, surprises_after;  ///< those behind them
  std::shared_ptr<const Scenario> rest_before, rest_after;  ///< all else; nullptr if it stayed

  [[nodiscard]] bool replaces_map() const { return !map_before.empty() || !map_after.empty(); }
};

/// Whether two versions differ in nothing but the cells of their maps.
bool only_cells_differ(const Scenario& a, const Scenario& b);
DocumentChange change_between(const Scenario& before, const Scenario& after);
/// Leads from the version after a change to the one before it, and the other way.
void take_back(const DocumentChange& change, Scenario& scenario);
void make_again(const DocumentChange& change, Scenario& scenario);
/// Makes one change of two that followed each other; neither may replace the map.
void append(DocumentChange& first, DocumentChange second);

}  // namespace replan
