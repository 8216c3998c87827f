// The planners' pages: idea, pseudo-code, settings, limits and source of each, in assets/planners/ID.md.
//
// A page is plain Markdown. The first heading is the name; each "## " heading begins a section; a fenced
// block whose language is `pseudo` is pseudo-code. A line of it is "NUMBER: text"; a line without a number
// goes on the one before.
//
//   ```pseudo 100 Algorithm 1: main          its lines are 101, 102 and so on, in the log and wherever they show
//   ```pseudo 0 Algorithm 2: helper functions
//
// A page whose planner has the same code as another uses that one's:
//
//   <!-- pseudo: astar -->
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace replan {

struct PseudoLine {
  int number =
      0;  ///< as events hold it (Event::line): no two of a page are equal; 0: goes on the line before
  std::string text;  ///< with its indentation
};

struct PseudoBlock {
  std::string title;
  std::vector<PseudoLine> lines;
};

struct PageSection {
  std::string title;  ///< "Idea", "Settings", "Limits", "Source"
  std::vector<std::string>
      paragraphs;  ///< with the marks of core/base/markdown.hpp; list items begin with "• "
};

struct PlannerPage {
  std::string title;
  std::vector<PageSection> sections;
  std::vector<PseudoBlock> code;

  /// The section of that title, or nullptr.
  [[nodiscard]] const PageSection* section(std::string_view name) const;
  /// The line with that recorded number, or nullptr.
  [[nodiscard]] const PseudoLine* line(int number) const;
  /// The block that holds the line, or nullptr.
  [[nodiscard]] const PseudoBlock* block_of(int number) const;
};

/// The folder of pages and schemas: REPLAN_ASSETS, else that of the source tree that the
/// program was built from, else ../share/replan/assets beside the program; empty if there is none.
std::string assets_folder();
/// The page of a planner. The error says where it was looked for.
Result<PlannerPage> read_page(std::string_view planner);
/// The same, and behind its pseudo-code that of another planner, which plans for it.
Result<PlannerPage> read_page(std::string_view pilot, std::string_view planner);
/// As read_page() from text; pages that it refers to are looked for in `folder`. `origin` names it in errors.
Result<PlannerPage> parse_page(std::string_view text, const std::string& origin, const std::string& folder);

}  // namespace replan
