// The unit in which lengths of paths are told to a user.
#pragma once

#include <algorithm>
#include <string>

#include "core/debug/event_words.hpp"

namespace replan {

/// Cells, or metres where the map says how large a cell is and its user wants it so. Costs of planners that sample or evolve
/// are lengths; a penalty for what is hit counts as a length, too.
struct LengthUnit {
  double metres = 0;  ///< of a cell; 0: lengths are told in cells

  [[nodiscard]] bool metric() const { return metres > 0; }
  /// As it is told, a number alone.
  [[nodiscard]] double of(double cells) const { return metric() ? cells * metres : cells; }
  /// "41.213", or "2.061 m"; of metres two decimals at least.
  [[nodiscard]] std::string text(double cells, int decimals = 3) const {
    return metric() ? decimal_text(of(cells), std::max(decimals, 2)) + " m" : decimal_text(cells, decimals);
  }
  [[nodiscard]] std::string text(Cost cost, int decimals = 3) const {
    return cost.is_infinite() ? cost_text(cost) : text(cost.to_double(), decimals);
  }
  /// "41.213 cells", or "2.061 m": in a sentence.
  [[nodiscard]] std::string in_words(double cells, int decimals = 3) const {
    return metric() ? text(cells, decimals) : text(cells, decimals) + " cells";
  }
  friend bool operator==(const LengthUnit&, const LengthUnit&) = default;
};

}  // namespace replan
