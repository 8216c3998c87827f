// Tables of figures as text: Markdown and LaTeX; CSV and JSON are those of the runs.
#include <algorithm>

#include "core/study/figures_table.hpp"

namespace replan {
namespace {

/// Puts a backslash before each of `special`.
std::string escaped(std::string_view text, std::string_view special) {
  std::string result;
  for (const char each : text) {
    if (special.find(each) != std::string_view::npos) result += '\\';
    result += each;
  }
  return result;
}

std::string latex_escaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char each = text[i];
    if (text.substr(i).starts_with("°")) {
      result += "$^\\circ$";
      i += std::string_view("°").size() - 1;
    } else if (each == '\\' || each == '~' || each == '^') {
      result += each == '\\'  ? "\\textbackslash{}"
                : each == '~' ? "\\textasciitilde{}"
                              : "\\textasciicircum{}";
    } else {
      result += escaped(std::string_view(&each, 1), "&%$#_{}");
    }
  }
  return result;
}

/// "length (cells)"; the run's sums are told from those of the latest plan.
std::string row_name(const FigureRow& row) {
  std::string name(row.info->label);
  if (row.info->group == FigureGroup::latest_plan) name += ", latest plan";
  if (!row.unit.empty()) name += " (" + std::string(row.unit) + ")";
  return name;
}

/// Characters as they stand side by side: bytes that go on a UTF-8 character take no place.
std::size_t shown_width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, shown_width(text)), ' ');
  return right ? space + text : text + space;
}

std::string markdown_cell(const FigureRow& row, std::size_t run) {
  std::string text = figure_text(*row.info, row.values[run]);
  if (row.best(run)) text = "**" + text + "**";
  if (const auto ratio = row.ratio(run)) text += " (" + ratio_text(*ratio) + ")";
  return text;
}

std::string markdown(const FiguresTable& table) {
  std::vector<std::vector<std::string>> lines(1, {"figure"});
  for (const std::string& name : table.names) lines.front().push_back(escaped(name, "\\`*_|<"));
  for (const FigureRow& row : table.rows) {
    lines.push_back({row_name(row)});
    for (std::size_t i = 0; i < table.names.size(); ++i) lines.back().push_back(markdown_cell(row, i));
  }
  std::vector<std::size_t> widths(table.names.size() + 1, 4);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], shown_width(line[i]));
  std::string text;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    for (std::size_t i = 0; i < widths.size(); ++i)
      text += "| " + padded(lines[l][i], widths[i], i > 0) + " ";
    text += "|\n";
    if (l > 0) continue;
    for (std::size_t i = 0; i < widths.size(); ++i)
      text += "|" + std::string(widths[i] + 1, '-') + (i > 0 ? ":" : "-");
    text += "|\n";
  }
  return text;
}

std::string latex_cell(const FigureRow& row, std::size_t run) {
  if (!row.values[run]) return "--";
  std::string text = figure_text(*row.info, row.values[run]);
  if (row.best(run)) text = "\\textbf{" + text + "}";
  if (const auto ratio = row.ratio(run))
    text += " {\\footnotesize($\\times$" + ratio_text(*ratio).substr(std::string_view("×").size()) + ")}";
  return text;
}

std::string latex(const FiguresTable& table) {
  std::string text = "% needs \\usepackage{booktabs}\n\\begin{tabular}{l" +
                     std::string(table.names.size(), 'r') + "}\n\\toprule\nFigure";
  for (const std::string& name : table.names) text += " & " + latex_escaped(name);
  text += " \\\\\n";
  std::optional<FigureGroup> group;
  for (const FigureRow& row : table.rows) {
    if (group != row.info->group) text += "\\midrule\n";
    group = row.info->group;
    text += latex_escaped(row_name(row));
    for (std::size_t i = 0; i < table.names.size(); ++i) text += " & " + latex_cell(row, i);
    text += " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace

std::span<const FiguresFormatInfo> figures_formats() {
  static constexpr FiguresFormatInfo kFormats[] = {{FiguresFormat::csv, "CSV", ".csv"},
                                                   {FiguresFormat::json, "JSON", ".json"},
                                                   {FiguresFormat::markdown, "Markdown", ".md"},
                                                   {FiguresFormat::latex, "LaTeX", ".tex"}};
  return kFormats;
}

std::string figures_text(FiguresFormat format, std::span<const RunReport> reports) {
  switch (format) {
    case FiguresFormat::csv:
      return runs_csv(reports);
    case FiguresFormat::json:
      return runs_json(reports);
    case FiguresFormat::markdown:
      return markdown(figures_table(reports));
    case FiguresFormat::latex:
      return latex(figures_table(reports));
  }
  return {};
}

}  // namespace replan
