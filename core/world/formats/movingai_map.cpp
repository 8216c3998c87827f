#include "core/base/file.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan {
namespace {

/// Up to two line-end bytes per cell (a map one column wide), and a header.
constexpr std::int64_t kMaxMapBytes = 3 * kMaxCells + 4096;

/// Reads one `.map` text, keeping the place for errors.
class MapParser {
 public:
  MapParser(std::string_view text, const std::string& origin) : lines_(text), origin_(origin) {}

  Result<GridMap> parse() {
    if (Result<void> header = read_header(); !header) return Error{header.error()};
    GridMap map(static_cast<int>(width_), static_cast<int>(height_));
    for (int y = 0; y < map.height; ++y)
      if (Result<void> row = read_row(map, y); !row) return Error{row.error()};
    while (const auto line = lines_.next())
      if (!line->empty())
        return wrong("more rows than the " + std::to_string(height_) + " that 'height' says");
    return map;
  }

 private:
  Error wrong(const std::string& what) const {
    return {origin_ + ":" + std::to_string(lines_.number()) + ": " + what};
  }

  Result<void> read_header() {
    bool typed = false;
    while (const auto line = lines_.next()) {
      std::string_view rest = *line;
      const std::string_view key = take_word(rest), value = take_word(rest);
      if (key.empty() && lines_.number() > 1) continue;
      if (!typed && key != "type") return wrong("not a MovingAI map: the first line must be 'type octile'");
      if (key == "map") return check_size();
      if (!take_word(rest).empty()) return wrong("too many words in the header line " + shown(*line));
      if (Result<void> field = read_field(key, value); !field) return field;
      typed = true;
    }
    return wrong("the file ends before the line 'map'");
  }

  Result<void> read_field(std::string_view key, std::string_view value) {
    if (key == "type") {
      if (value == "octile" || value == "tile") return {};
      return wrong("map type " + shown(value) + " is not known: only 'type octile' is");
    }
    if (key != "height" && key != "width")
      return wrong("unknown header line " + shown(key) + ": 'height', 'width' or 'map' belongs here");
    const auto number = number_from<std::int64_t>(value);
    // A number that is all digits and does not fit is too large, not malformed: any size beyond the limit
    // does.
    const bool digits = !value.empty() && value.find_first_not_of("0123456789") == std::string_view::npos;
    if (!digits || (number && *number == 0))
      return wrong(std::string(key) + " must be a whole number from 1, not " + shown(value));
    (key == "height" ? height_ : width_) = number && *number <= kMaxCells ? *number : kMaxCells + 1;
    return {};
  }

  Result<void> check_size() {
    if (height_ == 0 || width_ == 0)
      return wrong(std::string("the header lacks the line '") + (height_ == 0 ? "height" : "width") + " N'");
    if (height_ <= kMaxCells / width_) return {};
    return wrong("the map is too large: at most " + std::to_string(kMaxCells) +
                 " cells (8192 x 8192) are read");
  }

  Result<void> read_row(GridMap& map, int y) {
    const auto line = lines_.next();
    if (!line)
      return wrong("the file ends after " + std::to_string(y) + " of " + std::to_string(height_) + " rows");
    const std::size_t row = map.index({0, y});
    const std::size_t count = std::min(line->size(), static_cast<std::size_t>(map.width));
    for (std::size_t x = 0; x < count; ++x) {
      const MapLetter letter = map_letter((*line)[x]);
      if (letter == MapLetter::unknown) return unknown_letter(line->substr(x), x);
      if (letter == MapLetter::blocked) map.blocked[row + x] = kObstacle;
    }
    if (line->size() == count && count == static_cast<std::size_t>(map.width)) return {};
    return wrong("the row has " + std::to_string(line->size()) + " columns, not the " +
                 std::to_string(width_) + " that 'width' says");
  }

  Error unknown_letter(std::string_view letter, std::size_t x) const {
    return wrong("column " + std::to_string(x + 1) + ": unknown cell letter " + shown_letter(letter) +
                 "; known are . G S (free) and @ O T W (obstacle)");
  }

  LineReader lines_;
  const std::string& origin_;
  std::int64_t width_ = 0, height_ = 0;  // 0 = not read yet
};

}  // namespace

MapLetter map_letter(char letter) {
  switch (letter) {
    case '.':
    case 'G':
    case 'S':
      return MapLetter::free;
    case '@':
    case 'O':
    case 'T':
    case 'W':
      return MapLetter::blocked;
    default:
      return MapLetter::unknown;
  }
}

Result<GridMap> parse_movingai_map(std::string_view text, const std::string& origin) {
  return MapParser(text, origin).parse();
}

Result<GridMap> read_movingai_map(const std::string& path) {
  const Result<std::string> text = read_file(path, kMaxMapBytes);
  if (!text) return Error{text.error()};
  return parse_movingai_map(*text, path);
}

std::string movingai_map_text(const GridMap& map) {
  std::string text = "type octile\nheight " + std::to_string(map.height) + "\nwidth " +
                     std::to_string(map.width) + "\nmap\n";
  text.reserve(text.size() + map.blocked.size() + static_cast<std::size_t>(map.height));
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) text += map.at({x, y}) ? '@' : '.';
    text += '\n';
  }
  return text;
}

Result<void> write_movingai_map(const GridMap& map, const std::string& path) {
  return write_file_atomically(path, movingai_map_text(map));
}

}  // namespace replan
