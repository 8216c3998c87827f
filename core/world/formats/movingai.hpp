// The Moving AI Lab's benchmark formats: `.map` (a grid of letters) and `.scen` (problems with optimal
// lengths). N. R. Sturtevant, "Benchmarks for Grid-Based Pathfinding", 2012, doi 10.1109/TCIAIG.2012.2197681.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/world/grid_map.hpp"

namespace replan {

/// What a letter of a `.map` says of its cell.
enum class MapLetter : unsigned char { free, blocked, unknown };
/// `.` `G` `S` are free; `@` `O` `T` `W` are obstacles.
MapLetter map_letter(char letter);

/// Reads a `.map`. Taken as they come: a byte order mark, CR LF, trailing blanks, blank lines at the end, no
/// final newline, `height` and `width` in either order. An error names file, line (and column) and what is
/// wrong; a map of more than kMaxCells is refused before memory is taken for it.
Result<GridMap> read_movingai_map(const std::string& path);
/// As read_movingai_map() from text; `origin` names it in errors.
Result<GridMap> parse_movingai_map(std::string_view text, const std::string& origin);
/// The map as `.map` text: `.` free, `@` obstacle.
std::string movingai_map_text(const GridMap& map);
/// Writes a `.map` atomically.
Result<void> write_movingai_map(const GridMap& map, const std::string& path);

/// One problem of a `.scen` or `.3dscen` file.
struct ScenProblem {
  int line = 0;    ///< in the file, from 1
  int bucket = 0;  ///< `.scen` alone
  int width = 0;   ///< of the map that the problem is for; `.scen` alone
  int height = 0;
  Cell start;
  Cell goal;
  double length = 0;          ///< optimal length, in cells
  std::string printed;        ///< `length` as it stands in the file
  std::string printed_ratio;  ///< of the length to that of the empty box; `.3dscen` alone
};

/// How a file of problems prints its lengths, which decides how near a found length has to be.
///
/// Files in use print a fixed number of decimals (two or eight) or, as C++ streams do, six significant digits
/// with trailing zeros dropped ("62.15", "1"). One line cannot tell which; the file can: if all lengths have
/// the same number of decimals, at least one, they are fixed; otherwise significant digits.
///
/// The printed lengths are sums with a rounded root of two, as the files themselves show: the
/// single-precision one where six digits are printed (378.764 stands for 243 + 96 sqrt 2 =
/// 378.764502), 1.414213562 where eight decimals are (a length of 1500 cells is 4e-7 short). What these
/// roundings can add up to over the length is allowed for, no more.
struct LengthFormat {
  bool fixed = false;  ///< `digits` counts decimals; else significant digits
  int digits = 6;

  /// Finds the format out from all lengths of a file.
  static LengthFormat of(std::span<const std::string_view> printed);
  /// As above, of all problems of a file.
  static LengthFormat of(std::span<const ScenProblem> problems);
  /// How far the exact length may be from the printed `value`: half a unit of the last place, and the roots'
  /// error.
  [[nodiscard]] double tolerance(double value) const;
  /// True if `found`, printed in this format, is what the file prints (a length without a path, infinity, is
  /// not).
  [[nodiscard]] bool agrees(double found, std::string_view printed) const;
};

/// A `.scen` file, or a `.3dscen`.
struct ScenFile {
  std::string path;      ///< as opened; names the file in errors
  std::string map_name;  ///< as written in the file: often the author's path
  bool solid = false;    ///< a `.3dscen`
  std::vector<ScenProblem> problems;
  LengthFormat lengths;

  /// True if `found` is the problem's listed optimum to the precision printed in the file.
  [[nodiscard]] bool agrees(double found, const ScenProblem& problem) const {
    return lengths.agrees(found, problem.printed);
  }
};

/// Reads a `.scen` (version 1), or a `.3dscen` if that is how the name ends. A line with a tab is parted at
/// its tabs, so that the map's name may hold blanks; others at blanks. Errors name file, line and what is
/// wrong.
Result<ScenFile> read_scen(const std::string& path);
/// As read_scen() of a `.scen` from text; `origin` names it in errors.
Result<ScenFile> parse_scen(std::string_view text, const std::string& origin);
/// The problems as text of their format, numbers as they were printed.
std::string scen_text(const ScenFile& scen);
/// The map that a `.scen` or `.3dscen` names, looked for beside it by its file name. The error says where it
/// was looked for.
Result<std::string> map_beside(const std::string& scen_path, const std::string& map_name);
/// Checks that the problems are for this map: same size where that is told, start and goal on it. The error
/// names the line.
Result<void> check_scen_fits(const ScenFile& scen, const GridMap& map, const std::string& map_path);

}  // namespace replan
