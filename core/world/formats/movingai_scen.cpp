#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/file.hpp"
#include "core/base/words.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/formats/scen_lines.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/formats/voxel_map.hpp"

namespace replan {
namespace {

/// Digits of a printed number: after the point, and significant ones (leading zeros not counted).
struct PrintedDigits {
  int decimals = 0;
  int significant = 0;
  bool exponent = false;
};

PrintedDigits printed_digits(std::string_view text) {
  PrintedDigits result;
  bool point = false;
  for (const char c : text) {
    if (c == '.') point = true;
    if (c == 'e' || c == 'E') {
      result.exponent = true;
      break;
    }
    if (c < '0' || c > '9') continue;
    result.decimals += point ? 1 : 0;
    result.significant += c != '0' || result.significant > 0 ? 1 : 0;
  }
  return result;
}

/// Reads one `.scen` text.
class ScenParser {
 public:
  ScenParser(std::string_view text, const std::string& origin) : lines_(text, origin) { scen_.path = origin; }

  Result<ScenFile> parse() {
    if (auto version = lines_.read_version("MovingAI scenario"); !version) return Error{version.error()};
    while (auto fields = lines_.next_problem())
      if (Result<void> problem = read_problem(*fields); !problem) return Error{problem.error()};
    scen_.lengths = LengthFormat::of(scen_.problems);
    return std::move(scen_);
  }

 private:
  Result<void> read_problem(ScenFields& fields) {
    ScenProblem problem;
    problem.line = lines_.number();
    const auto bucket = number_from<int>(fields.next());
    if (!bucket || *bucket < 0)
      return lines_.wrong("the first field, the bucket, must be a whole number from 0");
    problem.bucket = *bucket;
    if (Result<void> name = read_name(fields.next()); !name) return name;
    int* const numbers[] = {&problem.width,   &problem.height, &problem.start.x,
                            &problem.start.y, &problem.goal.x, &problem.goal.y};
    constexpr const char* kNames[] = {"map width", "map height", "start x", "start y", "goal x", "goal y"};
    for (std::size_t i = 0; i < std::size(numbers); ++i)
      if (auto read = lines_.read_whole(fields, kNames[i], *numbers[i]); !read) return read;
    if (auto read = lines_.read_length(fields, "optimal length", problem.length, problem.printed); !read)
      return read;
    if (auto end = lines_.check_end(fields, 9); !end) return end;
    scen_.problems.push_back(std::move(problem));
    return {};
  }

  Result<void> read_name(std::string_view name) {
    if (name.empty()) return lines_.wrong("the line ends before its 9 fields");
    if (scen_.map_name.empty()) scen_.map_name = name;
    if (name == scen_.map_name) return {};
    return lines_.wrong("the line is for map " + shown(name) + ", the ones before it for " +
                        shown(scen_.map_name) + ": one file must be for one map");
  }

  ScenLines lines_;
  ScenFile scen_;
};

std::string plane_line(const ScenProblem& problem, const std::string& map_name) {
  std::string line = std::to_string(problem.bucket) + "\t" + map_name + "\t";
  for (const int number :
       {problem.width, problem.height, problem.start.x, problem.start.y, problem.goal.x, problem.goal.y})
    line += std::to_string(number) + "\t";
  return line + problem.printed + "\n";
}

std::string solid_line(const ScenProblem& problem) {
  std::string line;
  for (const Cell end : {problem.start, problem.goal})
    for (const int number : {end.x, end.y, end.z}) line += std::to_string(number) + " ";
  return line + problem.printed + " " + problem.printed_ratio + "\n";
}

/// Whether a problem's size is the map's, if it has one, and its ends lie on it.
Result<void> check_fits(const ScenProblem& problem, bool solid, const GridMap& map,
                        const std::string& map_path) {
  if (!solid && (problem.width != map.width || problem.height != map.height))
    return Error{"is for a map of " + std::to_string(problem.width) + " x " + std::to_string(problem.height) +
                 " cells, '" + map_path + "' has " + std::to_string(map.width) + " x " +
                 std::to_string(map.height) + ": give the right map with --map"};
  for (const Cell end : {problem.start, problem.goal}) {
    if (map.contains(end)) continue;
    if (!solid) return Error{cell_text(end) + " is outside the map"};
    return Error{cell_text(end, true) + " lies outside the box of '" + map_path +
                 "': give the right map with --map"};
  }
  return {};
}

}  // namespace

LengthFormat LengthFormat::of(std::span<const ScenProblem> problems) {
  std::vector<std::string_view> printed;
  printed.reserve(problems.size());
  for (const ScenProblem& problem : problems) printed.push_back(problem.printed);
  return of(std::span<const std::string_view>(printed));
}

LengthFormat LengthFormat::of(std::span<const std::string_view> printed) {
  LengthFormat format;
  if (printed.empty()) return format;
  const int decimals = printed_digits(printed.front()).decimals;
  format.fixed = decimals > 0;
  for (const std::string_view text : printed) {
    const PrintedDigits digits = printed_digits(text);
    format.fixed &= digits.decimals == decimals && !digits.exponent;
    format.digits = std::max(format.digits, digits.significant);
  }
  if (format.fixed) format.digits = decimals;
  return format;
}

double LengthFormat::tolerance(double value) const {
  // Relative errors of the roots of two in use; a length is diagonals at worst.
  constexpr double kNineDecimals = 2.7e-10, kSinglePrecision = 1.75e-8;
  // The place of the first digit; a length of 0 is printed exactly by streams, so any unit below a cell's
  // will do.
  const int first = value > 0 ? static_cast<int>(std::floor(std::log10(value))) : 0;
  const double half_unit = 0.5 * std::pow(10.0, fixed ? -digits : first + 1 - digits);
  // A thousandth more for the rounding of the sums, the file's and ours.
  return 1.001 * half_unit + value * (fixed ? kNineDecimals : kSinglePrecision);
}

bool LengthFormat::agrees(double found, std::string_view printed) const {
  const auto value = number_from<double>(printed);
  return value && std::isfinite(found) && std::abs(found - *value) <= tolerance(*value);
}

Result<ScenFile> parse_scen(std::string_view text, const std::string& origin) {
  return ScenParser(text, origin).parse();
}

Result<ScenFile> read_scen(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return Error{text.error()};
  return file_extension(path) == ".3dscen" ? parse_voxel_scen(*text, path) : parse_scen(*text, path);
}

std::string scen_text(const ScenFile& scen) {
  std::string text = scen.solid ? "version 1\n" + scen.map_name + "\n" : "version 1\n";
  for (const ScenProblem& problem : scen.problems)
    text += scen.solid ? solid_line(problem) : plane_line(problem, scen.map_name);
  return text;
}

Result<std::string> map_beside(const std::string& scen_path, const std::string& map_name) {
  const std::string name = file_name(map_name);
  if (name.empty()) return Error{scen_path + ": names no map: give one with --map"};
  const std::string found = (std::filesystem::path(file_folder(scen_path)) / name).string();
  std::error_code failed;
  if (std::filesystem::is_regular_file(found, failed)) return found;
  return Error{scen_path + ": its map '" + name + "' is not in '" + file_folder(scen_path) +
               "': put it there or give one with --map"};
}

Result<void> check_scen_fits(const ScenFile& scen, const GridMap& map, const std::string& map_path) {
  for (const ScenProblem& problem : scen.problems)
    if (const auto fits = check_fits(problem, scen.solid, map, map_path); !fits)
      return Error{scen.path + ":" + std::to_string(problem.line) + ": " + fits.error()};
  return {};
}

}  // namespace replan
