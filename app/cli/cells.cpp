// Cells as typed on the command line.
#include <optional>
#include <vector>

#include "app/cli/arguments.hpp"
#include "core/world/formats/text_lines.hpp"

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

/// The numbers of "1,2,3"; nothing if one of them is none.
std::optional<std::vector<int>> whole_numbers(std::string_view text) {
  std::vector<int> numbers;
  for (;;) {
    const std::size_t comma = text.find(',');
    const auto number = number_from<int>(text.substr(0, comma));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace

std::string cell_wanted(const Box& world) {
  return std::string(cell_form(world.solid())) + " with " + cell_range(world);
}

Result<Cell> parse_cell(std::string_view option, std::string_view text, bool solid) {
  const auto numbers = whole_numbers(text);
  if (numbers && numbers->size() == (solid ? 3u : 2u))
    return Cell{numbers->at(0), numbers->at(1), solid ? numbers->at(2) : 0};
  return Error{std::string(option) + " cannot be '" + std::string(text) + "': give a cell as " +
               cell_form(solid) + " in whole numbers, for example " + std::string(option) +
               (solid ? " 3,4,0" : " 3,4")};
}

Result<Cell> parse_cell_in(const Box& world, std::string_view option, std::string_view text,
                           const std::string& where) {
  const auto cell = parse_cell(option, text, world.solid());
  if (!cell || world.contains(*cell)) return cell;
  return Error{std::string(option) + " " + std::string(text) + " is outside " + where + ": give " +
               cell_range(world)};
}

}  // namespace replan::cli
