#include "core/world/formats/esri_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/file.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

std::string lower_case(std::string_view word) {
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

class EsriGridParser {
 public:
  EsriGridParser(std::string_view text, const std::string& origin) : lines_(text), origin_(origin) {}

  Result<HeightGrid> parse() {
    if (auto read = read_header(); !read) return Error{read.error()};
    if (auto checked = check_header(); !checked) return Error{checked.error()};
    const auto count = static_cast<std::size_t>(*columns()) * static_cast<std::size_t>(*rows());
    HeightGrid grid{static_cast<int>(*columns()), static_cast<int>(*rows()), {}, {}};
    // Two bytes a number at least: what is not there needs no memory.
    grid.heights.reserve(std::min(count, lines_.left() / 2 + 2));
    for (std::optional<std::string_view> line = rest_; line; line = lines_.next())
      if (auto read = read_heights(*line, count, grid.heights); !read) return Error{read.error()};
    if (grid.heights.size() < count)
      return wrong("the file ends after " + std::to_string(grid.heights.size()) + " of " +
                   std::to_string(count) + " heights");
    grid.notes.push_back(place_note());
    return grid;
  }

 private:
  static constexpr double kUsualNoData = -9999;  // of a header that does not say

  /// The lines of a header, in the order in which kNames has them.
  enum Field : std::uint8_t { ncols, nrows, xll, yll, cellsize, dx, dy, nodata, kFields };

  Error wrong(const std::string& what) const {
    return {origin_ + ":" + std::to_string(std::max(1, lines_.number())) + ": " + what};
  }

  static std::optional<Field> field_of(std::string_view word) {
    static constexpr std::array<std::pair<std::string_view, Field>, 10> kNames = {{{"ncols", ncols},
                                                                                   {"nrows", nrows},
                                                                                   {"xllcorner", xll},
                                                                                   {"xllcenter", xll},
                                                                                   {"yllcorner", yll},
                                                                                   {"yllcenter", yll},
                                                                                   {"cellsize", cellsize},
                                                                                   {"dx", dx},
                                                                                   {"dy", dy},
                                                                                   {"nodata_value", nodata}}};
    const std::string name = lower_case(word);
    const auto found =
        std::find_if(kNames.begin(), kNames.end(), [&](const auto& each) { return each.first == name; });
    return found == kNames.end() ? std::nullopt : std::optional(found->second);
  }

  /// Reads header lines up to the first line that begins with a number, which is left in `rest_`.
  Result<void> read_header() {
    while (const auto line = lines_.next()) {
      std::string_view words = *line;
      const std::string_view name = take_word(words);
      if (name.empty()) continue;
      if (number_from<double>(name)) {
        rest_ = *line;
        return {};
      }
      const auto field = field_of(name);
      if (!field)
        return wrong(
            "not a grid of heights: a line of the header must be ncols, nrows, xllcorner, yllcorner, "
            "cellsize "
            "or NODATA_value and a number, not " +
            shown(*line));
      if (fields_[*field]) return wrong(shown(name) + " stands there twice");
      centre_[*field] = lower_case(name).ends_with("center");
      const std::string_view value = take_word(words);
      fields_[*field] = number_from<double>(value);
      if (!fields_[*field] || !can_be(*field, *fields_[*field]) || !take_word(words).empty())
        return wrong("after " + shown(name) + " there must be one number");
    }
    return {};
  }

  static bool can_be(Field field, double value) {
    return std::isfinite(value) || (field == nodata && std::isnan(value));
  }

  [[nodiscard]] std::optional<double> columns() const { return fields_[ncols]; }
  [[nodiscard]] std::optional<double> rows() const { return fields_[nrows]; }

  Result<void> check_header() const {
    for (const auto& [name, side] : {std::pair{"ncols", columns()}, std::pair{"nrows", rows()}}) {
      if (!side) return wrong(std::string("not a grid of heights: the header has no ") + name);
      if (*side < 1 || *side != std::floor(*side) || *side > static_cast<double>(kMaxCells))
        return wrong(std::string(name) + " must be a whole number from 1 to " + std::to_string(kMaxCells));
    }
    if (*columns() * *rows() > static_cast<double>(kMaxCells))
      return wrong("the grid is too large: at most " + std::to_string(kMaxCells) + " heights are read");
    return {};
  }

  Result<void> read_heights(std::string_view line, std::size_t count, std::vector<float>& heights) const {
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      if (heights.size() == count)
        return wrong("there are more than the " + std::to_string(count) +
                     " heights that ncols and nrows announce");
      const auto height = number_from<double>(word);
      const bool none = height && (std::isnan(*height) || *height == fields_[nodata].value_or(kUsualNoData));
      if (!height || (!none && !(std::abs(*height) <= kMaxHeight)))
        return wrong("a height must be a number from -1000000000 to 1000000000, not " + shown(word));
      heights.push_back(none ? HeightGrid::kNoHeight : static_cast<float>(*height));
    }
    return {};
  }

  /// Where the south-west cell begins along one axis: half a cell before its middle, where the header tells that.
  [[nodiscard]] std::optional<double> corner(Field field, std::optional<double> side) const {
    if (!fields_[field] || !centre_[field]) return fields_[field];
    return side ? std::optional(*fields_[field] - *side / 2) : std::nullopt;
  }

  /// The grid does not say whether it is in degrees or in metres, so its place is none of the world's.
  [[nodiscard]] std::string place_note() const {
    const auto number = [&](std::optional<double> value) {
      return value ? plain_number(*value).dump() : std::string("nothing");
    };
    const std::optional<double> width = fields_[cellsize] ? fields_[cellsize] : fields_[dx],
                                height = fields_[cellsize] ? fields_[cellsize] : fields_[dy];
    return "where the grid lies (its south-west corner at " + number(corner(xll, width)) + ", " +
           number(corner(yll, height)) + ") and how large its cells are (" + number(width) + " x " +
           number(height) + ") is not kept, since it does not say in which unit";
  }

  LineReader lines_;
  const std::string& origin_;
  std::array<std::optional<double>, kFields> fields_;
  std::array<bool, kFields> centre_{};  // told of the south-west cell's middle, not of its corner
  std::string_view rest_;               // the first line of heights
};

}  // namespace

Result<HeightGrid> parse_esri_grid(std::string_view text, const std::string& origin) {
  return EsriGridParser(text, origin).parse();
}

Result<MapFile> read_esri_grid(const std::string& path, const HeightReading& reading) {
  const Result<std::string> text = read_file(path);
  if (!text) return Error{text.error()};
  Result<HeightGrid> grid = parse_esri_grid(*text, path);
  if (!grid) return Error{grid.error()};
  return world_over(std::move(*grid), reading, path);
}

}  // namespace replan
