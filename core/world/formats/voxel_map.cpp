#include "core/world/formats/voxel_map.hpp"

#include <span>

#include "core/base/file.hpp"
#include "core/world/formats/scen_lines.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan {
namespace {

/// Reads the words of one line as whole numbers from 0; false if there are others, or more or fewer.
bool read_numbers(std::string_view line, std::span<int* const> numbers) {
  for (int* const number : numbers) {
    const auto value = number_from<int>(take_word(line));
    if (!value || *value < 0) return false;
    *number = *value;
  }
  return take_word(line).empty();
}

class VoxelMapParser {
 public:
  VoxelMapParser(std::string_view text, const std::string& origin) : lines_(text), origin_(origin) {}

  Result<GridMap> parse() {
    std::string_view header = lines_.next().value_or("");
    int width = 0, height = 0, depth = 0;
    int* const sides[] = {&width, &height, &depth};
    if (take_word(header) != "voxel" || !read_numbers(header, sides) || width == 0 || height == 0 ||
        depth == 0)
      return wrong("not a voxel map: the first line must be 'voxel X Y Z', three whole numbers from 1");
    if (height > kMaxVoxels / width || depth > kMaxVoxels / (std::int64_t{width} * height))
      return wrong("the map is too large: at most " + std::to_string(kMaxVoxels) + " voxels are read");
    GridMap map(width, height, depth);
    while (const auto line = lines_.next()) {
      if (line->empty()) continue;
      Voxel voxel;
      int* const parts[] = {&voxel.x, &voxel.y, &voxel.z};
      if (!read_numbers(*line, parts))
        return wrong("a line must be three whole numbers from 0, x y z, not " + shown(*line));
      if (!map.contains(voxel))
        return wrong("voxel " + shown(*line) + " lies outside the box of " + std::to_string(width) + " x " +
                     std::to_string(height) + " x " + std::to_string(depth));
      map.blocked[map.index(voxel)] = kObstacle;
    }
    return map;
  }

 private:
  Error wrong(const std::string& what) const {
    return {origin_ + ":" + std::to_string(lines_.number()) + ": " + what};
  }

  LineReader lines_;
  const std::string& origin_;
};

class VoxelScenParser {
 public:
  VoxelScenParser(std::string_view text, const std::string& origin) : lines_(text, origin) {
    scen_.path = origin;
    scen_.solid = true;
  }

  Result<ScenFile> parse() {
    if (auto version = lines_.read_version("3D scenario"); !version) return Error{version.error()};
    scen_.map_name = lines_.next_line().value_or("");
    if (scen_.map_name.empty()) return lines_.wrong("the second line must name the map");
    while (auto fields = lines_.next_problem())
      if (Result<void> problem = read_problem(*fields); !problem) return Error{problem.error()};
    scen_.lengths = LengthFormat::of(scen_.problems);
    return std::move(scen_);
  }

 private:
  Result<void> read_problem(ScenFields& fields) {
    ScenProblem problem;
    problem.line = lines_.number();
    Voxel &start = problem.start, &goal = problem.goal;
    int* const numbers[] = {&start.x, &start.y, &start.z, &goal.x, &goal.y, &goal.z};
    constexpr const char* kNames[] = {"start x", "start y", "start z", "goal x", "goal y", "goal z"};
    for (std::size_t i = 0; i < std::size(numbers); ++i)
      if (auto read = lines_.read_whole(fields, kNames[i], *numbers[i]); !read) return read;
    double ratio = 0;
    if (auto read = lines_.read_length(fields, "optimal length", problem.length, problem.printed); !read)
      return read;
    if (auto read = lines_.read_length(fields, "ratio of lengths", ratio, problem.printed_ratio); !read)
      return read;
    if (auto end = lines_.check_end(fields, 8); !end) return end;
    scen_.problems.push_back(std::move(problem));
    return {};
  }

  ScenLines lines_;
  ScenFile scen_;
};

std::string voxel_text(Voxel v) {
  return std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z);
}

}  // namespace

Result<GridMap> parse_voxel_map(std::string_view text, const std::string& origin) {
  return VoxelMapParser(text, origin).parse();
}

Result<GridMap> read_voxel_map(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return Error{text.error()};
  return parse_voxel_map(*text, path);
}

std::string voxel_map_text(const GridMap& map) {
  std::string text = "voxel " + voxel_text({map.width, map.height, map.depth}) + "\n";
  for (int x = 0; x < map.width; ++x)
    for (int y = 0; y < map.height; ++y)
      for (int z = 0; z < map.depth; ++z)
        if (map.at({x, y, z})) text += voxel_text({x, y, z}) + "\n";
  return text;
}

Result<void> write_voxel_map(const GridMap& map, const std::string& path) {
  return write_file_atomically(path, voxel_map_text(map));
}

Result<GridMap> voxel_slice(const GridMap& map, int z) {
  if (z < 0 || z >= map.depth)
    return Error{"there is no slice " + std::to_string(z) + ": z goes from 0 to " +
                 std::to_string(map.depth - 1)};
  GridMap slice(map.width, map.height);
  const auto from = map.blocked.begin() + static_cast<std::ptrdiff_t>(map.index({0, 0, z}));
  slice.blocked = std::vector<std::uint8_t>(from, from + static_cast<std::ptrdiff_t>(slice.blocked.size()));
  return slice;
}

Result<ScenFile> parse_voxel_scen(std::string_view text, const std::string& origin) {
  return VoxelScenParser(text, origin).parse();
}

}  // namespace replan
