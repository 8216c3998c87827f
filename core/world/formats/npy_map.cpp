#include "core/world/formats/npy_map.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/file.hpp"
#include "core/world/formats/number_cells.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::int64_t kMaxHeader = 1 << 16;  // more than any array of two dimensions writes
constexpr std::int64_t kMaxNpyBytes = 8 * kMaxCells + kMaxHeader + 12;

std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + (big_endian ? i : size - 1 - i)]);
  return value;
}

/// What the header says: a dictionary in Python's words, {'descr': '<i8', 'fortran_order': False, 'shape':
/// (3, 4), }.
struct NpyHeader {
  char order = '|';  // < or > where there is more than one byte
  char kind = 'b';   // b, i or u
  std::size_t size = 1;
  bool fortran_order = false;
  std::int64_t rows = 0, columns = 0;
};

/// Reads one file, keeping the place for errors.
class NpyParser {
 public:
  NpyParser(std::string_view bytes, const std::string& origin) : bytes_(bytes), origin_(origin) {}

  Result<MapFile> parse(std::optional<double> occupied) {
    if (Result<void> read = find_header(); !read) return Error{read.error()};
    if (Result<void> read = read_dictionary(); !read) return Error{read.error()};
    const auto rows = static_cast<std::size_t>(header_.rows),
               columns = static_cast<std::size_t>(header_.columns);
    const std::size_t count = rows * columns, there = values_.size() / header_.size;
    if (there < count)
      return wrong("the file ends after " + std::to_string(there) + " of " + std::to_string(count) +
                   " values");
    if (values_.size() != count * header_.size)
      return wrong("the file goes on after its " + std::to_string(count) + " values: save the array anew");
    NumberCells cells(occupied);
    for (std::size_t y = 0; y < rows; ++y)
      for (std::size_t x = 0; x < columns; ++x)
        cells.add(value(header_.fortran_order ? x * rows + y : y * columns + x));
    MapFile world;
    world.map.width = static_cast<int>(columns);
    world.map.height = static_cast<int>(rows);
    world.found.numbers = cells.numbers();
    auto kinds = cells.finish(origin_, world.found.notes);
    if (!kinds) return Error{kinds.error()};
    world.map.blocked = std::move(kinds.value());
    return world;
  }

 private:
  [[nodiscard]] Error wrong(const std::string& what) const { return {origin_ + ": " + what}; }

  [[nodiscard]] double value(std::size_t index) const {
    const std::uint64_t raw = number_at(values_, index * header_.size, header_.size, header_.order == '>');
    if (header_.kind == 'b') return raw != 0 ? 1 : 0;
    if (header_.kind == 'u' || header_.size == 8)
      return header_.kind == 'u' ? static_cast<double>(raw)
                                 : static_cast<double>(static_cast<std::int64_t>(raw));
    const std::uint64_t sign = std::uint64_t{1} << (8 * header_.size - 1);
    return static_cast<double>(static_cast<std::int64_t>(raw ^ sign) - static_cast<std::int64_t>(sign));
  }

  /// Parts the file into header and values.
  Result<void> find_header() {
    if (!bytes_.starts_with(kMagic) || bytes_.size() < 10)
      return wrong("not a .npy file: it must begin as numpy.save() writes it");
    const int version = static_cast<unsigned char>(bytes_[6]);
    if (version < 1 || version > 3)
      return wrong("version " + std::to_string(version) + " of the .npy format is not known: 1 to 3 are");
    const std::size_t wide = version == 1 ? 2 : 4, begin = 8 + wide;
    const std::uint64_t length = bytes_.size() < begin ? kMaxHeader + 1 : number_at(bytes_, 8, wide, false);
    if (length > static_cast<std::uint64_t>(kMaxHeader) || bytes_.size() - begin < length)
      return wrong("the header ends early or is longer than any of two dimensions");
    const std::size_t end = begin + static_cast<std::size_t>(length);
    rest_ = bytes_.substr(begin, end - begin);
    values_ = bytes_.substr(end);
    return {};
  }

  Error malformed() const {
    return wrong("the header must be {'descr': ..., 'fortran_order': ..., 'shape': (rows, columns)} at " +
                 shown(rest_));
  }

  void skip_blanks() {
    while (!rest_.empty() && (is_blank(rest_.front()) || rest_.front() == '\n')) rest_.remove_prefix(1);
  }
  /// Takes a word if it is the next one.
  bool take(std::string_view word) {
    skip_blanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  std::optional<std::string_view> take_quoted() {
    if (!take("'")) return std::nullopt;
    const std::size_t end = rest_.find('\'');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return text;
  }

  Result<void> read_dictionary() {
    if (!take("{")) return malformed();
    bool seen[3] = {};
    while (!take("}")) {
      const auto key = take_quoted();
      if (!key || !take(":")) return malformed();
      const int which = *key == "descr" ? 0 : *key == "fortran_order" ? 1 : *key == "shape" ? 2 : 3;
      if (which == 3 || seen[which]) return malformed();
      seen[which] = true;
      Result<void> read = which == 0 ? read_type() : which == 1 ? read_order() : read_shape();
      if (!read) return read;
      if (!take(",") && !rest_.starts_with('}')) return malformed();
    }
    skip_blanks();
    return seen[0] && seen[1] && seen[2] && rest_.empty() ? Result<void>{} : malformed();
  }

  Result<void> read_type() {
    const auto type = take_quoted();
    if (!type && rest_.starts_with('[')) return wrong("the array holds records; " + save_as());
    if (!type) return malformed();
    const std::size_t size = type->size() == 3 ? static_cast<std::size_t>((*type)[2] - '0') : 0;
    const char order = type->empty() ? '\0' : (*type)[0], kind = type->size() == 3 ? (*type)[1] : '\0';
    const bool whole = (kind == 'i' || kind == 'u') && (size == 1 || size == 2 || size == 4 || size == 8);
    const bool ordered = order == '<' || order == '>' || (order == '|' && size == 1);
    if (!ordered || (!whole && !(kind == 'b' && size == 1)))
      return wrong("the array is of type " + shown(*type) + "; " + save_as());
    header_.order = order;
    header_.kind = kind;
    header_.size = size;
    return {};
  }

  static std::string save_as() {
    return "booleans and whole numbers are read: save array.astype(int), or array > 0.5";
  }

  Result<void> read_order() {
    header_.fortran_order = take("True");
    return header_.fortran_order || take("False") ? Result<void>{} : malformed();
  }

  Result<void> read_shape() {
    if (!take("(")) return malformed();
    std::vector<std::int64_t> sides;
    while (!take(")")) {
      const std::size_t length = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
      const auto side = number_from<std::int64_t>(rest_.substr(0, length));
      if (length == 0 || sides.size() > 32) return malformed();
      sides.push_back(side.value_or(INT64_MAX));
      rest_.remove_prefix(length);
      if (!take(",") && !rest_.starts_with(')')) return malformed();
    }
    if (sides.size() != 2)
      return wrong("the array has " + std::to_string(sides.size()) +
                   (sides.size() == 1 ? " dimension" : " dimensions") +
                   ", a map has 2: save one plane of it");
    header_.rows = sides[0];
    header_.columns = sides[1];
    if (sides[0] == 0 || sides[1] == 0) return wrong("the array has no cells");
    if (sides[0] <= kMaxCells / sides[1]) return {};
    return wrong("the map is too large: at most " + std::to_string(kMaxCells) +
                 " cells (8192 x 8192) are read");
  }

  std::string_view bytes_;
  const std::string& origin_;
  std::string_view rest_;    // of the header
  std::string_view values_;  // behind the header
  NpyHeader header_;
};

}  // namespace

Result<MapFile> parse_npy_map(std::string_view bytes, const std::string& origin,
                              std::optional<double> occupied) {
  return NpyParser(bytes, origin).parse(occupied);
}

Result<MapFile> read_npy_map(const std::string& path, std::optional<double> occupied) {
  const Result<std::string> bytes = read_file(path, kMaxNpyBytes);
  if (!bytes) return Error{bytes.error()};
  return parse_npy_map(*bytes, path, occupied);
}

}  // namespace replan
