// Lessons: a scenario and a few steps, each with a sentence or two, and with what the learner has to do. One file each
// in assets/lessons, in Markdown:
//
//   # First steps
//
//   What the lesson is about, in a sentence or two.
//
//   ```scenario
//   {"replan": 1, ...}
//   ```
//
//   ## The goal waits
//
//   Press **→**. Now rhs of the goal is 0, and its g is still ∞: they differ, so it *waits*.
//
//   - until: `rhs(5, 2) == 0 && queued(5, 2)`
//   - given: `Step`
//   - do: `step expansion 1`
//   - cell: `5, 2`
//
// A scenario that has a file of its own stands before the steps as `<!-- scenario: ../../maps/demo.json -->`, with its
// path from the lesson's folder. What a step asks for is at least one of two: `until`, a condition
// (core/debug/condition.hpp) that has to hold at the cursor of the leading run, and `given`, a command
// (core/session/commands.def) or an action of the window that the learner has to have given since the step began. `do`
// (deeds.hpp) does it for the learner; without one the cursor goes to where `until` comes true. `cell` is the cell that
// the step is about: a window pins it. `touches`, as in "3 of 36", is a claim that the words make: the latest repair has
// touched 3 cells, where a plan from scratch touches 36. Tests hold lessons to it. Lessons stand in the order of their
// files' names: 1-first-steps.md has the id "first-steps".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/debug/condition.hpp"
#include "core/lesson/deeds.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// How many cells the latest repair has touched, and how many a plan from scratch would.
struct TouchClaim {
  std::int64_t repair = 0, scratch = 0;
  friend bool operator==(const TouchClaim&, const TouchClaim&) = default;
};

struct LessonStep {
  std::string title;
  std::vector<std::string> paragraphs = {};  ///< with the marks of core/base/markdown.hpp
  std::optional<Condition> until = {};
  std::vector<std::string> given = {};
  std::vector<Deed> deeds = {};
  std::optional<Cell> cell = {};
  std::optional<TouchClaim> touches = {};  ///< once the step is done
};

struct Lesson {
  std::string id = {}, title = {};
  std::string summary = {};  ///< with marks too
  Scenario scenario = {};
  std::vector<LessonStep> steps = {};  ///< at least one
};

/// Where a lesson is.
struct LessonFile {
  std::string id;  ///< the file's name without its number and its ending
  std::string path;
};

/// The lessons of assets_folder(), in their order; none if there are none.
std::vector<LessonFile> lesson_files();
/// Reads a lesson. An error names the file, the line and the mend.
Result<Lesson> read_lesson(const LessonFile& file);
/// As read_lesson() by its id; the error for an unknown one suggests the nearest.
Result<Lesson> read_lesson(std::string_view id);
/// As read_lesson() from text; `origin` names it in errors, scenarios are looked for in `folder`.
Result<Lesson> parse_lesson(std::string_view text, const std::string& origin, const std::string& folder);

}  // namespace replan
