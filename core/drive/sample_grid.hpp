// The samples of a decision as a table, a row for each speed and a column for each turn rate.
#pragma once

#include <cstddef>
#include <optional>

#include "core/drive/dynamic_window.hpp"

namespace replan {

struct SampleGrid {
  /// Of a decision that these settings were for. Where only one speed is within reach there is one row.
  SampleGrid(const Explanation& why, const DriveSettings& settings);

  /// The sample in a row, counted from the slowest, and a column, counted from the lowest turn rate.
  [[nodiscard]] std::size_t sample(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] int row(std::size_t sample) const { return static_cast<int>(sample) / columns; }
  [[nodiscard]] int column(std::size_t sample) const { return static_cast<int>(sample) % columns; }
  /// The sample nearest to a motion; nothing if that lies outside the window by more than half of what samples are
  /// apart.
  [[nodiscard]] std::optional<std::size_t> nearest(const Explanation& why, const Twist& motion) const;

  int rows = 0, columns = 0;
  double row_step = 0, column_step = 0;  ///< m/s and rad/s between two of them
};

}  // namespace replan
