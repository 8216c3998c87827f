#include "core/world/sbpl_cfg.hpp"

#include "core/base/file.hpp"
#include "core/world/text_lines.hpp"

namespace replan {
namespace {

/// Costs are bytes in SBPL: up to three digits and a blank a cell.
constexpr std::int64_t kMaxCfgBytes = 5 * kMaxCells + 4096;
constexpr int kMaxCost = 255;

/// Reads one `.cfg` text, keeping the place for errors.
class SbplParser {
 public:
  SbplParser(std::string_view text, const std::string& origin) : lines_(text), origin_(origin) {}

  Result<MapFile> parse() {
    std::int64_t width = 0, height = 0, threshold = 0;
    Cell start, goal;
    if (auto read = read_size(width, height); !read) return Error{read.error()};
    if (auto read = read_header("obsthresh:", {{&threshold, 1, kMaxCost}}); !read) return Error{read.error()};
    if (auto read = read_cell("start(cells):", width, height, start); !read) return Error{read.error()};
    if (auto read = read_cell("end(cells):", width, height, goal); !read) return Error{read.error()};
    if (auto read = read_header("environment:", {}); !read) return Error{read.error()};
    MapFile world{{}, start, goal};
    world.map.width = static_cast<int>(width);
    world.map.height = static_cast<int>(height);
    if (auto read = read_costs(world, static_cast<int>(threshold)); !read) return Error{read.error()};
    return world;
  }

 private:
  struct Number {
    std::int64_t* value;
    std::int64_t low, high;
  };

  Error wrong(const std::string& what) const {
    return {origin_ + ":" + std::to_string(lines_.number()) + ": " + what};
  }

  /// The next word, wherever its line ends; empty at the end of the text.
  std::string_view next_word() {
    for (;;) {
      if (const std::string_view word = take_word(line_); !word.empty()) return word;
      const auto line = lines_.next();
      if (!line) return {};
      line_ = *line;
    }
  }

  Result<void> read_header(const std::string& name, std::initializer_list<Number> numbers) {
    if (const std::string_view word = next_word(); word != name)
      return wrong("'" + name + "' belongs here, not " + shown(word) +
                   "; only SBPL's nav2d environments are read");
    for (const Number& number : numbers) {
      const std::string_view word = next_word();
      const auto value = number_from<std::int64_t>(word);
      if (!value || *value < number.low || *value > number.high)
        return wrong("a number of '" + name + "' must be whole, from " + std::to_string(number.low) + " to " +
                     std::to_string(number.high) + ", not " + shown(word));
      *number.value = *value;
    }
    return {};
  }

  Result<void> read_size(std::int64_t& width, std::int64_t& height) {
    auto read = read_header("discretization(cells):", {{&width, 1, kMaxCells}, {&height, 1, kMaxCells}});
    if (!read || height <= kMaxCells / width) return read;
    return wrong("the map is too large: at most " + std::to_string(kMaxCells) +
                 " cells (8192 x 8192) are read");
  }

  Result<void> read_cell(const std::string& name, std::int64_t width, std::int64_t height, Cell& cell) {
    std::int64_t x = 0, y = 0;
    auto read = read_header(name, {{&x, 0, width - 1}, {&y, 0, height - 1}});
    cell = {static_cast<int>(x), static_cast<int>(y)};
    return read;
  }

  Result<void> read_costs(MapFile& world, int threshold) {
    const auto count = static_cast<std::size_t>(world.map.width) * static_cast<std::size_t>(world.map.height);
    std::vector<std::uint8_t> cells;
    std::int64_t lost = 0;
    while (cells.size() < count) {
      const std::string_view word = next_word();
      if (word.empty())
        return wrong("the file ends after " + std::to_string(cells.size()) + " of " + std::to_string(count) +
                     " costs");
      const auto cost = number_from<int>(word);
      if (!cost || *cost < 0 || *cost > kMaxCost)
        return wrong("a cost must be a whole number from 0 to " + std::to_string(kMaxCost) + ", not " +
                     shown(word));
      cells.push_back(*cost >= threshold ? kObstacle : kFree);
      lost += *cost > 0 && *cost < threshold ? 1 : 0;
    }
    world.map.blocked = cells;
    if (const std::string_view word = next_word(); !word.empty())
      return wrong("the file goes on after its " + std::to_string(count) + " costs: " + shown(word));
    if (lost > 0)
      world.notes.push_back(origin_ + ": the costs of " + std::to_string(lost) +
                            " free cells are lost: here all cells cost the same");
    return {};
  }

  LineReader lines_;
  std::string_view line_;
  const std::string& origin_;
};

}  // namespace

Result<MapFile> parse_sbpl_cfg(std::string_view text, const std::string& origin) {
  return SbplParser(text, origin).parse();
}

Result<MapFile> read_sbpl_cfg(const std::string& path) {
  const Result<std::string> text = read_file(path, kMaxCfgBytes);
  if (!text) return Error{text.error()};
  return parse_sbpl_cfg(*text, path);
}

std::string sbpl_cfg_text(const MapFile& world) {
  const auto two = [](int a, int b) { return std::to_string(a) + " " + std::to_string(b) + "\n"; };
  const GridMap& map = world.map;
  std::string text = "discretization(cells): " + two(map.width, map.height) + "obsthresh: 1\n";
  text += "start(cells): " + two(world.start->x, world.start->y);
  text += "end(cells): " + two(world.goal->x, world.goal->y) + "environment:\n";
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      text += map.at({x, y}) ? '1' : '0';
      text += x + 1 < map.width ? ' ' : '\n';
    }
  return text;
}

Result<void> write_sbpl_cfg(const MapFile& world, const std::string& path) {
  if (!world.start || !world.goal)
    return Error{"cannot write '" + path + "': a .cfg needs start and goal; give both"};
  return write_file_atomically(path, sbpl_cfg_text(world));
}

}  // namespace replan
