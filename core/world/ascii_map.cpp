#include "core/world/ascii_map.hpp"

#include <algorithm>

#include "core/base/file.hpp"
#include "core/world/text_lines.hpp"

namespace replan {
namespace {

constexpr std::int64_t kMaxTextBytes = 3 * kMaxCells + 4096;

constexpr std::string_view kFreeLetters = ".0-_ SG", kObstacleLetters = "@#Xx1";

/// The next row without its end, blanks at the end kept: they are cells.
std::string_view take_row(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  std::string_view row = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  if (row.ends_with('\r')) row.remove_suffix(1);
  return row;
}

/// Reads one text, keeping the place for errors.
class AsciiParser {
 public:
  AsciiParser(std::string_view text, const std::string& origin) : rest_(text), origin_(origin) {}

  Result<MapFile> parse() {
    std::vector<std::uint8_t> cells;
    std::size_t width = 0;
    int height = 0;
    for (bool ended = false; !rest_.empty();) {
      const std::string_view row = take_row(rest_);
      ++line_;
      if (row.empty()) {
        ended = height > 0;
        continue;
      }
      if (ended) return wrong("a row after an empty line: the rows must follow each other");
      if (height == 0) width = row.size();
      if (row.size() != width)
        return wrong("the row has " + std::to_string(row.size()) + " cells, the rows before it have " +
                     std::to_string(width) +
                     ": make them equally long (blanks at the end count as free cells)");
      if (cells.size() + width > static_cast<std::size_t>(kMaxCells))
        return wrong("the map is too large: at most " + std::to_string(kMaxCells) + " cells are read");
      if (Result<void> read = read_row(row, height, cells); !read) return Error{read.error()};
      ++height;
    }
    if (height == 0) return Error{origin_ + ": there is no row of cells in it"};
    world_.map.width = static_cast<int>(width);
    world_.map.height = height;
    world_.map.blocked = std::move(cells);
    return std::move(world_);
  }

 private:
  Error wrong(const std::string& what) const { return {origin_ + ":" + std::to_string(line_) + ": " + what}; }

  Result<void> read_row(std::string_view row, int y, std::vector<std::uint8_t>& cells) {
    for (std::size_t x = 0; x < row.size(); ++x) {
      const char letter = row[x];
      const bool is_free = kFreeLetters.find(letter) != std::string_view::npos;
      const bool is_obstacle = kObstacleLetters.find(letter) != std::string_view::npos;
      if (!is_free && !is_obstacle && letter != '?')
        return wrong(
            "column " + std::to_string(x + 1) + ": unknown cell letter " + shown(row.substr(x, 1)) +
            "; known are . 0 - _ and blank (free), @ # X 1 (obstacle), ? (unmapped), S (start) and G (goal)");
      cells.push_back(is_free ? kFree : is_obstacle ? kObstacle : kUnmapped);
      if (letter != 'S' && letter != 'G') continue;
      std::optional<Cell>& end = letter == 'S' ? world_.start : world_.goal;
      if (end)
        return wrong("column " + std::to_string(x + 1) + ": a second " + letter + ": there can be only one " +
                     (letter == 'S' ? "start" : "goal"));
      end = Cell{static_cast<int>(x), y};
    }
    return {};
  }

  std::string_view rest_;
  const std::string& origin_;
  int line_ = 0;
  MapFile world_;
};

}  // namespace

Result<MapFile> parse_ascii_map(std::string_view text, const std::string& origin) {
  return AsciiParser(text, origin).parse();
}

Result<MapFile> read_ascii_map(const std::string& path) {
  const Result<std::string> text = read_file(path, kMaxTextBytes);
  if (!text) return Error{text.error()};
  return parse_ascii_map(*text, path);
}

std::string ascii_text(const MapFile& world) {
  return ascii_text(world, {0, 0, world.map.width, world.map.height});
}

std::string ascii_text(const MapFile& world, const MapRegion& region) {
  const GridMap& map = world.map;
  const auto end_of = [](int from, int length, int size) {
    return static_cast<int>(std::min<std::int64_t>(size, std::int64_t{from} + length));
  };
  const int right = end_of(region.x, region.width, map.width);
  const int bottom = end_of(region.y, region.height, map.height);
  std::string text;
  for (int y = std::max(0, region.y); y < bottom; ++y) {
    for (int x = std::max(0, region.x); x < right; ++x) {
      const std::uint8_t cell = map.blocked[map.index({x, y})];
      const bool start = cell == kFree && world.start == Cell{x, y};
      const bool goal = cell == kFree && world.goal == Cell{x, y};
      text += start ? 'S' : goal ? 'G' : ".@?"[cell];
    }
    text += '\n';
  }
  return text;
}

}  // namespace replan
