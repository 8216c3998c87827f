// Edits of the whole world: what they make of a scenario, as plain functions, since they take as long as the world is
// large and are worked out on another thread where that is long.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/session/commands.hpp"
#include "core/session/document_change.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// What an edit comes to.
struct WorldEdit {
  std::string label;  ///< as undo tells it
  Scenario scenario;
  std::size_t scripted = 0;             ///< how many of its surprises came with the file
  std::vector<std::string> notes = {};  ///< what else there is to say
  DocumentChange change = {};           ///< from the document as it is, which was perhaps not tidied
};

/// Worlds of more cells than this are edited as a whole beside the session: 512 x 512 take some ten milliseconds.
inline constexpr std::size_t kLargeWorld = std::size_t{1} << 18;
/// A surprise at once changes at most so many cells.
inline constexpr std::size_t kMostSurprised = kLargeWorld;

/// The scenario with the edits that were made before the robot moved as parts of its map; the first `scripted`
/// surprises came with the file and stay what they are.
Scenario tidied(const Scenario& scenario, std::size_t scripted);

/// That cells to be changed lie in the world.
Result<void> check_inside(std::span<const CellChange> cells, const GridMap& map);

// Each is given a tidied scenario, of which `scripted` surprises came with the file.
Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const TurnWorld& command);
Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const ResizeWorld& command);
/// These two for worlds so large that the robot is not told of cell after cell: it plans afresh.
Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const InvertWorld& command);
Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const ClearWorld& command);
/// So are these, for so many cells.
Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const PaintCells& command);
Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const PaintBoxes& command);
Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const FillRegion& command);
/// What the old world was called, and what it was about, is not said of the new one.
Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const ReplaceMap& command);
Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const GenerateWorld& command);

}  // namespace replan
