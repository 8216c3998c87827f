// Planners side by side: the figures of several runs as a table, with ratios and the best of each row, and as
// text for papers and programs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/study/run_report.hpp"

namespace replan {

/// Which of two values of a figure is to be preferred, if that can be said at all.
enum class Better : std::uint8_t { neither, lower, higher };

/// What a figure is about.
enum class FigureGroup : std::uint8_t { first_plan, latest_plan, run, robot };
/// "The first plan", ...
const char* figure_group_title(FigureGroup group);

/// A figure as users read it.
struct FigureInfo {
  std::string_view key;  ///< as in NamedFigure
  FigureGroup group;
  std::string_view label;
  std::string_view unit;  ///< may be empty
  Better better;
  int decimals;            ///< 0: a count
  bool wall_time;          ///< differs from run to run and from machine to machine
  std::string_view teach;  ///< a sentence or two
};

/// One figure of all runs.
struct FigureRow {
  const FigureInfo* info = nullptr;
  std::string_view unit = {};  ///< the figure's own; "m" for lengths where all runs are on metric maps
  std::vector<std::optional<double>>
      values;  ///< by run, in that unit; nothing where the run has no such figure
  /// By run: whether its value can be held against those of the others that can. First plans lead from one start to one
  /// goal on one map. Work and ways can be compared as long as all have no more than their first plans, and once all
  /// have come to their end; in between the robots stand in different places. Drives on wheels and from cell to cell are
  /// not compared. A run that failed competes for nothing.
  std::vector<bool> competes;

  /// The value over the first run's; nothing for the first, or if one of the two is missing or divides by 0.
  [[nodiscard]] std::optional<double> ratio(std::size_t run) const;
  /// Whether no run that it can be compared with has a better value, as they are printed: so what reads alike is
  /// marked alike. False for all where all are equal, or nothing is better.
  [[nodiscard]] bool best(std::size_t run) const;
};

struct FiguresTable {
  std::vector<std::string> names;  ///< of the planners, by run; numbered where one is there twice
  std::vector<FigureRow> rows;     ///< in the order of their groups; without those that no run has
};
FiguresTable figures_table(std::span<const RunReport> reports);

/// The value as digits ("1284", "61.413"); an en dash for nothing.
std::string figure_text(const FigureInfo& info, std::optional<double> value);
/// "×1.08".
std::string ratio_text(double ratio);

enum class FiguresFormat : std::uint8_t { csv, json, markdown, latex };
/// The formats in the order of the enumeration: name and extension (".md").
struct FiguresFormatInfo {
  FiguresFormat format;
  const char* name;
  const char* extension;
};
std::span<const FiguresFormatInfo> figures_formats();
/// The whole text: a line (CSV) or an object (JSON) for each run; or a table (Markdown, LaTeX with booktabs)
/// with a column for each run, ratios to the first, and the best in bold.
std::string figures_text(FiguresFormat format, std::span<const RunReport> reports);

}  // namespace replan
