#include "core/session/world_edit.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/base/words.hpp"
#include "core/lattice/box_words.hpp"
#include "core/lattice/seen_box.hpp"
#include "core/world/brush.hpp"
#include "core/world/choices.hpp"
#include "core/world/ends.hpp"
#include "core/world/generators/list.hpp"

namespace replan {
namespace {

const char* turn_text(Turn turn) {
  switch (turn) {
    case Turn::left:
      return "rotate the world left";
    case Turn::right:
      return "rotate the world right";
    case Turn::left_right:
      return "mirror the world left to right";
    case Turn::top_bottom:
      return "mirror the world top to bottom";
    case Turn::upside_down:
      return "turn the world upside down";
    case Turn::tip_back:
      return "tip the world back";
    case Turn::tip_forward:
      return "tip the world forward";
    case Turn::tip_left:
      return "tip the world to the left";
    case Turn::tip_right:
      return "tip the world to the right";
  }
  return "";
}

struct NewMap {
  GridMap map;
  std::optional<Cell> start, goal;
};

/// Whether the scenario's planners and its robot can do with a world of that size.
Result<void> check_dwellers(const Scenario& scenario, const Box& world) {
  for (const PlannerChoice& choice : scenario.planners)
    if (const auto fit = fits(info_of(choice), world, scenario.robot.radius); !fit) return Error{fit.error()};
  if (const auto robot = require_robot(scenario.robot.kind, world); !robot) return Error{robot.error()};
  return {};
}

Result<WorldEdit> with_map(const Scenario& scenario, std::string label, std::string name, NewMap made) {
  if (made.map.blocked.empty()) return Error{"a world has at least one cell"};
  for (const auto& end : {made.start, made.goal})
    if (end && !made.map.contains(*end)) return Error{"start and goal must lie on the map"};
  if (const auto able = check_dwellers(scenario, made.map.box()); !able) return Error{able.error()};
  Scenario changed = scenario;
  changed.map = std::move(made.map);
  changed.map_file.clear();
  changed.map_found = {};
  changed.name = std::move(name);
  changed.caption.clear();
  changed.surprises.clear();
  changed.movers.clear();
  changed.view.camera.reset();
  changed.start = {0, 0};
  changed.goal = {changed.map.width - 1, changed.map.height - 1, changed.map.depth - 1};
  place_ends(changed);
  changed.start = made.start.value_or(changed.start);
  changed.goal = made.goal.value_or(changed.goal);
  return WorldEdit{std::move(label), std::move(changed), 0};
}

/// Writes cells into a map, but no wall over its start and goal, and counts those that it changes.
class MapPainter {
 public:
  explicit MapPainter(const Scenario& scenario, std::size_t scripted)
      : edit_{"", scenario, scripted}, keep_{scenario.start, scenario.goal} {}

  void set(Cell cell, bool blocked) {
    GridMap& map = edit_.scenario.map;
    if (map.at(cell) == blocked || (blocked && (cell == keep_[0] || cell == keep_[1]))) return;
    map.set(cell, blocked);
    ++count_;
    painted_ = painted_ || blocked;
  }
  void set(const CellBox& box, bool blocked) {
    const GridMap& map = edit_.scenario.map;
    for (int z = std::max(0, box.low.z); z <= std::min(map.depth - 1, box.high.z); ++z)
      for (int y = std::max(0, box.low.y); y <= std::min(map.height - 1, box.high.y); ++y)
        for (int x = std::max(0, box.low.x); x <= std::min(map.width - 1, box.high.x); ++x)
          set(Cell{x, y, z}, blocked);
  }
  Result<WorldEdit> edit() {
    if (count_ == 0) return Error{"nothing was drawn: every cell of it is like that already"};
    edit_.label = (painted_ ? "paint " : "erase ") + counted(count_, "cell");
    return std::move(edit_);
  }

 private:
  WorldEdit edit_;
  std::array<Cell, 2> keep_;
  std::size_t count_ = 0;
  bool painted_ = false;
};

}  // namespace

Result<void> check_inside(std::span<const CellChange> cells, const GridMap& map) {
  for (const CellChange& change : cells)
    if (!map.contains(change.cell))
      return Error{"cell " + cell_text(change.cell, map.box().solid()) + " lies outside the world"};
  return {};
}

Scenario tidied(const Scenario& scenario, std::size_t scripted) {
  Scenario folded = scenario;
  if (folded.robot.knowledge == Knowledge::nothing) return folded;
  Surprises kept;
  bool first_of_all = true;  // nothing that may happen before the robot moves has been passed over
  for (std::size_t i = 0; i < folded.surprises.size(); ++i) {
    const Surprise& surprise = scenario.surprises[i];
    const bool before_start = surprise.at.near || surprise.at.move == 0;
    const bool only_cells = !surprise.goal && !surprise.robot;
    if (first_of_all && before_start && surprise.announced && only_cells && i >= scripted &&
        surprise.at.move) {
      for (const CellChange& change : surprise.cells) folded.map.set(change.cell, change.blocked);
      continue;
    }
    const Cell at = surprise.at.near.value_or(folded.start);
    const bool due = distance(at, folded.start) <= surprise.at.within;
    if (before_start && due) first_of_all = false;
    kept.push_back(surprise);
  }
  folded.surprises = std::move(kept);
  return folded;
}

Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const TurnWorld& command) {
  const Box size = turned_size(scenario.map.box(), command.turn);
  if (const auto fits_in = check_world_size(size); !fits_in) return Error{fits_in.error()};
  if (const auto able = check_dwellers(scenario, size); !able) return Error{able.error()};
  return WorldEdit{turn_text(command.turn), turned(scenario, command.turn), scripted};
}

Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const ResizeWorld& command) {
  Result<Resized> done = resized(scenario, command.size);
  if (!done) return Error{done.error()};
  if (const auto able = check_dwellers(scenario, done->scenario.map.box()); !able) return Error{able.error()};
  const auto lost = std::count_if(done->surprises_lost.begin(), done->surprises_lost.end(),
                                  [scripted](std::size_t index) { return index < scripted; });
  WorldEdit edit{"resize to " + sides_text(done->scenario.map.box()), std::move(done->scenario),
                 scripted - static_cast<std::size_t>(lost)};
  if (done->ends_moved)
    edit.notes.push_back("the start or the goal lay outside and moved to the nearest cell inside");
  if (done->cells_lost > 0)
    edit.notes.push_back(counted(done->cells_lost, "cell") + " of surprises lay outside and " +
                         (done->cells_lost == 1 ? "is" : "are") + " gone");
  return edit;
}

Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const InvertWorld&) {
  WorldEdit edit{"invert the world", scenario, scripted};
  const std::array keep = {scenario.start, scenario.goal};
  for (const CellChange& change : inversion(scenario.map, keep))
    edit.scenario.map.set(change.cell, change.blocked);
  return edit;
}

Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const ClearWorld&) {
  WorldEdit edit{"clear the world", scenario, scripted};
  edit.scenario.map.blocked = SharedBytes(scenario.map.blocked.size());
  return edit;
}

Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const PaintCells& command) {
  if (const auto inside = check_inside(command.cells, scenario.map); !inside) return Error{inside.error()};
  MapPainter painter(scenario, scripted);
  for (const CellChange& change : command.cells) painter.set(change.cell, change.blocked);
  return painter.edit();
}

Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const PaintBoxes& command) {
  MapPainter painter(scenario, scripted);
  for (const CellBox& box : command.boxes) painter.set(box, command.blocked);
  return painter.edit();
}

Result<WorldEdit> edited(const Scenario& scenario, std::size_t scripted, const FillRegion& command) {
  const GridMap& map = scenario.map;
  if (!map.contains(command.from)) return Error{"a region to fill begins in the world"};
  MapPainter painter(scenario, scripted);
  const SeenBox seen(map.box(), command.across);
  const Cell from = seen.seen(command.from);
  const int last = std::min(from.z + command.layers, seen.depth()) - 1;
  const auto fillable = [&](Cell at) {
    return map.at(seen.world(Cell{at.x, at.y, from.z})) != command.blocked;
  };
  for (const CellSpan& span : connected_spans(seen.width(), seen.height(), from, fillable))
    painter.set(
        box_of(seen.world(Cell{span.first, span.y, from.z}), seen.world(Cell{span.last, span.y, last})),
        command.blocked);
  return painter.edit();
}

Result<WorldEdit> edited(const Scenario& scenario, std::size_t, const ReplaceMap& command) {
  return with_map(scenario, "put in a map of " + sides_text(command.map.box()), "",
                  {command.map, command.start, command.goal});
}

Result<WorldEdit> edited(const Scenario& scenario, std::size_t, const GenerateWorld& command) {
  const auto info = require_generator(command.generator);
  if (!info) return Error{info.error()};
  Result<GridMap> map = generate(command.generator, command.settings,
                                 {command.width, command.height, command.layers}, command.seed);
  if (!map) return Error{map.error()};
  const std::string size = sides_text(map->box());
  return with_map(
      scenario,
      "generate " + std::string((*info)->id) + " of " + size + ", seed " + std::to_string(command.seed),
      std::string((*info)->name) + ", " + size, {*std::move(map), {}, {}});
}

}  // namespace replan
