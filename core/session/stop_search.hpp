// Several conditions looked for side by side along one log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/debug/probe.hpp"

namespace replan {

/// A position of the leading run's log at which an enabled breakpoint stops.
struct Hit {
  std::size_t position = 0;
  std::size_t breakpoint = 0;  ///< index
  friend auto operator<=>(const Hit&, const Hit&) = default;
};

/// A condition by its number in the list that it comes from.
struct NumberedCondition {
  std::size_t number = 0;
  Condition condition;
};

/// Goes along a log with a probe for each condition. The log may grow, but must not be cut, while it lives.
class StopSearch {
 public:
  StopSearch(const LogView& view, std::vector<NumberedCondition> conditions, std::size_t position,
             const Verdicts& verdicts, std::int64_t expansions_before);

  [[nodiscard]] std::size_t position() const { return position_; }
  /// Goes on to `end` and adds all hits on the way, ascending.
  void forwards(std::size_t end, const Verdicts& verdicts, std::vector<Hit>& hits);
  /// Goes back to `begin` or to the last hit that is not before it.
  std::optional<Hit> backwards(std::size_t begin, const Verdicts& verdicts);
  /// Events that it may go over at once, so that this takes some tenths of a millisecond.
  [[nodiscard]] std::size_t slice() const;

 private:
  struct Numbered {
    std::size_t number;
    Probe probe;
  };
  std::vector<Numbered> probes_;
  std::size_t position_;
};

}  // namespace replan
