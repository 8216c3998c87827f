// The numbers that a point of a search has at a moment of its log, as its planner declares them: what can be plotted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/debug/log_view.hpp"
#include "core/debug/touch_order.hpp"

namespace replan {

struct Measure {
  enum class Source : std::uint8_t {
    event,     ///< when the search came to it first, by the log
    reached,   ///< the same, by expansions or samples
    value,     ///< what the log holds for it
    times,     ///< how often it was expanded
    second,    ///< the second part of its key while it waits in the open list
    to_start,  ///< in a straight line, cells
    to_goal,
    number  ///< its own, of a vertex
  };
  Source source{};
  Field field = {};                  ///< of Source::value
  std::string id;                    ///< in files: "to_goal"
  std::string label;                 ///< as in the window: "distance to the goal"
  std::string help;                  ///< a sentence that teaches
  [[nodiscard]] bool whole() const;  ///< whether its numbers are whole ones
};

/// All that a point of this planner's search has.
std::vector<Measure> measures_of(const PlannerInfo& info);

/// Reads one measure at one moment.
class MeasureReader {
 public:
  /// `state` is that of the log at the moment; both outlive the reader.
  MeasureReader(const LogView& view, const SearchState& state, const Measure& measure);
  /// Nothing where the point has no such number: an infinite cost, a key while it does not wait.
  [[nodiscard]] std::optional<double> read(const FirstTouch& touch) const;

 private:
  [[nodiscard]] std::optional<double> value(NodeId point) const;
  [[nodiscard]] std::optional<double> second(NodeId point) const;

  const LogView& view_;
  const SearchState& state_;
  const Measure& measure_;
  std::optional<Point> end_;  // that distances are measured to
};

}  // namespace replan
