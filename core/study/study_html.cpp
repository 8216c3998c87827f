#include "core/study/study_html.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/base64.hpp"
#include "core/study/study_tables.hpp"
#include "core/study/study_words.hpp"

namespace replan {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1b2430; --quiet: #5b6675; --line: #d9dee5; --paper: #ffffff; --soft: #f4f6f8;
  --good: #00694a; --partly: #8a5a00; --bad: #a3182f; --answered: #1c5f9e; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e8ee; --quiet: #9aa5b4; --line: #333c48; --paper: #151a21;
  --soft: #1d242d; --good: #4cc59a; --partly: #e0ad52; --bad: #f0849a; --answered: #7db8ef; } }
body { font: 16px/1.55 system-ui, "Helvetica Neue", Arial, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 1180px; margin: 0 auto; padding: 32px 24px 96px; }
h1 { font-size: 30px; margin: 0 0 8px; } h2 { font-size: 23px; margin: 64px 0 8px; border-top: 1px solid var(--line);
  padding-top: 32px; } h3 { font-size: 17px; margin: 32px 0 8px; }
p { max-width: 78ch; } .quiet { color: var(--quiet); } a { color: inherit; }
.scroll { overflow-x: auto; margin: 16px 0; }
table { border-collapse: collapse; font-size: 14px; } th, td { padding: 6px 12px 6px 0; vertical-align: top;
  border-bottom: 1px solid var(--line); } th { text-align: left; font-weight: 600; color: var(--quiet); }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
th.number { white-space: normal; vertical-align: bottom; } td.word { min-width: 9em; }
.claims td { max-width: 58ch; min-width: 0; line-height: 1.45; } .verdict { font-weight: 600; white-space: nowrap; }
.reproduced { color: var(--good); } .partly { color: var(--partly); } .not-reproduced { color: var(--bad); }
.answered { color: var(--answered); }
figure { margin: 24px 0; } figcaption { color: var(--quiet); font-size: 14px; max-width: 78ch; }
.row { display: flex; flex-wrap: wrap; gap: 16px; } .row div { flex: 1 1 240px; min-width: 0; }
.row.one div { flex: 0 1 640px; } .row img { width: 100%; background: #fff; border: 1px solid var(--line); }
.row span { display: block; font-size: 14px; font-weight: 600; margin-bottom: 4px; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(440px, 100%), 1fr)); gap: 8px 24px; }
@media (max-width: 720px) { body { padding: 20px 16px 64px; }
  table.claims, .claims tbody, .claims tr, .claims td { display: block; max-width: none; } .claims th { display: none; }
  .claims tr { border-bottom: 1px solid var(--line); padding: 8px 0; } .claims td { border: 0; padding: 4px 0; }
  .summary { font-size: 13px; } .summary td, .summary th { padding-right: 8px; } }
@media print { h2 { break-before: page; } body { max-width: none; padding: 0; } }
)";

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string element(std::string_view name, std::string_view text) {
  return filled("<{1}>{2}</{1}>\n", {std::string(name), escaped(text)});
}

/// "not reproduced" as a class.
std::string class_of(Verdict verdict) {
  std::string name = verdict_name(verdict);
  for (char& c : name)
    if (c == ' ') c = '-';
  return name;
}

std::string row_of(const std::vector<std::string>& cells, std::size_t words, const char* tag) {
  std::string row = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i)
    row += filled("<{1} class=\"{2}\">", {tag, i < words ? "word" : "number"}) + escaped(cells[i]) + "</" +
           tag + ">";
  return row + "</tr>\n";
}

std::string html_table(const StudyTable& table) {
  std::string text = table.heading.empty() ? "" : element("h3", table.heading);
  text += "<div class=\"scroll\"><table>\n" + row_of(table.lines.front(), table.words, "th");
  for (std::size_t i = 1; i < table.lines.size(); ++i) text += row_of(table.lines[i], table.words, "td");
  return text + "</table></div>\n";
}

std::string html_claims(const StudyReport& report) {
  if (report.claims.empty()) return {};
  std::string text =
      "<div class=\"scroll\"><table class=\"claims\">\n<tr><th>The paper "
      "says</th><th>Here</th><th>Verdict</th></tr>\n";
  for (const StudyClaim& claim : report.claims)
    text += "<tr><td>" + escaped(claim.paper) + "</td><td>" + escaped(claim.ours) +
            (claim.why.empty() ? "" : "<br><span class=\"quiet\">" + escaped(claim.why) + "</span>") +
            "</td><td class=\"verdict " + class_of(claim.verdict) + "\">" + verdict_name(claim.verdict) +
            "</td></tr>\n";
  return text + "</table></div>\n";
}

std::string image(const std::string& svg, const std::string& alt) {
  return "<img alt=\"" + escaped(alt) + "\" src=\"data:image/svg+xml;base64," + base64(svg) + "\">";
}

std::string html_drawing(const StudyDrawing& drawing) {
  std::string text =
      drawing.parts.size() == 1 ? "<figure><div class=\"row one\">" : "<figure><div class=\"row\">";
  for (const StudyDrawing::Part& part : drawing.parts)
    text += "<div>" + (part.title.empty() ? "" : "<span>" + escaped(part.title) + "</span>") +
            image(part.svg, part.title.empty() ? drawing.caption : part.title) + "</div>";
  return text + "</div><figcaption>" + escaped(drawing.caption) + "</figcaption></figure>\n";
}

/// The tables and headings of a text in Markdown; the rest of it as paragraphs.
std::string html_of_markdown(std::string_view markdown) {
  std::string text;
  StudyTable table;
  const auto end_table = [&] {
    if (!table.lines.empty()) text += html_table(std::exchange(table, {}));
  };
  while (!markdown.empty()) {
    const std::size_t end = std::min(markdown.find('\n'), markdown.size());
    std::string_view line = markdown.substr(0, end);
    markdown.remove_prefix(std::min(end + 1, markdown.size()));
    if (!line.starts_with('|')) end_table();
    if (line.starts_with("## ")) {
      text += element("h3", line.substr(3));
    } else if (line.starts_with("|")) {
      if (line.find("---") != line.npos) continue;
      std::vector<std::string>& cells = table.lines.emplace_back();
      for (line.remove_prefix(1); !line.empty();) {
        const std::size_t bar = std::min(line.find('|'), line.size());
        std::string_view cell = line.substr(0, bar);
        while (cell.starts_with(' ')) cell.remove_prefix(1);
        while (cell.ends_with(' ')) cell.remove_suffix(1);
        cells.emplace_back(cell);
        line.remove_prefix(std::min(bar + 1, line.size()));
      }
    } else if (!line.empty()) {
      text += element("p", line);
    }
  }
  end_table();
  return text;
}

std::string html_section(const StudySection& section) {
  const StudyInfo& info = *section.info;
  std::string text = "<section id=\"" + std::string(info.id) + "\">\n" + element("h2", info.title);
  text += "<p class=\"quiet\">" +
          escaped(filled("After {1}. {2}", {std::string(info.source), seeds_words(info, section.report)})) +
          "</p>\n";
  text += element("p", info.setting) + html_claims(section.report);
  std::string charts;
  for (const StudyDrawing& drawing : section.drawings)
    if (drawing.parts.size() == 1 && drawing.parts.front().title.empty())
      charts += html_drawing(drawing);
    else
      text += html_drawing(drawing);
  if (!charts.empty()) text += "<div class=\"charts\">\n" + charts + "</div>\n";
  for (const std::string& note : section.notes) text += element("p", note);
  for (const StudyTable& table : figure_tables(section.report)) text += html_table(table);
  text += "<p class=\"quiet\">" + escaped(table_words(section.report)) + "</p>\n";
  return text + html_of_markdown(section.report.supplement) + "</section>\n";
}

std::string html_summary(std::span<const StudySection> sections) {
  constexpr std::array kAll{Verdict::reproduced, Verdict::partly, Verdict::not_reproduced, Verdict::answered};
  std::string text = "<div class=\"scroll\"><table class=\"summary\">\n<tr><th>Study</th>";
  for (const Verdict verdict : kAll)
    text += "<th class=\"number\">" + std::string(verdict_name(verdict)) + "</th>";
  text += "</tr>\n";
  for (const StudySection& section : sections) {
    text += "<tr><td><a href=\"#" + std::string(section.info->id) + "\">" + escaped(section.info->title) +
            "</a></td>";
    for (const Verdict verdict : kAll) {
      std::size_t count = 0;
      for (const StudyClaim& claim : section.report.claims) count += claim.verdict == verdict ? 1 : 0;
      text += "<td class=\"number " + class_of(verdict) + "\">" + (count > 0 ? std::to_string(count) : "") +
              "</td>";
    }
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

}  // namespace

std::string study_html(std::span<const StudySection> sections) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>Studies of path planning and "
      "replanning</title>\n<style>" +
      std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>Studies of path planning and replanning</h1>\n";
  text += element("p",
                  "The experiments of the papers, run anew. Each claim of a paper has a verdict: reproduced; "
                  "partly, where it "
                  "holds in some of the worlds alone, or in direction and not in size; not reproduced; or "
                  "answered, where the "
                  "paper leaves a "
                  "question open. Where something has not come out, the reason stands beside it.");
  text += html_summary(sections);
  for (const StudySection& section : sections) text += html_section(section);
  return text + "</body>\n</html>\n";
}

}  // namespace replan
