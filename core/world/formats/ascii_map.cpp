#include "core/world/formats/ascii_map.hpp"

#include <algorithm>

#include "core/base/file.hpp"
#include "core/base/words.hpp"
#include "core/lattice/box_words.hpp"
#include "core/world/formats/number_cells.hpp"
#include "core/world/formats/text_cells.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan {
namespace {

/// Numbers as numpy.savetxt() prints them take 25 bytes a cell.
constexpr std::int64_t kMaxTextBytes = 26 * kMaxCells + 4096;

constexpr std::string_view kFreeLetters = ".-_ ", kObstacleLetters = "@#Xx";
constexpr std::string_view kKnown =
    "; known are . 0 - _ and blank (free), @ # X 1 (obstacle), ? (unmapped), S (start) and G (goal)";

/// Reads one text, keeping the place for errors.
class AsciiParser {
 public:
  AsciiParser(std::string_view text, const std::string& origin, std::optional<double> occupied)
      : text_(text),
        layout_(find_layout(text)),
        scanner_(text, layout_),
        origin_(origin),
        occupied_(occupied),
        cells_(occupied) {}

  Result<MapFile> parse() {
    if (Result<void> around = check_around(); !around) return Error{around.error()};
    bool ended = false;
    for (piece_ = scanner_.next(); piece_.kind != CellPiece::Kind::end; piece_ = scanner_.next()) {
      if (piece_.kind == CellPiece::Kind::wrong) return wrong(column_text() + std::string(piece_.text));
      if (piece_.kind == CellPiece::Kind::row_end) {
        if (x_ > 0 || layout_.nested) {
          if (Result<void> row = end_row(); !row) return Error{row.error()};
        } else {
          ended = y_ > 0;
        }
        continue;
      }
      if (ended) {
        if (Result<void> layer = end_layer(); !layer) return Error{layer.error()};
        ended = false;
      }
      if (Result<void> cell = read_cell(); !cell) return Error{cell.error()};
      ++x_;
    }
    return finish();
  }

 private:
  [[nodiscard]] Error wrong(const std::string& what) const {
    return {origin_ + ":" + std::to_string(piece_.line) + ": " + what};
  }
  [[nodiscard]] std::string column_text() const { return "column " + std::to_string(piece_.column) + ": "; }

  [[nodiscard]] std::ptrdiff_t line_at(std::size_t place) const {
    return 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(place), '\n');
  }

  /// Around a matrix there may be what a program puts there, such as "grid = np.array(" and ")", no cells.
  [[nodiscard]] Result<void> check_around() const {
    if (layout_.parting != Parting::brackets) return {};
    const auto blank = [](char c) { return is_blank(c) || c == '\n'; };
    std::string_view before = text_.substr(0, layout_.begin), after = text_.substr(layout_.end);
    while (!before.empty() && blank(before.back())) before.remove_suffix(1);
    while (!after.empty() && blank(after.front())) after.remove_prefix(1);
    if (!before.empty() && std::string_view("=(:").find(before.back()) == std::string_view::npos)
      return Error{origin_ + ":1: " + shown(before) +
                   " stands before the brackets: only a matrix, or a name and =, is read"};
    if (after.find_first_of("[]{}") != std::string_view::npos ||
        (!after.empty() && std::string_view("),;").find(after.front()) == std::string_view::npos))
      return Error{origin_ + ":" + std::to_string(line_at(text_.size() - after.size())) +
                   ": the text goes on after the matrix: " + shown(after)};
    return {};
  }

  Result<void> end_row() {
    if (y_ == 0) width_ = x_;
    if (x_ != width_)
      return wrong("the row has " + counted(x_, "cell") + ", the rows before it have " +
                   std::to_string(width_) + ": make them equally long" +
                   (layout_.parting == Parting::nothing ? " (blanks at the end count as free cells)" : ""));
    x_ = 0;
    ++y_;
    return {};
  }

  /// An empty line parts two layers.
  Result<void> end_layer() {
    const int rows = y_ - layer_begin_;
    if (layer_begin_ == 0) height_ = rows;
    if (rows != height_) return wrong_layer(rows);
    layer_begin_ = y_;
    return {};
  }
  [[nodiscard]] Error wrong_layer(int rows) const {
    return wrong("empty lines part layers, and the one before this has " + counted(rows, "row") +
                 ", the first " + std::to_string(height_) +
                 ": make them equally high, or leave out the empty lines");
  }

  Result<void> read_cell() {
    if (cells_.size() >= static_cast<std::size_t>(kMaxCells))
      return wrong("the map is too large: at most " + std::to_string(kMaxCells) + " cells are read");
    const std::string_view word = piece_.text;
    const char letter = word.size() == 1 ? word.front() : '\0';
    if (letter == 'S' || letter == 'G') return read_end(letter);
    if (letter >= '0' && letter <= '9') return read_number(letter - '0');
    const bool is_free = kFreeLetters.find(letter) != std::string_view::npos;
    const bool is_obstacle = !is_free && kObstacleLetters.find(letter) != std::string_view::npos;
    if (!is_free && !is_obstacle && letter != '?') {
      const auto number = cell_number(word);
      return number ? read_number(*number) : unknown_cell(piece_);
    }
    cells_.add_known(is_free ? kFree : is_obstacle ? kObstacle : kUnmapped);
    letters_ = true;
    return odd_number_ ? unknown_cell(*odd_number_) : Result<void>{};
  }

  /// Letters and numbers but 0 and 1 do not go together.
  Result<void> read_number(double number) {
    cells_.add(number);
    if (!odd_number_ && number != 0 && number != 1) odd_number_ = piece_;
    return odd_number_ && letters_ ? unknown_cell(*odd_number_) : Result<void>{};
  }

  Result<void> read_end(char letter) {
    cells_.add_known(kFree);
    std::optional<Cell>& end = letter == 'S' ? world_.start : world_.goal;
    if (end)
      return wrong(column_text() + "a second " + letter + ": there can be only one " +
                   (letter == 'S' ? "start" : "goal"));
    end = Cell{static_cast<int>(x_), y_ - layer_begin_, height_ > 0 ? layer_begin_ / height_ : 0};
    return {};
  }

  Error unknown_cell(const CellPiece& piece) {
    piece_ = piece;
    const std::string_view word = piece.text;
    if (word == "...")
      return wrong(column_text() +
                   "'...' stands for cells that numpy left out: print them all with "
                   "numpy.set_printoptions(threshold=sys.maxsize), or save the array as .npy");
    if (word.size() == first_character(word))
      return wrong(column_text() + "unknown cell letter " + shown_letter(word) + std::string(kKnown));
    return wrong(column_text() + "unknown cell " + shown(word) + std::string(kKnown) + ", and numbers");
  }

  Result<MapFile> finish() {
    if (y_ == 0) return Error{origin_ + ": there is no row of cells in it"};
    if (width_ == 0) return Error{origin_ + ": the rows have no cells in them"};
    world_.found.numbers = cells_.numbers();
    if (occupied_ && world_.found.numbers.empty())
      return Error{origin_ + ": its letters say themselves what is an obstacle; --occupied is for numbers"};
    world_.map.width = static_cast<int>(width_);
    if (height_ == 0) height_ = y_;
    if (const int rows = y_ - layer_begin_; rows != height_) return wrong_layer(rows);
    world_.map.height = height_;
    world_.map.depth = y_ / height_;
    if (const std::string parted = parting_sentence(layout_); !parted.empty())
      world_.found.notes.push_back(origin_ + ": " + parted + ": " + sides_text(world_.map.box()) +
                                   " of them");
    auto cells = cells_.finish(origin_, world_.found.notes);
    if (!cells) return Error{cells.error()};
    world_.map.blocked = std::move(cells.value());
    return std::move(world_);
  }

  std::string_view text_;
  TextLayout layout_;
  CellScanner scanner_;
  const std::string& origin_;
  std::optional<double> occupied_;
  NumberCells cells_;
  CellPiece piece_;                      // read last
  std::optional<CellPiece> odd_number_;  // the first one but 0 and 1
  bool letters_ = false;                 // there are some but S and G
  std::size_t x_ = 0, width_ = 0;
  int y_ = 0;            // rows of all layers
  int layer_begin_ = 0;  // the row with which the last of them begins
  int height_ = 0;       // rows of a layer, once one has ended
  MapFile world_;
};

}  // namespace

Result<MapFile> parse_ascii_map(std::string_view text, const std::string& origin,
                                std::optional<double> occupied) {
  return AsciiParser(without_byte_order_mark(text), origin, occupied).parse();
}

Result<MapFile> read_ascii_map(const std::string& path, std::optional<double> occupied) {
  const Result<std::string> text = read_file(path, kMaxTextBytes);
  if (!text) return Error{text.error()};
  return parse_ascii_map(*text, path, occupied);
}

std::string ascii_text(const MapFile& world) {
  const GridMap& map = world.map;
  return ascii_text(world, {{0, 0, 0}, {map.width - 1, map.height - 1, map.depth - 1}});
}

namespace {

/// Rows of one layer; nothing is empty.
std::string layer_text(const MapFile& world, const CellBox& part, int z) {
  const GridMap& map = world.map;
  const auto width = static_cast<std::size_t>(part.high.x - part.low.x + 1);
  std::string text((width + 1) * static_cast<std::size_t>(part.high.y - part.low.y + 1), '\n');
  const auto letter = [&](Cell cell) -> char& {
    return text[static_cast<std::size_t>(cell.y - part.low.y) * (width + 1) +
                static_cast<std::size_t>(cell.x - part.low.x)];
  };
  for (int y = part.low.y; y <= part.high.y; ++y) {
    const auto row = map.blocked.begin() + static_cast<std::ptrdiff_t>(map.index({part.low.x, y, z}));
    std::transform(row, row + static_cast<std::ptrdiff_t>(width), &letter({part.low.x, y}),
                   [](std::uint8_t cell) { return ".@?"[cell]; });
  }
  const auto mark = [&](const std::optional<Cell>& cell, char sign) {
    if (!cell || cell->z != z || cell->x < part.low.x || cell->x > part.high.x || cell->y < part.low.y ||
        cell->y > part.high.y)
      return;
    if (map.blocked[map.index(*cell)] == kFree) letter(*cell) = sign;
  };
  mark(world.goal, 'G');
  mark(world.start, 'S');
  return text;
}

}  // namespace

std::string ascii_text(const MapFile& world, const CellBox& part) {
  const GridMap& map = world.map;
  const CellBox inside = {{std::max(part.low.x, 0), std::max(part.low.y, 0), std::max(part.low.z, 0)},
                          {std::min(part.high.x, map.width - 1), std::min(part.high.y, map.height - 1),
                           std::min(part.high.z, map.depth - 1)}};
  std::string text;
  if (inside.low.x > inside.high.x || inside.low.y > inside.high.y) return text;
  for (int z = inside.low.z; z <= inside.high.z; ++z)
    text += (z > inside.low.z ? "\n" : "") + layer_text(world, inside, z);
  return text;
}

}  // namespace replan
