#include "core/world/formats/sbpl_cfg.hpp"

#include <cmath>

#include "core/base/file.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/json_reader.hpp"

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
    MapFile world;
    if (auto read = read_size(width, height); !read) return Error{read.error()};
    // Headings are of the robot's (x, y, theta); the grid is the same for any number of them.
    std::int64_t headings = 0;
    if (word_ahead() == "NumThetaDirs:")
      if (auto read = read_header("NumThetaDirs:", {{&headings, 1, kMaxCost}}); !read)
        return Error{read.error()};
    if (auto read = read_header("obsthresh:", {{&threshold, 1, kMaxCost}}); !read) return Error{read.error()};
    auto read = word_ahead() == "cost_inscribed_thresh:" ? read_poses(world, width, height)
                                                         : read_cells(world, width, height);
    if (!read) return Error{read.error()};
    if (read = read_header("environment:", {}); !read) return Error{read.error()};
    world.map.width = static_cast<int>(width);
    world.map.height = static_cast<int>(height);
    if (read = read_costs(world, static_cast<int>(threshold)); !read) return Error{read.error()};
    return world;
  }

 private:
  struct Number {
    std::int64_t* value;
    std::int64_t low, high;
  };

  Error wrong(const std::string& what) const { return wrong_at(lines_.number(), what); }
  Error wrong_at(int line, const std::string& what) const {
    return {origin_ + ":" + std::to_string(line) + ": " + what};
  }

  /// The next word, wherever its line ends, without taking it; empty at the end of the text.
  std::string_view word_ahead() {
    for (;;) {
      std::string_view rest = line_;
      if (const std::string_view word = take_word(rest); !word.empty()) return word;
      const auto line = lines_.next();
      if (!line) return {};
      line_ = *line;
    }
  }
  std::string_view next_word() { return word_ahead().empty() ? std::string_view() : take_word(line_); }

  /// Takes a header's name. What is missing behind it is told at its own line, wherever the next word is.
  Result<void> read_name(const std::string& name) {
    const std::string_view word = next_word();
    header_line_ = lines_.number();
    if (word == name) return {};
    return wrong("'" + name + "' belongs here, not " + shown(word) +
                 "; SBPL's environments of cells (nav2d) and of (x, y, theta) are read");
  }

  Result<void> read_header(const std::string& name, std::initializer_list<Number> numbers) {
    if (auto read = read_name(name); !read) return read;
    for (const Number& number : numbers) {
      const std::string_view word = next_word();
      const auto value = number_from<std::int64_t>(word);
      if (!value || *value < number.low || *value > number.high)
        return wrong_at(value ? lines_.number() : header_line_,
                        "a number of '" + name + "' must be whole, from " + std::to_string(number.low) +
                            " to " + std::to_string(number.high) + ", not " + shown(word));
      *number.value = *value;
    }
    return {};
  }

  /// As read_header() for numbers that need not be whole.
  Result<void> read_reals(const std::string& name, std::initializer_list<double*> numbers, double low,
                          double high) {
    if (auto read = read_name(name); !read) return read;
    for (double* const number : numbers) {
      const std::string_view word = next_word();
      const auto value = number_from<double>(word);
      if (!value || !(*value >= low && *value <= high))
        return wrong_at(value ? lines_.number() : header_line_,
                        "a number of '" + name + "' must be from " + plain_number(low).dump() + " to " +
                            plain_number(high).dump() + ", not " + shown(word));
      *number = *value;
    }
    return {};
  }

  Result<void> read_size(std::int64_t& width, std::int64_t& height) {
    auto read = read_header("discretization(cells):", {{&width, 1, kMaxCells}, {&height, 1, kMaxCells}});
    if (!read || height <= kMaxCells / width) return read;
    return wrong("the map is too large: at most " + std::to_string(kMaxCells) +
                 " cells (8192 x 8192) are read");
  }

  Result<void> read_cell(const std::string& name, std::int64_t width, std::int64_t height,
                         std::optional<Cell>& cell) {
    std::int64_t x = 0, y = 0;
    auto read = read_header(name, {{&x, 0, width - 1}, {&y, 0, height - 1}});
    cell = {static_cast<int>(x), static_cast<int>(y)};
    return read;
  }

  /// Start and end of a nav2d environment.
  Result<void> read_cells(MapFile& world, std::int64_t width, std::int64_t height) {
    auto read = read_cell("start(cells):", width, height, world.start);
    return read ? read_cell("end(cells):", width, height, world.goal) : read;
  }

  Result<void> read_pose(const std::string& name, std::int64_t width, std::int64_t height, double cell_size,
                         std::optional<Cell>& cell) {
    double x = 0, y = 0, heading = 0;
    if (auto read = read_reals(name, {&x, &y, &heading}, -kMaxOrigin, kMaxOrigin); !read) return read;
    const double column = std::floor(x / cell_size), row = std::floor(y / cell_size);
    if (column < 0 || row < 0 || column >= static_cast<double>(width) || row >= static_cast<double>(height))
      return wrong_at(header_line_, "'" + name + "' lies outside the map of " + std::to_string(width) +
                                        " x " + std::to_string(height) + " cells of " +
                                        plain_number(cell_size).dump() + " m");
    cell = {static_cast<int>(column), static_cast<int>(row)};
    return {};
  }

  /// What an environment of (x, y, theta) has in the place of start and end cell.
  Result<void> read_poses(MapFile& world, std::int64_t width, std::int64_t height) {
    std::int64_t cost = 0;
    double number = 0, cell_size = 0;
    for (const char* name : {"cost_inscribed_thresh:", "cost_possibly_circumscribed_thresh:"})
      if (auto read = read_header(name, {{&cost, -1, kMaxCost}}); !read) return read;
    if (auto read = read_reals("cellsize(meters):", {&cell_size}, kMinResolution, kMaxResolution); !read)
      return read;
    for (const char* name : {"nominalvel(mpersecs):", "timetoturn45degsinplace(secs):"})
      if (auto read = read_reals(name, {&number}, 0, kMaxOrigin); !read) return read;
    world.map.resolution = cell_size;
    world.found.notes.push_back(origin_ +
                                ": the headings of start and end, the robot's speeds and its size are lost: "
                                "only the grid is read");
    auto read = read_pose("start(meters,rads):", width, height, cell_size, world.start);
    return read ? read_pose("end(meters,rads):", width, height, cell_size, world.goal) : read;
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
      world.found.notes.push_back(origin_ + ": the costs of " + std::to_string(lost) +
                                  " free cells are lost: here all cells cost the same");
    return {};
  }

  LineReader lines_;
  std::string_view line_;
  int header_line_ = 0;  // of the header's name read last
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
