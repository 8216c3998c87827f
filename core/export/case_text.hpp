// A moment of a run as text, for a bug report or a test: what it looks like, for people, and the scenario
// with the position, for the program, which goes back there when the text is pasted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/debug/log_view.hpp"
#include "core/world/formats/ascii_map.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// How the first line begins, and the two that are for the program.
inline constexpr std::string_view kCaseTitle = "Replan case 1";
inline constexpr std::string_view kCaseAt = "at ", kCaseScenario = "scenario ";

/// Which part of a moment is looked at.
struct CaseFocus {
  std::size_t pane = 0;                ///< which of the scenario's planners the log is of
  std::optional<Cell> pin = {};        ///< whose surroundings are listed; else the robot's
  std::optional<CellBox> region = {};  ///< whose cells are listed instead
};

/// A moment's text, but for what takes long in a large world: the hash of its state and the scenario, which
/// complete() adds.
struct CaseDraft {
  std::string words;  ///< for people
  std::size_t pane = 0, event = 0;
};
/// The world's letters, the run's values, those of the cells in focus and of the first of the open list at
/// the log's cursor. Of a world of more than 200 x 200 cells the letters are those around the focus alone, of one of
/// many layers those of the layer in focus. `scenario` is the one that the log is a run of.
CaseDraft draft_case(const Scenario& scenario, const LogView& view, const CaseFocus& focus);
/// The scenario as it stands in such a text, whole and on one line.
std::string case_scenario(const Scenario& scenario);
/// The text as a whole. `state` is SearchState::hash() at the moment.
std::string complete(const CaseDraft& draft, std::uint64_t state, const std::string& scenario);
/// All of it at once.
std::string case_text(const Scenario& scenario, const LogView& view, const CaseFocus& focus);

/// What a text leads back to.
struct CaseMoment {
  Scenario scenario;
  std::size_t pane = 0;
  std::size_t event = 0;    ///< position in the log of that pane's run
  std::uint64_t state = 0;  ///< SearchState::hash() there
};

/// Whether it is such a text, or what is left of one.
bool is_case_text(std::string_view text);
/// Reads the two lines that are for the program; blanks and `>` before a line, as mail puts them, are passed
/// over. `origin` names the text in errors.
Result<CaseMoment> parse_case_text(std::string_view text, const std::string& origin);

}  // namespace replan
