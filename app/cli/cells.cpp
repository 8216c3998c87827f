// Cells as typed on the command line.
#include <optional>
#include <vector>

#include "app/cli/arguments.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/map_frame.hpp"

namespace replan::cli {
namespace {

std::string cell_range(const Box& world) {
  const auto to = [](const char* axis, int side) {
    return std::string(axis) + " from 0 to " + std::to_string(side - 1);
  };
  return to("x", world.width()) + ", " + to("y", world.height()) +
         (world.solid() ? ", " + to("z", world.depth()) : "");
}

/// How a cell of the world is typed.
const char* cell_form(bool solid) {
  return solid ? "X,Y,Z" : "X,Y";
}

/// The numbers of "1,2,3", each followed by the unit; nothing if one of them is none.
template <class Number>
std::optional<std::vector<Number>> numbers_of(std::string_view text, std::string_view unit) {
  std::vector<Number> numbers;
  for (;;) {
    const std::size_t comma = text.find(',');
    std::string_view part = text.substr(0, comma);
    if (!part.ends_with(unit)) return std::nullopt;
    part.remove_suffix(unit.size());
    const auto number = number_from<Number>(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

/// The corners of the map in its frame.
std::string metres_range(const GridMap& map, const MapFrame& frame) {
  const bool solid = map.box().solid();
  const auto columns = static_cast<double>(map.width), rows = static_cast<double>(map.height),
             layers = static_cast<double>(map.depth);
  return metres_text(frame.to_metres({0, rows, 0}), solid) + " to " +
         metres_text(frame.to_metres({columns, 0, layers}), solid);
}

/// The cell of "1.5m,2m".
Result<Cell> cell_at_metres(const GridMap& map, std::string_view option, std::string_view text,
                            const std::string& where) {
  const MapFrame frame(map);
  const bool solid = map.box().solid();
  const std::string typed = std::string(option) + " " + std::string(text);
  if (!frame.metric())
    return Error{typed + " is in metres, but " + where + " does not say how large its cells are: give " +
                 cell_wanted(map.box())};
  const auto metres = numbers_of<double>(text, "m");
  if (!metres || metres->size() != (solid ? 3u : 2u))
    return Error{std::string(option) + " cannot be '" + std::string(text) + "': give a place in metres as " +
                 (solid ? "1.5m,2m,0.5m" : "1.5m,2m") + ", or " + cell_wanted(map.box())};
  const Point place = frame.to_cells({metres->at(0), metres->at(1), solid ? metres->at(2) : 0});
  const auto inside = [](double at, int side) { return at >= 0 && at < side; };
  if (!inside(place.x, map.width) || !inside(place.y, map.height) || !inside(place.z, map.depth))
    return Error{typed + " is outside " + where + ": its corners are " + metres_range(map, frame)};
  return cell_of(place);
}

}  // namespace

std::string cell_wanted(const Box& world) {
  return std::string(cell_form(world.solid())) + " with " + cell_range(world);
}

Result<Cell> parse_cell(std::string_view option, std::string_view text, bool solid) {
  const auto numbers = numbers_of<int>(text, "");
  if (numbers && numbers->size() == (solid ? 3u : 2u))
    return Cell{numbers->at(0), numbers->at(1), solid ? numbers->at(2) : 0};
  return Error{std::string(option) + " cannot be '" + std::string(text) + "': give a cell as " +
               cell_form(solid) + " in whole numbers, for example " + std::string(option) +
               (solid ? " 3,4,0" : " 3,4")};
}

Result<Cell> parse_cell_in(const GridMap& map, std::string_view option, std::string_view text,
                           const std::string& where) {
  const Box world = map.box();
  if (text.find('m') != std::string_view::npos) return cell_at_metres(map, option, text, where);
  const auto cell = parse_cell(option, text, world.solid());
  if (!cell || world.contains(*cell)) return cell;
  return Error{std::string(option) + " " + std::string(text) + " is outside " + where + ": give " +
               cell_range(world)};
}

}  // namespace replan::cli
